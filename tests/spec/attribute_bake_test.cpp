// [release] spec/attribute/: colours, means, directions, errors and levels by hand, by closed forms, and in the limit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "spec/attribute/error.hpp"
#include "spec/attribute/normal.hpp"
#include "spec/attribute/plan.hpp"

namespace spec_attribute_bake_test {

namespace at = mmverify::spec::attribute;
using at::Filter;
using mmverify::spec::Integer;
using mmverify::spec::Rational;
using TexturePoint = at::TexturePoint<Rational>;
using Polygon = at::Polygon<Rational>;
using Texture = at::TextureOf<std::uint8_t>;

Rational q(int numerator, int denominator = 1) { return at::fraction<Rational>(numerator, denominator); }

Rational share_of(const at::Shares<Rational>& shares, std::int64_t i, std::int64_t j) {
  Rational sum(0);
  for (const auto& s : shares)
    if (s.i == i && s.j == j) sum += s.weight;
  return sum;
}

TEST(SpecAttributeColour, LightIsWithinAHalfOfTheCurveInBinary64) {
  for (std::uint32_t m = 0; m <= 510; ++m) {
    const long double y = m / 510.0L;
    const long double x = y <= 0.04045L ? y / 12.92L : std::pow((y + 0.055L) / 1.055L, 2.4L);
    EXPECT_NEAR(static_cast<double>(at::light_table()[m]), static_cast<double>(x * 16777216), 0.5000001) << m;
  }
  EXPECT_EQ(at::light_of(0), 0u);
  EXPECT_EQ(at::light_of(255), 1u << 24);
}

TEST(SpecAttributeColour, CodesComeBackAndHalfTheLightIs188) {
  for (int c = 0; c < 256; ++c) {
    const auto code = static_cast<std::uint8_t>(c);
    EXPECT_EQ(at::Rounded<at::Srgb8>::of(at::number<Rational>(at::Srgb8{code})).code, c);
    EXPECT_EQ(at::Rounded<std::uint8_t>::of(at::number<Rational>(code)), c);
    EXPECT_EQ(at::Rounded<at::Normal8>::of(at::number<Rational>(at::Normal8{code})).code, c);
  }
  for (const std::uint16_t code : std::array<std::uint16_t, 5>{0, 1, 32767, 32768, 65535})
    EXPECT_EQ(at::Rounded<at::Normal16>::of(at::number<Rational>(at::Normal16{code})).code, code);
  // 255 (1.055 2^(-1/2.4) - 0.055) = 187.5156
  EXPECT_EQ(at::Rounded<at::Srgb8>::of(q(1, 2)).code, 188);
}

TEST(SpecAttributeColour, MiddlesAreRoundedUpAndClamped) {
  EXPECT_EQ(at::Rounded<std::uint8_t>::of(q(1, 510)), 1);
  EXPECT_EQ(at::Rounded<std::uint8_t>::of(q(1, 510) - q(1, 1 << 30)), 0);
  EXPECT_EQ(at::Rounded<std::uint8_t>::of(q(-1)), 0);
  EXPECT_EQ(at::Rounded<std::uint8_t>::of(q(2)), 255);
  EXPECT_EQ(at::Rounded<std::uint16_t>::of(q(1, 2)), 32768);
}

TEST(SpecAttributeColour, Binary32RoundsToEven) {
  using F = at::Rounded<at::Binary32>;
  EXPECT_EQ(F::of(q(1, 3)).bits, 0x3eaaaaabu);
  EXPECT_EQ(F::of(q(-1)).bits, 0xbf800000u);
  EXPECT_EQ(F::of(q(0)).bits, 0u);
  EXPECT_EQ(F::of(q((1 << 24) + 1)).bits, 0x4b800000u);  // 2^24 + 1 lies between two numbers
  EXPECT_EQ(F::of(q((1 << 24) + 3)).bits, 0x4b800002u);
  EXPECT_EQ(F::of(q((1 << 25) - 1)).bits, 0x4c000000u);  // a carry into the exponent
  for (const std::uint32_t bits : {1u, 0x007fffffu, 0x00800000u, 0x3f800001u, 0x7f7fffffu, 0xbf123456u})
    EXPECT_EQ(F::of(at::number<Rational>(at::Binary32{bits})).bits, bits);
}

TEST(SpecAttributeBake, SharesAreAreas) {
  // From (0, 0) to (2, 0) and (0, 1): of the area 1, 1/4 lies beyond x = 1.
  const auto shares = at::shares_on(Polygon{{0, 0}, {2, 0}, {0, 1}}, Filter::nearest);
  EXPECT_EQ(share_of(shares, 0, 0), q(3, 4));
  EXPECT_EQ(share_of(shares, 1, 0), q(1, 4));
}

TEST(SpecAttributeBake, ACellsMeanIsThatOfItsPlane) {
  // The mean of a plane is its value at the centroid.
  const Texture t{2, 2, {0, 51, 102, 153}};
  const Polygon corners{{q(1, 2), q(1, 2)}, {q(5, 4), q(3, 4)}, {q(1, 2), q(3, 2)}};
  const TexturePoint centroid{q(3, 4), q(11, 12)};
  EXPECT_EQ(at::mean(t, at::shares_on(corners, Filter::bilinear)), mmverify::spec::bake::alpha(t, centroid));
}

TEST(SpecAttributeBake, TheSaddlesMeanIsItsIntegral) {
  // alpha = 1 - x - y + 2 x y on the cell; over x + y <= 1 the mean is 1 - 2/3 + 2 (2 / 24) = 1/2.
  const Texture t{2, 2, {255, 0, 0, 255}};
  const Polygon lower{{q(1, 2), q(1, 2)}, {q(3, 2), q(1, 2)}, {q(1, 2), q(3, 2)}};
  EXPECT_EQ(at::mean(t, at::shares_on(lower, Filter::bilinear)), q(1, 2));
}

TEST(SpecAttributeBake, ASegmentWeighsByWhatMapsToIt) {
  // Corners at 0, 1 and 2: a hat, half on either side.  At 0, 0 and 2: a slope, 3/4 and 1/4.
  EXPECT_EQ(share_of(at::shares_on(Polygon{{0, 0}, {1, 0}, {2, 0}}, Filter::nearest), 0, 0), q(1, 2));
  const auto slope = at::shares_on(Polygon{{0, 0}, {0, 0}, {2, 0}}, Filter::nearest);
  EXPECT_EQ(share_of(slope, 0, 0), q(3, 4));
  EXPECT_EQ(share_of(slope, 1, 0), q(1, 4));
  EXPECT_EQ(slope.size(), 2u);  // row -1 is met by its high side alone
}

TEST(SpecAttributeBake, ASegmentIsTheLimitOfTriangles) {
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    Texture t{3, 2, {255, 0, 51, 102, 204, 17}};
    t.wrap_x = mmverify::spec::bake::Wrap::repeat;
    t.filter = filter;
    const Polygon line{{q(1, 3), q(1, 5)}, {q(4, 3), q(4, 5)}, {q(10, 3), 2}};
    const Rational mean = at::mean(t, at::shares_on(line, filter));
    Polygon thin = line;
    thin[1].y += q(1, 1 << 20);
    const Rational off = at::mean(t, at::shares_on(thin, filter)) - mean;
    EXPECT_LT(off < 0 ? Rational(-off) : off, q(1, 1 << 17));
  }
}

