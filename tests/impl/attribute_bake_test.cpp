// impl/attribute/: large textures and large triangles against the specification, what is refused, errors and plans by
// hand.  Small textures are the laws' (proofs/attribute/bake/laws.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "impl/attribute/bake.hpp"
#include "impl/attribute/bake/codes.hpp"
#include "impl/attribute/bake/exact.hpp"
#include "impl/attribute/error.hpp"
#include "impl/attribute/plan.hpp"
#include "spec/attribute/bake.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace impl_attribute_bake_test {

namespace fast = mmverify::impl::attribute;
namespace slow = mmverify::spec::attribute;
using fast::Rgba;
using mmverify::spec::Rational;

/// A channel's number, as the specification has it.
template <class Channel>
Channel stored(Channel c) {
  return c;
}
slow::Binary32 stored(float c) { return {std::bit_cast<std::uint32_t>(c)}; }
template <class Channel>
using Stored = decltype(stored(Channel()));
template <class Channel>
std::uint32_t bits(Channel c) {
  if constexpr (std::is_same_v<Channel, float>)
    return std::bit_cast<std::uint32_t>(c);
  else
    return c;
}
std::uint32_t bits(slow::Binary32 c) { return c.bits; }

template <class Channel>
struct PictureOf {
  std::uint32_t width, height;
  std::vector<fast::RgbaOf<Channel>> texels;

  PictureOf(std::uint32_t w, std::uint32_t h, unsigned seed)
      : width(w), height(h), texels(std::size_t{w} * h) {
    std::mt19937 random(seed);
    for (auto& t : texels)
      for (Channel& c : t)
        if constexpr (std::is_same_v<Channel, float>)
          c = static_cast<float>(random() % 65536) / 64 - 256;
        else
          c = static_cast<Channel>(random());
  }
  fast::RgbaViewOf<Channel> view() const { return {texels.data()->data(), width, height, width}; }
  auto channel(std::size_t c, slow::Filter filter) const {
    slow::TextureOf<decltype(stored(Channel()))> t{width, height};
    for (const auto& texel : texels) t.alpha.push_back(stored(texel[c]));
    t.wrap_x = t.wrap_y = mmverify::spec::bake::Wrap::repeat;
    t.filter = filter;
    return t;
  }
};
using Picture = PictureOf<std::uint8_t>;
using Picture16 = PictureOf<std::uint16_t>;
using PictureFloat = PictureOf<float>;

slow::BaseTriangle<Rational> exact(const fast::BaseTriangle& uv) {
  const auto place = [](const fast::TexturePoint& p) {
    return mmverify::spec::bake::place<Rational>({std::bit_cast<std::uint32_t>(p.u)},
                                                 {std::bit_cast<std::uint32_t>(p.v)});
  };
  return {place(uv[0]), place(uv[1]), place(uv[2])};
}

template <class Channel>
std::vector<fast::RgbaOf<Channel>> faces(const fast::AttributeBakerOf<Channel>& baker,
                                         const fast::BaseTriangle& uv, std::uint32_t level,
                                         fast::AttributeCounts* counts = nullptr) {
  std::vector<fast::RgbaOf<Channel>> map(std::size_t{1} << 2 * level);
  const fast::AttributeCounts c = baker.faces(uv, level, map);
  if (counts != nullptr) *counts = c;
  return map;
}

template <class Channel>
void expect_faces(const PictureOf<Channel>& picture, const fast::BaseTriangle& uv, std::uint32_t level,
                  const std::vector<std::uint32_t>& at) {
  const fast::AttributeBakerOf<Channel> baker(picture.view());
  const auto map = faces(baker, uv, level);
  for (const std::uint32_t k : at)
    for (const std::size_t c : {std::size_t{0}, std::size_t{3}})
      EXPECT_EQ(bits(map[k][c]), bits(slow::Rounded<Stored<Channel>>::of(slow::face_value(
                                     picture.channel(c, slow::Filter::nearest), exact(uv), level, k))))
          << "face " << k << ", channel " << c;
}

TEST(ImplAttributeBake, ATriangleOverTheWholeOfALargePicture) {
  // The box does not leave the picture and is large: the sums of the whole picture.
  const fast::BaseTriangle uv{{{0.0625f, 0.0625f}, {0.9375f, 0.125f}, {0.125f, 0.9375f}}};
  expect_faces(Picture(300, 280, 1), uv, 3, {0, 21, 63});
  expect_faces(Picture16(300, 280, 1), uv, 3, {0, 21, 63});
  expect_faces(PictureFloat(300, 280, 1), uv, 3, {0, 21, 63});
}

