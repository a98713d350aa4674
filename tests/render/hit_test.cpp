// render/: what is asked at one hit, without rays: barycentrics, the texture's answer, square maps' places.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "display/render/barycentrics.hpp"
#include "display/render/opacity.hpp"
#include "display/render/surface.hpp"
#include "impl/bake/triangles.hpp"
#include "impl/index/index.hpp"
#include "impl/micromap/append.hpp"

namespace {

using namespace mmverify::render;
using namespace mmverify::impl;
using Rational = boost::multiprecision::cpp_rational;

/// Floats near what rounding spoils: ends, grid lines, their neighbours, tiny ones, and any.
std::vector<float> stiff_floats() {
  std::vector<float> all{0, 1, 0x1p-149f, 0x1p-126f, 0x1p-60f, 0x1p-30f, 0x1p-29f, 0x1p-24f, 1 - 0x1p-24f};
  for (int k = 1; k < 32; ++k) {
    const float x = static_cast<float>(k) / 32;
    for (const float y : {x, std::nextafter(x, 0.0f), std::nextafter(x, 1.0f)}) all.push_back(y);
  }
  std::mt19937 engine(7);
  for (int k = 0; k < 60; ++k) all.push_back(static_cast<float>(engine() >> 8) * 0x1p-24f);
  return all;
}

TEST(Barycentrics, ArePutBackIntoTheTriangleAndThoseInsideStay) {
  for (const float u : stiff_floats())
    for (const float v : stiff_floats()) {
      const Barycentrics b = in_triangle(u, v);
      const bool inside = Rational(u) + Rational(v) <= 1;
      EXPECT_LE(Rational(b.u) + Rational(b.v), 1) << u << " " << v;
      EXPECT_EQ(b.v, v);
      if (inside) {
        EXPECT_EQ(b.u, u) << v;
      } else {
        EXPECT_GT(Rational(std::nextafter(b.u, 2.0f)) + Rational(v), 1) << "the greatest: " << u << " " << v;
      }
    }
  EXPECT_EQ(in_triangle(-0.5f, 2), (Barycentrics{0, 1}));
  EXPECT_EQ(in_triangle(std::nanf(""), 0.5f), (Barycentrics{0, 0.5f}));
}

TEST(Barycentrics, AreInTheRegionThatRationalsSay) {
  for (const float u : stiff_floats())
    for (const float v : stiff_floats()) {
      if (Rational(u) + Rational(v) > 1) continue;
      const Rational of[3] = {Rational(1 - Rational(u) - Rational(v)), Rational(u), Rational(v)};
      for (unsigned number = 0; number < 3; ++number)
        for (const unsigned level : {4u, 5u}) {
          const std::uint32_t N = 1u << level;
          const Rational scaled = of[number] * N;
          const auto floor = static_cast<std::uint32_t>(numerator(scaled) / denominator(scaled));
          const std::uint32_t ceil = floor + (Rational(floor) < scaled ? 1 : 0);
          const GridPlace place = grid_place({u, v}, number, level);
          EXPECT_EQ(place.floor, std::min(floor, N - 1)) << u << " " << v << " " << number;
          EXPECT_EQ(place.below, ceil == 0 ? 0 : ceil - 1) << u << " " << v << " " << number;
        }
    }
}

/// 4 x 4 texels that differ.
struct Texture {
  std::vector<std::uint8_t> alpha{0, 40, 200, 255, 120, 130, 90, 10, 255, 128, 127, 60, 5, 250, 140, 100};
  bake::Texels texels() const { return bake::TexelView<std::uint8_t>{alpha.data(), 4, 4, 4}; }
  int at(int x, int y) const {
    return alpha[static_cast<std::size_t>(std::clamp(x, 0, 3) + 4 * std::clamp(y, 0, 3))];
  }
};

TEST(Surface, AnswersAsWholeNumbersDoWhereAllIsDyadic) {
  const Texture texture;
  bake::Sampling sampling;
  sampling.u = sampling.v = bake::Wrap::clamp_to_edge;
  const Surface linear(texture.texels(), sampling, bake::Cutoff{1, 2});
  sampling.filter = bake::Filter::nearest;
  const Surface nearest(texture.texels(), sampling, bake::Cutoff{1, 2});
  const bake::BaseTriangle uv{{{0, 0}, {1, 0}, {0, 1}}};
  // (u, v) = (i, j) / 64 is (i, j) / 16 texels, grid lines of texels and of centres among them.
  int opaque = 0;
  for (int i = 0; i <= 64; ++i)
    for (int j = 0; i + j <= 64; ++j) {
      const Barycentrics b{static_cast<float>(i) / 64, static_cast<float>(j) / 64};
      EXPECT_EQ(nearest.opaque(uv, b, 0.5f), 2 * texture.at(i / 16, j / 16) >= 255) << i << " " << j;
      const int x = i - 8, y = j - 8, kx = x >= 0 ? x / 16 : -1, ky = y >= 0 ? y / 16 : -1, fx = x - 16 * kx,
                fy = y - 16 * ky;
      const int value = (texture.at(kx, ky) * (16 - fx) + texture.at(kx + 1, ky) * fx) * (16 - fy) +
                        (texture.at(kx, ky + 1) * (16 - fx) + texture.at(kx + 1, ky + 1) * fx) * fy;
      EXPECT_EQ(linear.opaque(uv, b, 0.5f), 2 * value >= 255 * 256) << i << " " << j;
      opaque += 2 * value >= 255 * 256;
    }
  EXPECT_GT(opaque, 200);
  EXPECT_EQ(linear.fetches(), 4u);
  EXPECT_EQ(nearest.fetches(), 1u);
}

TEST(Surface, TiesWithTheCutoffAreOpaqueThroughFactors) {
  // 0.8 x 0.625 is one half: of 8 bits none is 0.625 exactly, of 16 bits neither; so texels tie by quotients.
  const std::vector<std::uint8_t> alpha{51, 50};
  bake::Sampling sampling;
  sampling.u = sampling.v = bake::Wrap::clamp_to_edge;
  const Surface surface(bake::TexelView<std::uint8_t>{alpha.data(), 2, 1, 2}, sampling, bake::Cutoff{1, 5});
  const bake::BaseTriangle at_left{{{0, 0}, {0.25f, 0}, {0, 1}}}, past{{{0.25f, 0}, {0.26f, 0}, {0.25f, 1}}};
  EXPECT_TRUE(surface.opaque(at_left, {1, 0}, 0.5f));  // on the centre of 51
  EXPECT_TRUE(surface.opaque(past, {0, 0}, 0.5f));
  EXPECT_FALSE(surface.opaque(past, {0x1p-149f, 0}, 0.5f));  // no double knows the difference
}

TEST(Surface, BlendIsNeverAtNoneAndAlwaysAtOne) {
  const std::vector<std::uint8_t> alpha{0, 255};
  bake::Sampling sampling;
  sampling.u = sampling.v = bake::Wrap::clamp_to_edge;
  const Surface surface(bake::TexelView<std::uint8_t>{alpha.data(), 2, 1, 2}, sampling, bake::Blend{});
  const bake::BaseTriangle uv{{{0, 0}, {1, 0}, {0, 1}}};
  for (const float chance : {0x1p-25f, 0.5f, 1 - 0x1p-24f}) {
    EXPECT_FALSE(surface.opaque(uv, {0.25f, 0}, chance));
    EXPECT_TRUE(surface.opaque(uv, {0.75f, 0}, chance));
  }
  EXPECT_TRUE(surface.opaque(uv, {0.5f, 0}, 0.49f));
  EXPECT_FALSE(surface.opaque(uv, {0.5f, 0}, 0.51f));
}

TEST(Surface, OfFloatsIsRefused) {
  const std::vector<float> alpha{0.5f};
  EXPECT_THROW(Surface(bake::TexelView<float>{alpha.data(), 1, 1, 1}, {}, bake::Mask{}),
               std::invalid_argument);
}

/// One geometry of one triangle, with a map that is not uniform.
struct OneMap {
  Micromaps micromaps;
  std::vector<micromap::State> states;
  OneMap() {
    for (unsigned k = 0; k < 64; ++k) states.push_back(static_cast<micromap::State>(k * k % 7 % 4));
    std::vector<std::uint8_t> packed(16);
    micromap::pack(states, micromap::Format::four_state, packed);
    const micromap::PackedMap map{3, micromap::Format::four_state, packed};
    const auto built = micromap::append(micromaps.array, std::span(&map, 1), {});
    micromaps.codes = {{0}, {}, {micromap::special_code(micromap::State::UO, micromap::Encoding::u32)}};
  }
};

TEST(Opacity, OfAllFormsAnswersAsTheStates) {
  const OneMap one;
  for (const Method method : {Method::flat, Method::tree, Method::ranked, Method::special}) {
    const auto opacity = opacity_of(method, one.micromaps);
    for (const float u : stiff_floats())
      for (const float v : stiff_floats()) {
        const Barycentrics b = in_triangle(u, v);
        const auto got = opacity->at(0, 0, b);
        if (method == Method::special) {
          EXPECT_FALSE(got);
        } else {
          EXPECT_EQ(got, one.states[index::from_barycentrics(b.u, b.v, 3)]) << name_of(method);
        }
      }
    EXPECT_EQ(opacity->at(1, 0, {0, 0}), std::nullopt) << "a geometry without micromaps";
    EXPECT_EQ(opacity->at(2, 0, {0, 0}), micromap::State::UO);
  }
  EXPECT_EQ(opacity_of(Method::flat, one.micromaps)->bytes(), 16u + 8 + 2 * 4);
  EXPECT_EQ(opacity_of(Method::special, one.micromaps)->bytes(), 2u * 4);
  EXPECT_THROW(opacity_of(Method::vq2, one.micromaps), std::invalid_argument);
  EXPECT_THROW(opacity_of(Method::texture, Squares{}), std::invalid_argument);
}

TEST(Opacity, OfSquareMapsReadsTheRegionOfEachVertexOrder) {
  // T in the lower left quarter, O in the upper right one, C between.
  Squares squares;
  auto& map = squares.vq2.emplace_back();
  for (std::uint32_t k = 0; k < 256; ++k) {
    const bool right = k % 16 >= 8, up = k / 16 >= 8;
    map[k] = right && up ? vq::State::O : right || up ? vq::State::C : vq::State::T;
  }
  squares.places = {{}};
  for (const std::array<std::uint8_t, 3>& order :
       {std::array<std::uint8_t, 3>{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}})
    for (const vq::Half half : {vq::Half::lower, vq::Half::upper})
      squares.places[0].push_back({0, half, order});
  squares.places[0].push_back({});
  const auto opacity = opacity_of(Method::vq2, squares);
  // Deep in the corner of the half's first vertex: (0,0) of the lower one, (1,1) of the upper one.
  for (std::uint32_t k = 0; k < 12; ++k) {
    const auto first = squares.places[0][k].order[0];
    const Barycentrics b{first == 1 ? 0.9f : 0.05f, first == 2 ? 0.9f : 0.05f};
    EXPECT_EQ(opacity->at(0, k, b), k % 2 == 0 ? micromap::State::T : micromap::State::O) << k;
    const auto second = squares.places[0][k].order[1];
    EXPECT_EQ(opacity->at(0, k, {second == 1 ? 0.9f : 0.05f, second == 2 ? 0.9f : 0.05f}),
              micromap::State::UT)
        << k;
  }
  EXPECT_EQ(opacity->at(0, 12, {0.1f, 0.1f}), std::nullopt) << "a triangle in no pair";
  EXPECT_EQ(opacity->bytes(), 32u + 4 * 13);
}

}  // namespace