TEST(SpecAttributeBake, APointIsItsTexel) {
  Texture t{2, 1, {255, 51}};
  t.filter = Filter::nearest;
  const at::BaseTriangle<Rational> uv{TexturePoint{q(1, 2), q(1, 2)}, {q(1, 2), q(1, 2)}, {q(1, 2), q(1, 2)}};
  EXPECT_EQ(at::face_value(t, uv, 2, 7), q(1, 5));  // x = 1 belongs to texel 1
  EXPECT_EQ(at::vertex_value(t, uv, 2, {1, 2}), q(1, 5));
}

TEST(SpecAttributeBake, BetweenMips) {
  const std::array<Texture, 2> mips{Texture{2, 1, {0, 255}}, Texture{1, 1, {51}}};
  const auto value = [](const Texture& t) { return at::number<Rational>(t.alpha.back()); };
  const auto at_lod = [&](const Rational& lod) {
    return at::between_mips(std::span<const Texture>(mips), lod, value);
  };
  EXPECT_EQ(at_lod(-1), 1);
  EXPECT_EQ(at_lod(q(1, 4)), q(3, 4) + q(1, 20));
  EXPECT_EQ(at_lod(7), q(1, 5));
  EXPECT_THROW(at::between_mips(std::span<const Texture>(), q(0), value), std::invalid_argument);
}

