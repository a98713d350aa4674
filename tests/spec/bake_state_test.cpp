// [release] spec/bake/texture.hpp, spec/bake/state.hpp and nearest filtering: by hand, and against points.
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <vector>

#include "spec/bake/state.hpp"

namespace spec_bake_state_test {

namespace bake = mmverify::spec::bake;
using bake::Binary32, bake::Filter, bake::Texture, bake::TextureOf, bake::Wrap;
using mmverify::spec::Rational;
using mmverify::spec::Rational128;
using Micro = mmverify::spec::micromap::State;
using TexturePoint = bake::TexturePoint<Rational>;
using Polygon = bake::Polygon<Rational>;
using Base = bake::BaseTriangle<Rational>;
using Mask = bake::Mask<Rational>;
using Blend = bake::Blend<Rational>;

Rational q(int numerator, int denominator = 1) { return bake::fraction<Rational>(numerator, denominator); }
const Rational half = q(1, 2);
const Mask at_half{half};

TEST(SpecBakeTexture, StoredNumbersAreExact) {
  EXPECT_EQ(bake::number<Rational>(std::uint8_t{51}), q(1, 5));
  EXPECT_EQ(bake::number<Rational>(std::uint16_t{13107}), q(1, 5));
  EXPECT_EQ(bake::number<Rational>(std::uint16_t{65535}), 1);
  EXPECT_EQ(bake::number<Rational>(Binary32{0x3f800000}), 1);
  EXPECT_EQ(bake::number<Rational>(Binary32{0xbfc00000}), q(-3, 2));
  EXPECT_EQ(bake::number<Rational>(Binary32{0x80000000}), 0);
  EXPECT_EQ(bake::number<Rational>(Binary32{0x3dcccccd}), q(13421773, 134217728));  // 0.1f
  EXPECT_EQ(bake::number<Rational>(Binary32{0x4b000001}), 8388609);
  using mmverify::spec::Integer;
  EXPECT_EQ(bake::number<Rational>(Binary32{1}), Rational(1, Integer(1) << 149));
  EXPECT_EQ(bake::number<Rational>(Binary32{0x7f7fffff}), Rational(Integer(0xffffff) << 104));
  EXPECT_EQ(bake::number<Rational128>(Binary32{0x3f000000}), bake::fraction<Rational128>(1, 2));
  EXPECT_THROW(bake::number<Rational128>(Binary32{1}), std::overflow_error);
  for (const std::uint32_t bits : {0x7f800000u, 0xff800000u, 0x7fc00000u})
    EXPECT_THROW(bake::number<Rational>(Binary32{bits}), std::invalid_argument);
}

TEST(SpecBakeTexture, TheFactorMultipliesWhatIsSampledTheBorderToo) {
  Texture t{1, 1, {255}, Wrap::clamp_to_border, Wrap::clamp_to_border, 51, {0x3f000000}};
  EXPECT_EQ(bake::alpha(t, TexturePoint{half, half}), half);
  EXPECT_EQ(bake::alpha(t, TexturePoint{7, 7}), q(1, 10));
  t.vertex_factor = {0x3e800000};
  EXPECT_EQ(bake::alpha(t, TexturePoint{7, 7}), q(1, 40));
  const TextureOf<std::uint16_t> words{2, 1, {0, 65535}};
  EXPECT_EQ(bake::alpha(words, TexturePoint{1, half}), half);
  const TextureOf<Binary32> floats{2, 1, {{0x3f800000}, {0xc0000000}}};  // 1, -2
  EXPECT_EQ(bake::alpha(floats, TexturePoint{1, half}), -half);
  EXPECT_EQ(bake::range(floats, Polygon{{0, 0}, {2, 0}}).least, -2);
}

// Texel (1, 1) of 3x3 owns [1, 2) x [1, 2).
TEST(SpecBakeNearest, ATexelsLowSidesAreItsOwnTheHighOnesAreNot) {
  Texture t{3, 3, {0, 0, 0, 0, 255, 0, 0, 0, 0}};
  t.filter = Filter::nearest;
  const auto greatest = [&](const Polygon& p) { return bake::range(t, p).greatest; };
  EXPECT_EQ(greatest({{0, 0}, {1, 0}, {1, 3}, {0, 3}}), 1);  // its low side
  EXPECT_EQ(greatest({{2, 0}, {3, 0}, {3, 3}, {2, 3}}), 0);  // its high side
  EXPECT_EQ(greatest({{0, 2}, {3, 2}, {3, 3}}), 0);          // its high side in y
  EXPECT_EQ(greatest({{0, 1}, {3, 1}, {3, 0}}), 1);          // its low side in y
  EXPECT_EQ(greatest({{1, 1}}), 1);                          // its corners
  EXPECT_EQ(greatest({{2, 1}}), 0);
  EXPECT_EQ(greatest({{1, 2}}), 0);
  EXPECT_EQ(greatest({{2, 2}}), 0);
  EXPECT_EQ(greatest({{0, 2}, {1, 2}, {1, 3}}), 0);  // a corner that it does not own
  EXPECT_EQ(greatest({{0, 3}, {3, 0}}), 1);          // through it
  EXPECT_EQ(greatest({{0, 4}, {4, 0}}), 0);          // through (2, 2) alone
  EXPECT_EQ(greatest({{1, 3}, {1, 0}}), 1);          // along its sides
  EXPECT_EQ(greatest({{2, 3}, {2, 0}}), 0);
  EXPECT_EQ(bake::range(t, Polygon{{q(5, 4), q(5, 4)}, {q(7, 4), q(5, 4)}, {q(5, 4), q(7, 4)}}).least, 1);
  EXPECT_EQ(bake::range(t, Polygon{{1, 1}, {2, 1}, {1, 2}}).least, 0);  // reaches its neighbours' low sides
  EXPECT_EQ(bake::alpha(t, TexturePoint{1, 1}), 1);
  EXPECT_EQ(bake::alpha(t, TexturePoint{2, 1}), 0);
  // Before wrapping: the texel at -1 is the last, and owns [-1, 0).
  Texture row{2, 1, {0, 255}};
  row.filter = Filter::nearest;
  row.wrap_x = Wrap::repeat;
  EXPECT_EQ(bake::range(row, Polygon{{-1, 0}}).least, 1);
  EXPECT_EQ(bake::range(row, Polygon{{0, 0}}).least, 0);
  EXPECT_EQ(bake::range(row, Polygon{{q(-1, 2), 0}, {0, 0}}).least, 0);
}

/// Vertices at the corners of the texture: the micro-vertex (i/N, j/N) is at (i/N, j/N) of it.
const Base lower{TexturePoint{0, 0}, TexturePoint{1, 0}, TexturePoint{0, 1}};

TEST(SpecBakeState, MicroTrianglesAreOnTheCurve) {
  EXPECT_EQ(bake::micro_triangle(lower, 0, 0, 4, 8).at(1).x, 4);
  const auto is = [](const Polygon& p, const Polygon& expected) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(p.at(k).x, expected[k].x);
      EXPECT_EQ(p.at(k).y, expected[k].y);
    }
  };
  is(bake::micro_triangle(lower, 0, 0, 4, 8), {{0, 0}, {4, 0}, {0, 8}});
  is(bake::micro_triangle(lower, 1, 0, 4, 8), {{0, 0}, {2, 0}, {0, 4}});
  is(bake::micro_triangle(lower, 1, 1, 4, 8), {{0, 4}, {2, 4}, {2, 0}});
  is(bake::micro_triangle(lower, 1, 2, 4, 8), {{2, 0}, {4, 0}, {2, 4}});
  is(bake::micro_triangle(lower, 1, 3, 4, 8), {{2, 4}, {0, 4}, {0, 8}});
}