TEST(ImplAttributeBake, ATriangleOverManyRepeats) {
  const fast::BaseTriangle uv{{{-40, -31.5f}, {12.25f, 3}, {-3, 25.5f}}};
  expect_faces(Picture(7, 5, 2), uv, 4, {0, 100, 255});
  expect_faces(Picture16(7, 5, 2), uv, 4, {0, 100, 255});
  expect_faces(PictureFloat(7, 5, 2), uv, 4, {0, 100, 255});
}

TEST(ImplAttributeBake, ThinTrianglesTakeWholeNumbers) {
  const Picture picture(4, 4, 3);
  const fast::BaseTriangle thin{{{0.125f, 0.125f}, {0.875f, 0.875f}, {0.5f, 0.50000006f}}};
  expect_faces(picture, thin, 1, {0, 1, 2, 3});
  // 2^-24 of a texel and below: no bound of binary64 is small enough.
  fast::AttributeCounts counts;
  faces(fast::AttributeBaker(picture.view()), {{{0.5f, 0.5f}, {0.5f, 0.75f}, {0.5f, 0.625f}}}, 2, &counts);
  EXPECT_EQ(counts.values, 16u);
  EXPECT_EQ(counts.exact, 16u);
}

template <class Channel>
void expect_few_whole_numbers(std::uint64_t few) {
  const PictureOf<Channel> picture(64, 64, 4);
  fast::AttributeCounts counts;
  const fast::AttributeBakerOf<Channel> baker(picture.view());
  const fast::BaseTriangle uv{{{0.1f, 0.2f}, {0.7f, 0.31f}, {0.33f, 0.87f}}};
  faces(baker, uv, 6, &counts);
  EXPECT_LT(counts.exact, few);
  std::vector<fast::RgbaOf<Channel>> map(65 * 66 / 2);
  EXPECT_LT(baker.vertices(uv, 6, map).exact, few);
}

TEST(ImplAttributeBake, FewValuesOfAnOrdinaryTriangleTakeWholeNumbers) {
  expect_few_whole_numbers<std::uint8_t>(5);
  expect_few_whole_numbers<std::uint16_t>(5);
  expect_few_whole_numbers<float>(50);  // signs differ, some means are nearly 0
}

template <class Channel>
void expect_exact_on_every_target(const fast::AttributeSamplingOf<Channel>& sampling) {
  const PictureOf<Channel> picture(64, 64, 7);
  const fast::BaseTriangle uv{{{0.1f, 0.2f}, {0.7f, 0.31f}, {0.33f, 0.87f}}};
  constexpr std::uint32_t level = 5, side = 1u << level;
  const fast::detail::Source<Channel> source(picture.view(), sampling);
  const fast::detail::Exact<Channel> exact(source, uv, level);
  std::vector<fast::RgbaOf<Channel>> right, right_vertices;
  for (std::uint32_t k = 0; k < side * side; ++k)
    right.push_back(exact.face(mmverify::impl::index::corners(k, level)));
  for (std::uint32_t r = 0; r <= side; ++r)
    for (std::uint32_t j = 0; j <= r; ++j) right_vertices.push_back(exact.vertex({r - j, j}));
  mmverify::tests::on_every_target([&] {
    const fast::AttributeBakerOf<Channel> baker(picture.view(), sampling);
    EXPECT_EQ(faces(baker, uv, level), right);
    std::vector<fast::RgbaOf<Channel>> map(right_vertices.size());
    baker.vertices(uv, level, map);
    EXPECT_EQ(map, right_vertices);
  });
}

TEST(ImplAttributeBake, EveryTargetGivesTheExactCodes) {
  using fast::Meaning;
  for (const Meaning meaning : {Meaning::linear, Meaning::srgb})
    expect_exact_on_every_target<std::uint8_t>({.meaning = meaning});
  for (const Meaning meaning : {Meaning::linear, Meaning::normal, Meaning::normal_and_length})
    expect_exact_on_every_target<std::uint16_t>({.meaning = meaning});
  expect_exact_on_every_target<float>({});
}