TEST(SpecAttributeNormal, DirectionsAreOneUnitLong) {
  const auto codes = [](const at::Vector3<Rational>& v) {
    const auto d = at::direction(v);
    return std::array<int, 3>{d[0].code, d[1].code, d[2].code};
  };
  EXPECT_EQ(codes({q(0), q(0), q(1, 7)}), (std::array{128, 128, 255}));
  EXPECT_EQ(codes({q(0), q(0), q(0)}), (std::array{128, 128, 255}));
  // 255 (1 + 1/sqrt 2) / 2 = 217.66, and with the other sign 37.34
  EXPECT_EQ(codes({q(1), q(-1), q(0)}), (std::array{218, 37, 128}));
  EXPECT_EQ(codes({q(-3), q(0), q(4)}), (std::array{51, 128, 230}));  // 0.2 and 0.9 of 255: 51 and 229.5
  EXPECT_EQ(at::length_code(at::Vector3<Rational>{q(1, 2), q(1, 2), q(0)}), 180);  // 180.31
  EXPECT_EQ(at::length_code(at::Vector3<Rational>{q(1), q(1), q(1)}), 255);
  EXPECT_EQ(at::length_code<std::uint16_t>(at::Vector3<Rational>{q(1, 2), q(1, 2), q(0)}), 46340);  // 46340.2
  const auto fine = at::direction<std::uint16_t>(at::Vector3<Rational>{q(3), q(0), q(-4)});
  EXPECT_EQ(fine[0].code, 52428);  // 65535 0.8
  EXPECT_EQ(fine[1].code, 32768);
  EXPECT_EQ(fine[2].code, 6554);  // 65535 0.1 = 6553.5
}

TEST(SpecAttributeError, OfTheSaddleByItsIntegrals) {
  // e = 2 x y over x + y <= 1: 1/2 at (1/2, 1/2); 2 integral of 4 x^2 y^2 = 8 (2! 2! / 6!) = 2/45.
  const Texture t{2, 2, {255, 0, 0, 255}};
  const Polygon lower{{q(1, 2), q(1, 2)}, {q(3, 2), q(1, 2)}, {q(1, 2), q(3, 2)}};
  const auto e = at::error_on(t, lower, at::Shown<Rational>{q(1), q(0), q(0)});
  EXPECT_EQ(e.largest, q(1, 2));
  EXPECT_EQ(e.at.x, q(1, 2));
  EXPECT_EQ(e.at.y, q(1, 2));
  EXPECT_EQ(e.square, q(2, 45));
}

TEST(SpecAttributeError, OfTexelsByTheirAreas) {
  Texture t{2, 1, {255, 0}};
  t.filter = Filter::nearest;
  const auto e =
      at::error_on(t, Polygon{{0, 0}, {2, 0}, {0, 1}}, at::Shown<Rational>{q(3, 4), q(3, 4), q(3, 4)});
  EXPECT_EQ(e.largest, q(3, 4));
  EXPECT_EQ(e.square, q(3, 4) * q(1, 16) + q(1, 4) * q(9, 16));
}

TEST(SpecAttributeError, NoneOfAPlane) {
  const Texture t{2, 2, {0, 51, 102, 153}};
  const Polygon corners{{q(1, 2), q(1, 2)}, {q(5, 4), q(3, 4)}, {q(1, 2), q(3, 2)}};
  at::Shown<Rational> shown;
  for (std::size_t k = 0; k < 3; ++k) shown[k] = mmverify::spec::bake::alpha(t, corners[k]);
  const auto e = at::error_on(t, corners, shown);
  EXPECT_EQ(e.largest, 0);
  EXPECT_EQ(e.square, 0);
}

TEST(SpecAttributePlan, LevelsFallByOne) {
  const std::vector<at::Neighbours> strip{{-1, 1, -1}, {0, 2, -1}, {1, 3, -1}, {2, 4, -1}, {3, -1, -1}};
  EXPECT_EQ(at::graded({3, 0, 0, 0, 1}, strip), (std::vector<mmverify::spec::Level>{3, 2, 1, 0, 1}));
  EXPECT_EQ(at::decimated_edges({3, 2, 1, 0, 1}, strip[1], 1), 2);
  EXPECT_EQ(at::decimated_edges({3, 2, 1, 0, 1}, strip[3], 3), 0);
}

}  // namespace spec_attribute_bake_test