// The left half opaque; alpha falls through 1/2 at x = 2.
const Texture left_half{4, 1, {255, 255, 0, 0}};

TEST(SpecBakeState, MixedLeansAsItsCentroid) {
  const auto state = [](std::uint32_t index) {
    return bake::micro_state(left_half, lower, 1, index, at_half);
  };
  EXPECT_EQ(state(0), Micro::O);  // up to x = 2, where alpha = 1/2 is opaque
  EXPECT_EQ(state(1), Micro::O);
  EXPECT_EQ(state(2), Micro::UT);  // its edge x = 2 alone is opaque; centroid at 8/3
  EXPECT_EQ(state(3), Micro::O);
  EXPECT_EQ(bake::micro_state(left_half, lower, 0, 0, at_half), Micro::UO);  // centroid at 4/3
  const Base shifted{TexturePoint{half, 0}, TexturePoint{2, 0}, TexturePoint{half, 1}};
  EXPECT_EQ(bake::micro_state(left_half, shifted, 0, 0, at_half), Micro::UT);
}

TEST(SpecBakeState, FlippedTrianglesHaveTheStatesOfTheirPlaces) {
  const Base flipped{TexturePoint{1, 0}, TexturePoint{0, 0}, TexturePoint{1, 1}};
  EXPECT_EQ(bake::micro_state(left_half, flipped, 1, 0, at_half), Micro::UT);
  EXPECT_EQ(bake::micro_state(left_half, flipped, 1, 2, at_half), Micro::O);
}

TEST(SpecBakeState, LinesAndPointsHaveAState) {
  const auto state = [](const Base& base) { return bake::micro_state(left_half, base, 0, 0, at_half); };
  const TexturePoint left{0, 0}, middle{half, half}, right{1, 1};
  EXPECT_EQ(state({left, left, left}), Micro::O);
  EXPECT_EQ(state({middle, middle, middle}), Micro::O);
  EXPECT_EQ(state({right, right, right}), Micro::T);
  EXPECT_EQ(state({left, middle, left}), Micro::O);
  EXPECT_EQ(state({left, right, left}), Micro::UO);
  EXPECT_EQ(state({right, left, right}), Micro::UT);
  EXPECT_EQ(state({left, middle, right}), Micro::UO);  // centroid in the middle, at the cutoff
}