/// Vertices and the face of level 0 of a picture of 2x1 texels, in the middle of both.
std::pair<fast::RgbaFloat, fast::RgbaFloat> middles(const fast::RgbaFloat& a, const fast::RgbaFloat& b) {
  PictureFloat picture(2, 1, 0);
  picture.texels = {a, b};
  const fast::AttributeBakerFloat baker(picture.view());
  std::vector<fast::RgbaFloat> map(3);
  baker.vertices({{{0.5f, 0.5f}, {0.5f, 1.5f}, {0.5f, -4.5f}}}, 0, map);
  std::vector<fast::RgbaFloat> face(1);
  baker.faces({{{0.25f, 0}, {0.75f, 0}, {0.5f, 1}}}, 0, face);
  return {map[0], face[0]};
}

void expect_middle(float a, float b, float middle) {
  const auto [vertex, face] = middles({a, b, -a, 1}, {b, a, -b, 1});
  const float minus = middle == 0 && a == -b ? 0.0f : -middle;
  for (const auto& got : {vertex, face}) {
    EXPECT_EQ(bits(got[0]), bits(middle)) << a << " " << b;
    EXPECT_EQ(bits(got[1]), bits(middle)) << a << " " << b;
    EXPECT_EQ(bits(got[2]), bits(minus)) << a << " " << b;
    EXPECT_EQ(got[3], 1);
  }
}

TEST(ImplAttributeBakeFloats, TheMiddleOfTwoNumbersIsTheExactOneRoundedToEven) {
  constexpr float least = std::numeric_limits<float>::denorm_min(),
                  normal = std::numeric_limits<float>::min(), most = std::numeric_limits<float>::max();
  expect_middle(1, 3, 2);
  expect_middle(16777214, 16777215, 16777214);  // ties
  expect_middle(16777213, 16777214, 16777214);
  expect_middle(33554430, 33554432, 33554432);  // between two exponents
  expect_middle(1e30f, 1e-30f, 5e29f);
  expect_middle(1e30f, -1e30f, 0);
  expect_middle(most, most, most);
  expect_middle(most, -most, 0);
  expect_middle(most, least, most / 2);
  expect_middle(least, 0, 0);  // a tie of the least number
  expect_middle(3 * least, 0, 2 * least);
  expect_middle(3 * least, 2 * least, 2 * least);
  expect_middle(normal, normal - least, normal);
  expect_middle(normal, -least, normal / 2);
  expect_middle(0, 0, 0);
  expect_middle(-0.0f, -0.0f, 0);
}

TEST(ImplAttributeBakeFloats, RegionsOfOneTexelNeedNoWholeNumbers) {
  PictureFloat picture(32, 32, 0);
  for (std::uint32_t k = 0; k < 32 * 32; ++k)
    picture.texels[k] = k % 32 < 16 ? fast::RgbaFloat{0, -0.0f, 0.1f, 1} : fast::RgbaFloat{7e4f, 1, 3, 0};
  const fast::AttributeBakerFloat baker(picture.view());
  const auto map = faces(baker, {{{0.01f, 0.02f}, {0.97f, 0.03f}, {0.02f, 0.93f}}}, 4);
  EXPECT_EQ(map[0], (fast::RgbaFloat{0, 0, 0.1f, 1}));
  EXPECT_FALSE(std::signbit(map[0][1]));
  EXPECT_EQ(bits(map[0][2]), bits(0.1f));
}

TEST(ImplAttributeBakeFloats, ManyTexelsSumExactlyEnough) {
  // Rows of 2^12 texels, sums of which one number of binary64 would hold within thousands of its last places alone.
  PictureFloat picture(4096, 256, 0);
  std::mt19937 random(11);
  for (auto& t : picture.texels)
    for (float& c : t) c = std::ldexp(static_cast<float>(random() % 16777216), -24);
  fast::AttributeCounts counts;
  const fast::AttributeBakerFloat baker(picture.view());
  const fast::BaseTriangle uv{{{0.001f, 0.1f}, {0.993f, 0.2f}, {0.4f, 0.9f}}};
  faces(baker, uv, 6, &counts);
  EXPECT_LT(counts.exact, counts.values / 20);
  expect_faces(picture, uv, 6, {0, 1, 700, 4095});
}

