// impl/attribute/: large textures and large triangles against the specification, what is refused, errors and plans by
// hand.  Small textures are the laws' (proofs/attribute/bake/laws.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "impl/attribute/bake.hpp"
#include "impl/attribute/bake/codes.hpp"
#include "impl/attribute/bake/exact.hpp"
#include "impl/attribute/error.hpp"
#include "impl/attribute/plan.hpp"
#include "spec/attribute/bake.hpp"
#include "tests/every_target.hpp"

namespace {

namespace fast = mmverify::impl::attribute;
namespace slow = mmverify::spec::attribute;
using fast::Rgba;
using mmverify::spec::Rational;

struct Picture {
  std::uint32_t width, height;
  std::vector<Rgba> texels;

  Picture(std::uint32_t w, std::uint32_t h, unsigned seed) : width(w), height(h), texels(std::size_t{w} * h) {
    std::mt19937 random(seed);
    for (Rgba& t : texels)
      for (std::uint8_t& c : t) c = static_cast<std::uint8_t>(random());
  }
  fast::RgbaView view() const { return {texels.data()->data(), width, height, width}; }
  slow::TextureOf<std::uint8_t> channel(std::size_t c, slow::Filter filter) const {
    slow::TextureOf<std::uint8_t> t{width, height};
    for (const Rgba& texel : texels) t.alpha.push_back(texel[c]);
    t.wrap_x = t.wrap_y = mmverify::spec::bake::Wrap::repeat;
    t.filter = filter;
    return t;
  }
};

slow::BaseTriangle<Rational> exact(const fast::BaseTriangle& uv) {
  const auto place = [](const fast::TexturePoint& p) {
    return mmverify::spec::bake::place<Rational>({std::bit_cast<std::uint32_t>(p.u)},
                                                 {std::bit_cast<std::uint32_t>(p.v)});
  };
  return {place(uv[0]), place(uv[1]), place(uv[2])};
}

std::vector<Rgba> faces(const fast::AttributeBaker& baker, const fast::BaseTriangle& uv, std::uint32_t level,
                        fast::AttributeCounts* counts = nullptr) {
  std::vector<Rgba> map(std::size_t{1} << 2 * level);
  const fast::AttributeCounts c = baker.faces(uv, level, map);
  if (counts != nullptr) *counts = c;
  return map;
}

void expect_faces(const Picture& picture, const fast::BaseTriangle& uv, std::uint32_t level,
                  const std::vector<std::uint32_t>& at) {
  const fast::AttributeBaker baker(picture.view());
  const auto map = faces(baker, uv, level);
  for (const std::uint32_t k : at)
    for (const std::size_t c : {std::size_t{0}, std::size_t{3}})
      EXPECT_EQ(map[k][c], slow::Rounded<std::uint8_t>::of(slow::face_value(
                               picture.channel(c, slow::Filter::nearest), exact(uv), level, k)))
          << "face " << k << ", channel " << c;
}

TEST(ImplAttributeBake, ATriangleOverTheWholeOfALargePicture) {
  // The box does not leave the picture and is large: the sums of the whole picture.
  expect_faces(Picture(300, 280, 1), {{{0.0625f, 0.0625f}, {0.9375f, 0.125f}, {0.125f, 0.9375f}}}, 3,
               {0, 21, 63});
}

TEST(ImplAttributeBake, ATriangleOverManyRepeats) {
  expect_faces(Picture(7, 5, 2), {{{-40, -31.5f}, {12.25f, 3}, {-3, 25.5f}}}, 4, {0, 100, 255});
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

TEST(ImplAttributeBake, FewValuesOfAnOrdinaryTriangleTakeWholeNumbers) {
  const Picture picture(64, 64, 4);
  fast::AttributeCounts counts;
  const fast::AttributeBaker baker(picture.view());
  const fast::BaseTriangle uv{{{0.1f, 0.2f}, {0.7f, 0.31f}, {0.33f, 0.87f}}};
  faces(baker, uv, 6, &counts);
  EXPECT_LT(counts.exact, 5u);
  std::vector<Rgba> map(65 * 66 / 2);
  EXPECT_LT(baker.vertices(uv, 6, map).exact, 5u);
}

TEST(ImplAttributeBake, EveryTargetGivesTheExactCodes) {
  const Picture picture(64, 64, 7);
  const fast::BaseTriangle uv{{{0.1f, 0.2f}, {0.7f, 0.31f}, {0.33f, 0.87f}}};
  constexpr std::uint32_t level = 5, side = 1u << level;
  for (const fast::Meaning meaning : {fast::Meaning::linear, fast::Meaning::srgb}) {
    const fast::AttributeSampling sampling{.meaning = meaning};
    const fast::detail::Source source(picture.view(), sampling);
    const fast::detail::Exact exact(source, uv, level);
    std::vector<Rgba> right, right_vertices;
    for (std::uint32_t k = 0; k < side * side; ++k)
      right.push_back(exact.face(mmverify::impl::index::corners(k, level)));
    for (std::uint32_t r = 0; r <= side; ++r)
      for (std::uint32_t j = 0; j <= r; ++j) right_vertices.push_back(exact.vertex({r - j, j}));
    mmverify::tests::on_every_target([&] {
      const fast::AttributeBaker baker(picture.view(), sampling);
      EXPECT_EQ(faces(baker, uv, level), right);
      std::vector<Rgba> map(right_vertices.size());
      baker.vertices(uv, level, map);
      EXPECT_EQ(map, right_vertices);
    });
  }
}

// The middles themselves are what law attribute.srgb_table holds against the curve.
TEST(ImplAttributeBake, EveryHalfNumberHasTheCodeOfTheMiddlesBelowIt) {
  const auto& curve = fast::detail::Curve::srgb();
  std::size_t right = 0;
  std::uint64_t wrong = 0;
  for (std::int32_t twice = 0; twice <= 1 << 25; ++twice) {
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

}  // namespace