TEST(SpecBakeState, BlendAsksForNoneAndAll) {
  const Blend blend;
  const auto state = [&](std::vector<std::uint8_t> alpha) {
    return bake::micro_state(Texture{2, 1, std::move(alpha)}, lower, 0, 0, blend);
  };
  EXPECT_EQ(state({255, 255}), Micro::O);
  EXPECT_EQ(state({0, 0}), Micro::T);
  EXPECT_EQ(state({254, 254}), Micro::UO);
  EXPECT_EQ(state({1, 1}), Micro::UT);
  EXPECT_EQ(state({255, 254}), Micro::UO);
  EXPECT_EQ(state({0, 1}), Micro::UT);
  EXPECT_EQ(bake::micro_state(TextureOf<Binary32>{1, 1, {{0x3f000000}}}, lower, 0, 0, blend), Micro::UO);
  EXPECT_EQ(bake::micro_state(TextureOf<Binary32>{1, 1, {{0x40000000}}}, lower, 0, 0, blend), Micro::O);
  EXPECT_EQ(bake::micro_state(TextureOf<Binary32>{1, 1, {{0xbf000000}}}, lower, 0, 0, blend), Micro::T);
}

TEST(SpecBakeState, EveryMipMustAgree) {
  const auto state = [](const std::vector<Texture>& mips) {
    return bake::micro_state(std::span<const Texture>(mips), lower, 0, 0, at_half);
  };
  const Texture opaque{2, 2, {255, 255, 255, 128}}, all{1, 1, {200}}, none{1, 1, {100}},
      transparent{2, 2, {0, 100, 20, 127}};
  EXPECT_EQ(state({opaque, all}), Micro::O);
  EXPECT_EQ(state({transparent, none}), Micro::T);
  EXPECT_EQ(state({opaque, none}), Micro::UO);  // as the first has it
  EXPECT_EQ(state({transparent, all}), Micro::UT);
  EXPECT_EQ(state({opaque, all, none}), Micro::UO);
  EXPECT_THROW(state({}), std::invalid_argument);
}

TEST(SpecBakeState, AMarginIsOfEveryMipsOwnTexels) {
  // Up to x = 3/2 of four texels; opaque up to x = 2.
  const Base left{TexturePoint{0, 0}, TexturePoint{q(3, 8), 0}, TexturePoint{0, 1}};
  const auto state = [&](const std::vector<Texture>& mips, const Rational& margin) {
    return bake::micro_state(std::span<const Texture>(mips), left, 0, 0, at_half, margin);
  };
  EXPECT_EQ(state({left_half}, half), Micro::O);
  EXPECT_EQ(state({left_half}, q(9, 16)), Micro::UO);
  // The triangle reaches 3/4 on two texels, which are opaque up to x = 1.
  const Texture coarse{2, 1, {255, 0}};
  EXPECT_EQ(state({left_half, coarse}, q(1, 4)), Micro::O);
  EXPECT_EQ(state({left_half, coarse}, half), Micro::UO);
  EXPECT_THROW(state({left_half}, q(-1, 2)), std::invalid_argument);
}

constexpr Wrap every_wrap[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                               Wrap::clamp_to_border, Wrap::mirror_once};

// One way only: a C is by hand above.
TEST(SpecBakeState, NoPointContradicts) {
  std::mt19937 random(1);
  for (int round = 0; round < 120; ++round) {
    Texture t{1 + static_cast<std::uint32_t>(random() % 3), 1 + static_cast<std::uint32_t>(random() % 3)};
    t.alpha.resize(std::size_t{t.width} * t.height);
    for (auto& byte : t.alpha) byte = static_cast<std::uint8_t>(random() % 3 * 100 + random() % 50);
    t.wrap_x = every_wrap[random() % 5];
    t.wrap_y = every_wrap[random() % 5];
    t.border = static_cast<std::uint8_t>(random());
    t.filter = round % 2 == 0 ? Filter::bilinear : Filter::nearest;
    Base base;
    for (TexturePoint& p : base) {
      const int x = static_cast<int>(random() % 17) - 8, y = static_cast<int>(random() % 17) - 8;
      p = {q(x, 6), q(y, 6)};
    }
    const auto index = static_cast<std::uint32_t>(random() % 4);
    const Micro state = bake::micro_state(t, base, 1, index, at_half);
    const Polygon p = bake::micro_triangle(base, 1, index, t.width, t.height);
    constexpr int n = 12;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Rational u = q(i, n), v = q(j, n), w = 1 - u - v;
        const bool opaque = bake::alpha(t, TexturePoint{u * p[1].x + v * p[2].x + w * p[0].x,
                                                        u * p[1].y + v * p[2].y + w * p[0].y}) >= half;
        ASSERT_FALSE(state == Micro::T && opaque) << round;
        ASSERT_FALSE(state == Micro::O && !opaque) << round;
      }
  }
}

}  // namespace spec_bake_state_test
