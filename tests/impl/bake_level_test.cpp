// The highest useful level, beside its definition in rationals.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "impl/bake/level.hpp"
#include "spec/rational.hpp"

namespace impl_bake_level_test {

using namespace mmverify::impl::bake;
using mmverify::spec::Rational;

constexpr float greatest = std::numeric_limits<float>::max();
constexpr float least = std::numeric_limits<float>::denorm_min();

float up(float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }
float down(float x) { return std::nextafter(x, -std::numeric_limits<float>::infinity()); }

Rational exactly(double x) {
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
  Rational value(static_cast<std::int64_t>(mantissa));
  for (exponent -= 53; exponent > 0; --exponent) value *= 2;
  for (; exponent < 0; ++exponent) value /= 2;
  return value;
}

/// The definition, in rationals.
UsefulLevel useful_level_by_definition(const BaseTriangle& uvs, std::uint32_t width, std::uint32_t height,
                                       unsigned limit) {
  Rational longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const TexturePoint &a = uvs[k], &b = uvs[(k + 1) % 3];
    const Rational x = (exactly(b.u) - exactly(a.u)) * width, y = (exactly(b.v) - exactly(a.v)) * height;
    longest = std::max<Rational>(longest, x * x + y * y);
  }
  Rational power = 1;
  for (unsigned n = 0;; ++n, power *= 4) {
    if (power >= longest) return {n, false};
    if (n == std::min(limit, 12u)) return {n, true};
  }
}

UsefulLevel level_of(const BaseTriangle& uvs, std::uint32_t width, std::uint32_t height,
                     unsigned limit = 12) {
  const UsefulLevel level = useful_level(uvs, width, height, limit);
  EXPECT_EQ(level, useful_level_by_definition(uvs, width, height, limit));
  return level;
}

/// docs/ERRATA.md: edges of 3, 4 and 5 texels.
TEST(ImplBakeLevel, TheTwoSidesOfEquationOneDisagree) {
  const BaseTriangle triangle{TexturePoint{0, 0}, TexturePoint{3.0f / 16, 0}, TexturePoint{0, 0.25f}};
  EXPECT_EQ(level_of(triangle, 16, 16).level, 3u);  // 5 <= 2^3, the smallest
  EXPECT_EQ(std::floor(std::log2(5.0)), 2.0);       // 2^2 <= 5, the largest
  // The longest edge a power of two: both say the same.
  EXPECT_EQ(level_of({TexturePoint{0, 0}, TexturePoint{0.25f, 0}, TexturePoint{0.125f, 0}}, 16, 16).level,
            2u);
}

TEST(ImplBakeLevel, TheHighest) {
  // Edges of 1, 1 and sqrt 2 texels; of 2^n, and one float more.
  EXPECT_EQ(level_of({{{0, 0}, {1, 0}, {0, 1}}}, 1, 1), (UsefulLevel{1, false}));
  EXPECT_EQ(level_of({{{0, 0}, {1, 0}, {0.5f, 0}}}, 1, 1), (UsefulLevel{0, false}));
  for (unsigned n = 1; n <= 12; ++n) {
    const auto width = 1u << n;
    EXPECT_EQ(level_of({{{0, 0}, {1, 0}, {0, 0}}}, width, 7), (UsefulLevel{n, false}));
    EXPECT_EQ(level_of({{{0, 0}, {down(1), 0}, {0, 0}}}, width, 7), (UsefulLevel{n, false}));
    EXPECT_EQ(level_of({{{0, 0}, {up(1), 0}, {0, 0}}}, width, 7),
              (UsefulLevel{std::min(n + 1, 12u), n == 12}));
  }
  // 3-4-5: exactly 5 x 2^k texels along the third edge, with roundings in no place but the comparison.
  EXPECT_EQ(level_of({{{0, 0}, {0.75f, 0}, {0, 1}}}, 4, 4), (UsefulLevel{3, false}));
  // 1 + 2^-298 > 1: far beyond a double's reach.
  EXPECT_EQ(level_of({{{0, 0}, {1, least}, {0, 0}}}, 1, 1), (UsefulLevel{1, false}));
  EXPECT_EQ(level_of({{{0, 0}, {1, 0}, {0, least}}}, 1, 1), (UsefulLevel{1, false}));
  // Neighbours at 2^24 are two apart; far away, the greatest floats.
  EXPECT_EQ(level_of({{{0x1p24f, 0}, {up(0x1p24f), 0}, {0x1p24f, 0}}}, 1, 1), (UsefulLevel{1, false}));
  EXPECT_EQ(level_of({{{greatest, 0}, {greatest, 0}, {greatest, 0}}}, 16384, 16384), (UsefulLevel{0, false}));
  EXPECT_EQ(level_of({{{greatest, 0}, {-greatest, 0}, {0, greatest}}}, 16384, 16384),
            (UsefulLevel{12, true}));
  // The device's limit, and no device's beyond ours.
  EXPECT_EQ(level_of({{{0, 0}, {1, 0}, {0, 1}}}, 1024, 1024, 9), (UsefulLevel{9, true}));
  EXPECT_EQ(level_of({{{0, 0}, {0.5f, 0}, {0.5f, 0}}}, 1024, 1024, 9), (UsefulLevel{9, false}));
  EXPECT_EQ(level_of({{{0, 0}, {1, 0}, {0, 1}}}, 16384, 16384, 15), (UsefulLevel{12, true}));
  EXPECT_EQ(level_of({{{0, 0}, {1, 0}, {0, 1}}}, 16, 16, 0), (UsefulLevel{0, true}));
}

TEST(ImplBakeLevel, TheHighestOfRandomTriangles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uv(-2, 3);
  std::uniform_int_distribution<std::uint32_t> side(1, 16384);
  const auto near_a_power = [&](std::uint32_t width) {
    const float edge = std::ldexp(1.0f, static_cast<int>(random() % 13)) / static_cast<float>(width);
    return random() % 3 == 0 ? up(edge) : random() % 2 == 0 ? down(edge) : edge;
  };
  for (int k = 0; k < 500; ++k) {
    const std::uint32_t width = side(random), height = side(random);
    level_of({{{uv(random), uv(random)}, {uv(random), uv(random)}, {uv(random), uv(random)}}}, width, height);
    const float u = near_a_power(width);
    level_of({{{0, 0}, {u, random() % 2 == 0 ? 0 : least}, {0, near_a_power(height) / 8192}}}, width, height);
  }
}

TEST(ImplBakeLevel, TheHighestWhereDoublesRound) {
  // Edges of 2^n texels but for the last bits of a double, along neither axis.
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0.25f, 0.75f), tiny(0, 0x1p-26f);
  std::map<unsigned, int> levels;
  for (int k = 0; k < 3000; ++k) {
    const TexturePoint a{tiny(random), tiny(random)};
    const float u = unit(random);
    const long double x = static_cast<long double>(u) - a.u, y = std::sqrt(1 - x * x);
    const auto v = static_cast<float>(y);
    const TexturePoint b{u, v}, close{a.u, static_cast<float>(static_cast<long double>(v) - y)};
    levels[level_of({close, b, b}, 1, 1).level]++;
  }
  EXPECT_GT(levels[0], 1000);
  EXPECT_GT(levels[1], 1000);
}

}  // namespace impl_bake_level_test