TEST(ImplAttributeBakeFloats, RefusesWhatIsNotFiniteOrNotLinear) {
  PictureFloat picture(4, 4, 5);
  for (const fast::Meaning meaning :
       {fast::Meaning::srgb, fast::Meaning::normal, fast::Meaning::normal_and_length})
    EXPECT_THROW(fast::AttributeBakerFloat(picture.view(), {.meaning = meaning}), std::invalid_argument);
  EXPECT_THROW(fast::AttributeBakerFloat({nullptr, 0, 1, 0}), std::invalid_argument);
  for (const float no : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                         std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(fast::AttributeBakerFloat(picture.view(), {.border = {0, 0, no, 0}}), std::invalid_argument);
    PictureFloat other = picture;
    other.texels[15][3] = no;
    EXPECT_THROW(fast::AttributeBakerFloat(other.view()), std::invalid_argument);
    // A view of the first three columns does not reach that texel.
    EXPECT_NO_THROW(fast::AttributeBakerFloat({other.texels.data()->data(), 3, 4, 4}));
  }
}

// The middles themselves are what law attribute.srgb_table holds against the curve.
TEST(ImplAttributeBake, EveryHalfNumberHasTheCodeOfTheMiddlesBelowIt) {
  const auto& curve = fast::detail::Curve::srgb();
  std::size_t right = 0;
  std::uint64_t wrong = 0;
  for (std::int32_t twice = 0; twice <= 1 << 25; twice += sanitized ? 4'099 : 1) {
    while (right < 255 && curve.twice_least[right + 1] <= twice) ++right;
    const std::int32_t below = right == 0 ? 1 << 30 : twice - curve.twice_least[right],
                       above = curve.twice_least[right + 1] - twice;
    for (const double bound : {0.25, 3.0, curve.most_off}) {
      bool sure = true;
      const std::uint8_t code = curve.code(0.5 * twice, bound, sure);
      wrong += code != right || sure != (0.5 * std::min(below, above) >= bound) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_EQ(right, 255u);
  // Means may be beyond what numbers there are by as much as they may be off.
  bool sure = true;
  EXPECT_EQ(curve.code(-curve.most_off, curve.most_off, sure), 0);
  EXPECT_EQ(curve.code(curve.full + curve.most_off, curve.most_off, sure), 255);
  EXPECT_TRUE(sure);
}

TEST(ImplAttributeBake, RefusesWhatItCannotBake) {
  const Picture picture(4, 4, 5);
  const fast::AttributeBaker baker(picture.view());
  std::vector<Rgba> map(16);
  const fast::BaseTriangle uv{{{0, 0}, {1, 0}, {0, 1}}};
  EXPECT_THROW(baker.faces(uv, 1, map), std::invalid_argument);
  EXPECT_THROW(baker.vertices(uv, 2, map), std::invalid_argument);
  EXPECT_THROW(baker.faces(uv, 13, map), std::invalid_argument);
  EXPECT_THROW(baker.faces({{{0, 0}, {0x1p20f, 0}, {0, 1}}}, 2, map), std::invalid_argument);
  EXPECT_THROW(baker.faces({{{0, 0}, {1, std::numeric_limits<float>::quiet_NaN()}, {0, 1}}}, 2, map),
               std::invalid_argument);
  EXPECT_THROW(baker.faces({{{0, 0}, {10'000, 0}, {0, 1}}}, 2, map), std::invalid_argument);  // 40,000 texels
  EXPECT_THROW(baker.faces({{{0, 0}, {2'000, 0}, {0, 2'000}}}, 2, map), std::invalid_argument);  // 64 million
  EXPECT_THROW(fast::AttributeBaker({nullptr, 0, 1, 0}), std::invalid_argument);
  EXPECT_THROW(fast::AttributeBaker({nullptr, 16385, 1, 16385}), std::invalid_argument);
  const Picture16 picture16(4, 4, 5);
  EXPECT_THROW(fast::AttributeBaker16({nullptr, 0, 1, 0}), std::invalid_argument);
  EXPECT_THROW(fast::AttributeBaker16(picture16.view(), {.meaning = fast::Meaning::srgb}),
               std::invalid_argument);
  std::vector<fast::Rgba16> map16(15);
  EXPECT_THROW(fast::AttributeBaker16(picture16.view()).faces(uv, 2, map16), std::invalid_argument);
}

TEST(ImplAttributeBake, APitchSkipsWhatIsBetweenRows) {
  const Picture picture(8, 4, 6);
  const fast::RgbaView left{picture.texels.data()->data(), 4, 4, 8};
  Picture copied(4, 4, 0);
  for (std::uint32_t y = 0; y < 4; ++y)
    for (std::uint32_t x = 0; x < 4; ++x) copied.texels[x + 4 * y] = picture.texels[x + 8 * y];
  const fast::BaseTriangle uv{{{-0.3f, 0.1f}, {1.2f, 0.4f}, {0.6f, 1.1f}}};
  EXPECT_EQ(faces(fast::AttributeBaker(left), uv, 3), faces(fast::AttributeBaker(copied.view()), uv, 3));
}

TEST(ImplAttributeError, OfTheSaddle) {
  Picture picture(2, 2, 0);
  picture.texels = {{255, 255, 255, 255}, {0, 0, 0, 0}, {0, 0, 0, 0}, {255, 255, 255, 255}};
  const fast::BaseTriangle uv{{{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}}};
  const std::vector<Rgba> map{
      {255, 255, 255, 255}, {0, 0, 0, 0}, {0, 0, 0, 0}};  // rows from the first vertex
  const auto error = fast::map_error(picture.view(), {}, uv, 0, fast::MapForm::vertices, map);
  EXPECT_NEAR(error.largest[0], 0.5, 1e-6);
  EXPECT_NEAR(error.square[3], 2.0 / 45, 1e-6);
  EXPECT_THROW(fast::map_error(picture.view(), {}, uv, 1, fast::MapForm::vertices, map),
               std::invalid_argument);
}

TEST(ImplAttributeError, DecimatedEdgesAreMeansOfTheirEvenVertices) {
  // Level 1, rows from w: (0,0); (1,0) (0,1); (2,0) (1,1) (0,2).
  std::vector<Rgba> map{{0, 0, 0, 0},     {9, 9, 9, 9}, {9, 9, 9, 9},
                        {10, 10, 10, 10}, {9, 9, 9, 9}, {21, 21, 21, 21}};
  fast::decimate_edges(1, 0b011, fast::Meaning::linear, map);
  EXPECT_EQ(map[1][0], 5);   // w-u
  EXPECT_EQ(map[4][0], 16);  // u-v: 15.5, half up
  EXPECT_EQ(map[2][0], 9);
  fast::decimate_edges(1, 0b100, fast::Meaning::srgb, map);
  EXPECT_EQ(map[2][3], 11);  // v-w, alpha linear: 10.5
  EXPECT_EQ(map[2][0], 12);  // light of 21 is 0.007499; half of it lies at code 12.21
  EXPECT_THROW(fast::decimate_edges(0, 1, fast::Meaning::linear, map), std::invalid_argument);
  EXPECT_THROW(fast::decimate_edges(2, 1, fast::Meaning::linear, map), std::invalid_argument);
}

TEST(ImplAttributePlan, NeighboursShareTwoVertices) {
  const std::vector<std::array<std::uint32_t, 3>> triangles{
      {0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {3, 2, 5}, {7, 7, 8}};
  const auto found = fast::neighbours_of(triangles);
  EXPECT_EQ(found[0], (fast::Neighbours{-1, 1, -1}));
  EXPECT_EQ(found[1], (fast::Neighbours{0, -1, -1}));  // edge 2-3 has three triangles
  EXPECT_EQ(found[2], (fast::Neighbours{-1, -1, -1}));
  EXPECT_EQ(found[4], (fast::Neighbours{-1, -1, -1}));
}

TEST(ImplAttributePlan, RefusesWhatIsNoMesh) {
  fast::PlanRequest request;
  const std::vector<fast::Neighbours> one_sided{{1, -1, -1}, {-1, -1, -1}}, missing{{5, -1, -1}};
  request.neighbours = missing;
  EXPECT_THROW(fast::plan(request), std::invalid_argument);  // nothing to keep
  request.keeps = [](std::size_t, std::uint32_t, std::uint8_t) { return true; };
  EXPECT_THROW(fast::plan(request), std::invalid_argument);
  request.neighbours = one_sided;
  EXPECT_THROW(fast::plan(request), std::invalid_argument);
  request.neighbours = {};
  EXPECT_TRUE(fast::plan(request).empty());
  request.highest = 13;
  EXPECT_THROW(fast::plan(request), std::invalid_argument);
}

TEST(ImplAttributePlan, EqualMapsAreStoredOnce) {
  fast::Shared shared;
  const std::vector<std::uint8_t> a{1, 2, 3}, b{1, 2};
  EXPECT_EQ(shared.add(a), 0u);
  EXPECT_EQ(shared.add(b), 1u);
  EXPECT_EQ(shared.add(a), 0u);
  EXPECT_EQ(shared.size(), 2u);
  EXPECT_EQ(shared.bytes(), 5u);
}

}  // namespace impl_attribute_bake_test
