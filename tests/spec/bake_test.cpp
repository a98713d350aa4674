// [release] spec/bake/bake.hpp: wrapping, bilinear alpha and the extremes of polygons by hand, and against points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "spec/bake/range.hpp"

namespace spec_bake_test {

namespace bake = mmverify::spec::bake;
using bake::State, bake::Texture, bake::Wrap, bake::wrapped;
using mmverify::spec::Rational;
using mmverify::spec::Rational128;
using TexturePoint = bake::TexturePoint<Rational>;
using Polygon = bake::Polygon<Rational>;
using Range = bake::Range<Rational>;

Rational q(int numerator, int denominator = 1) { return bake::fraction<Rational>(numerator, denominator); }

// The templates, so that places and polygons may be written in braces.
Rational alpha(const Texture& t, const TexturePoint& p) { return bake::alpha(t, p); }
Range range(const Texture& t, const Polygon& p) { return bake::range(t, p); }
State state(const Texture& t, const Polygon& p, const Rational& cutoff) { return bake::state(t, p, cutoff); }

const Rational half = q(1, 2);

std::vector<std::int64_t> row(Wrap wrap, std::uint32_t size) {
  std::vector<std::int64_t> texels;
  for (std::int64_t i = -4; i < 8; ++i) {
    const auto at = wrapped(wrap, i, size);
    texels.push_back(at ? std::int64_t{*at} : -1);
  }
  return texels;
}

TEST(SpecBake, Wraps) {
  using Row = std::vector<std::int64_t>;
  EXPECT_EQ(row(Wrap::repeat, 3), (Row{2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1}));
  EXPECT_EQ(row(Wrap::mirrored_repeat, 3), (Row{2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0, 1}));
  EXPECT_EQ(row(Wrap::clamp_to_edge, 3), (Row{0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2, 2}));
  EXPECT_EQ(row(Wrap::clamp_to_border, 3), (Row{-1, -1, -1, -1, 0, 1, 2, -1, -1, -1, -1, -1}));
  EXPECT_EQ(row(Wrap::mirror_once, 3), (Row{2, 2, 1, 0, 0, 1, 2, 2, 2, 2, 2, 2}));
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge, Wrap::mirror_once})
    EXPECT_EQ(row(wrap, 1), Row(12, 0));
}

TEST(SpecBake, AlphaIsTheTexelsAtTheirCentresAndBilinearBetween) {
  const Texture t{2, 2, {255, 0, 51, 102}};
  EXPECT_EQ(alpha(t, {half, half}), 1);
  EXPECT_EQ(alpha(t, {q(3, 2), half}), 0);
  EXPECT_EQ(alpha(t, {half, q(3, 2)}), q(1, 5));  // y goes down the rows
  EXPECT_EQ(alpha(t, {q(3, 2), q(3, 2)}), q(2, 5));
  EXPECT_EQ(alpha(t, {1, half}), half);
  EXPECT_EQ(alpha(t, {1, 1}), q(2, 5));
  EXPECT_EQ(alpha(t, {q(3, 4), q(5, 4)}), q(9 * 0 + 3 * 255 + 9 * 51 + 3 * 102, 16 * 255));
  // Beyond the outer centres.
  EXPECT_EQ(alpha(t, {-5, half}), 1);
  Texture other = t;
  other.wrap_x = Wrap::repeat;
  EXPECT_EQ(alpha(other, {0, half}), half);
  EXPECT_EQ(alpha(other, {q(-1, 2), half}), 0);
  other.wrap_x = Wrap::mirrored_repeat;
  EXPECT_EQ(alpha(other, {0, half}), 1);
  EXPECT_EQ(alpha(other, {q(-3, 2), half}), 0);
  other.wrap_x = Wrap::clamp_to_border;
  other.border = 51;
  EXPECT_EQ(alpha(other, {0, half}), q(3, 5));
  EXPECT_EQ(alpha(other, {0, -7}), q(3, 5));  // in y it is clamped
  EXPECT_EQ(alpha(other, {-7, -7}), q(1, 5));
}

// A cell of texels [255 0; 0 255]: alpha = 1 - x - y + 2xy.
const Texture saddle{2, 2, {255, 0, 0, 255}};

Polygon in_cell(const Polygon& local) {
  Polygon polygon;
  for (const TexturePoint& p : local) polygon.push_back({p.x + half, p.y + half});
  return polygon;
}

// Opaque at all corners, but not on the slanted edges: from (0, 0) to (1, 1) alpha = 1 - 2t + 2t^2 dips to
// 1/2, and from (1, 1) to (1/8, 0) alpha = 1 - 15/8 t + 7/4 t^2 to 1 - 225/448.
TEST(SpecBake, AnEdgesCriticalPointCounts) {
  const Range one = range(saddle, in_cell({{0, 0}, {1, 1}}));
  EXPECT_EQ(one.least, half);
  EXPECT_EQ(one.greatest, 1);
  EXPECT_EQ(state(saddle, in_cell({{0, 0}, {1, 1}}), half), State::O);  // >= cutoff
  EXPECT_EQ(state(saddle, in_cell({{0, 0}, {1, 1}}), half + q(1, 1000000)), State::C);

  const Polygon dips = in_cell({{0, 0}, {1, 1}, {q(1, 8), 0}});
  for (const TexturePoint& p : dips) EXPECT_GE(alpha(saddle, p), q(7, 8));
  EXPECT_EQ(range(saddle, dips).least, q(223, 448));
  EXPECT_EQ(range(saddle, dips).greatest, 1);
  EXPECT_EQ(state(saddle, dips, q(223, 448)), State::O);
  EXPECT_EQ(state(saddle, dips, half), State::C);
  // The other way round.
  EXPECT_EQ(range(saddle, in_cell({{q(1, 8), 0}, {1, 1}, {0, 0}})).least, q(223, 448));
}

TEST(SpecBake, AnEdgesCriticalPointCountsAbove) {
  const Texture other{2, 2, {0, 255, 255, 0}};
  const Polygon rises = in_cell({{0, 0}, {1, 1}, {q(1, 8), 0}});
  EXPECT_EQ(range(other, rises).greatest, q(225, 448));
  EXPECT_EQ(state(other, rises, half), State::C);
  EXPECT_EQ(state(other, rises, q(225, 448)), State::C);
  EXPECT_EQ(state(other, rises, q(225, 448) + q(1, 1000000)), State::T);
}

// k t^2 + l t + m = 200/255 - 200/255 t + t^2 stands still at t = 20/51, not in the middle.
TEST(SpecBake, TheCriticalPointIsRational) {
  const Texture t{2, 2, {200, 60, 140, 255}};
  EXPECT_EQ(range(t, in_cell({{0, 0}, {1, 1}})).least, q(200, 255) - q(200 * 200, 4 * 255 * 255));
  // The saddle point itself is no extreme: the square around it reaches both ways.
  const Range around = range(
      saddle, in_cell({{q(1, 4), q(1, 4)}, {q(3, 4), q(1, 4)}, {q(3, 4), q(3, 4)}, {q(1, 4), q(3, 4)}}));
  EXPECT_EQ(around.least, q(3, 8));
  EXPECT_EQ(around.greatest, q(5, 8));
}

TEST(SpecBake, TexelsWithinAPolygonCount) {
  Texture t{5, 5, std::vector<std::uint8_t>(25, 0)};
  t.alpha[12] = 255;  // its cells end one texel from the centre (5/2, 5/2)
  const auto triangle = [](const Rational& reach) {
    return Polygon{{q(5, 2) - reach, q(5, 2) - reach},
                   {q(5, 2) + 3 * reach, q(5, 2) - reach},
                   {q(5, 2) - reach, q(5, 2) + 3 * reach}};
  };
  EXPECT_EQ(range(t, triangle(1)).greatest, 1);
  EXPECT_EQ(range(t, triangle(1)).least, 0);
  EXPECT_EQ(state(t, triangle(1), half), State::C);
  // Through the texel by an edge, a corner, or as a point: closed.
  EXPECT_EQ(range(t, {{q(5, 2), q(5, 2)}, {4, 4}, {4, 3}}).greatest, 1);
  EXPECT_EQ(range(t, {{1, 1}, {4, 4}, {5, 0}}).greatest, 1);
  EXPECT_EQ(range(t, {{q(5, 2), q(5, 2)}}).least, 1);
  EXPECT_EQ(range(t, {{q(5, 2), 1}, {q(5, 2), 4}}).greatest, 1);
  // Up to the cells' outer edge there is nothing of it.
  EXPECT_EQ(range(t, {{0, 0}, {q(3, 2), 0}, {q(3, 2), 5}, {0, 5}}).greatest, 0);
  EXPECT_EQ(state(t, {{0, 0}, {q(3, 2), 0}, {q(3, 2), 5}, {0, 5}}, half), State::T);
  EXPECT_GT(range(t, {{0, 0}, {q(1501, 1000), 0}, {q(1501, 1000), 5}, {0, 5}}).greatest, 0);
}

TEST(SpecBake, TheCutoffItselfIsOpaque) {
  const Polygon all{{-3, -3}, {9, -3}, {-3, 9}};
  EXPECT_EQ(state(Texture{1, 1, {128}}, all, half), State::O);
  EXPECT_EQ(state(Texture{1, 1, {127}}, all, half), State::T);
  EXPECT_EQ(state(Texture{1, 1, {51}}, all, q(1, 5)), State::O);
  EXPECT_EQ(state(Texture{1, 1, {0}}, all, 0), State::O);
  EXPECT_EQ(state(Texture{1, 1, {255}}, all, 1), State::O);
  EXPECT_EQ(state(Texture{2, 1, {128, 127}}, all, half), State::C);
}

TEST(SpecBake, RefusesWhatIsNone) {
  EXPECT_THROW(range(saddle, Polygon{}), std::invalid_argument);
  EXPECT_THROW(range(Texture{2, 2, {1, 2, 3}}, in_cell({{0, 0}})), std::invalid_argument);
  EXPECT_THROW(range(Texture{}, in_cell({{0, 0}})), std::invalid_argument);
}

constexpr Wrap every_wrap[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                               Wrap::clamp_to_border, Wrap::mirror_once};

Texture random_texture(std::mt19937& random) {
  Texture t{1 + static_cast<std::uint32_t>(random() % 3), 1 + static_cast<std::uint32_t>(random() % 3)};
  t.alpha.resize(std::size_t{t.width} * t.height);
  for (auto& byte : t.alpha) byte = static_cast<std::uint8_t>(random());
  t.wrap_x = every_wrap[random() % 5];
  t.wrap_y = every_wrap[random() % 5];
  t.border = static_cast<std::uint8_t>(random());
  return t;
}

TexturePoint random_place(std::mt19937& random) {
  const auto along = [&random] { return q(static_cast<int>(random() % 91) - 30, 13); };
  const Rational x = along();
  return {x, along()};
}

// One way only: no point may lie beyond the extremes, and a quadratic's ends are not all of it; the other way
// is by hand above.
TEST(SpecBake, NoPointIsBeyondTheExtremes) {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    const Texture t = random_texture(random);
    const TexturePoint a = random_place(random), b = random_place(random), c = random_place(random);
    const Range extremes = range(t, {a, b, c});
    Range seen(alpha(t, a));
    constexpr int n = 12;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Rational u = q(i, n), v = q(j, n), w = 1 - u - v;
        const TexturePoint p{u * a.x + v * b.x + w * c.x, u * a.y + v * b.y + w * c.y};
        seen.take(alpha(t, p));
      }
    ASSERT_LE(extremes.least, seen.least) << round;
    ASSERT_GE(extremes.greatest, seen.greatest) << round;
    // Nor are they far beyond: alpha is nowhere steeper than 1 a texel along an axis, and no point of a side
    // of at most 7 texels is farther than 7/12 from one seen.
    ASSERT_GE(extremes.least, seen.least - 2 * q(7, n)) << round;
    ASSERT_LE(extremes.greatest, seen.greatest + 2 * q(7, n)) << round;
  }
}

// A polygon cut in two by a line has the extremes of its parts.
TEST(SpecBake, PartsHaveTheExtremesOfTheWhole) {
  std::mt19937 random(2);
  for (int round = 0; round < 60; ++round) {
    const Texture t = random_texture(random);
    const Polygon whole{random_place(random), random_place(random), random_place(random)};
    const TexturePoint p = random_place(random), normal = random_place(random);
    const auto height = [&](const TexturePoint& r) {
      return normal.x * (r.x - p.x) + normal.y * (r.y - p.y);
    };
    const Range all = range(t, whole);
    std::optional<Range> parts;
    for (const Polygon& part : {bake::clipped(whole, height),
                                bake::clipped(whole, [&](const TexturePoint& r) { return -height(r); })}) {
      if (part.empty()) continue;
      const Range r = range(t, part);
      if (!parts) parts = r;
      parts->take(r.least);
      parts->take(r.greatest);
    }
    ASSERT_EQ(all.least, parts->least) << round;
    ASSERT_EQ(all.greatest, parts->greatest) << round;
  }
}

TEST(SpecBake, HullsHaveEachCornerOnce) {
  const auto corners = [](Polygon points) { return bake::hull(std::move(points)).size(); };
  EXPECT_EQ(corners({{1, 2}}), 1u);
  EXPECT_EQ(corners({{1, 2}, {1, 2}, {1, 2}}), 1u);
  EXPECT_EQ(corners({{1, 2}, {3, 3}, {1, 2}}), 2u);
  EXPECT_EQ(corners({{0, 0}, {2, 2}, {1, 1}, {2, 2}}), 2u);
  EXPECT_EQ(corners({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {0, 1}}), 4u);
  const Polygon square = bake::hull(Polygon{{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  for (std::size_t k = 0; k < 4; ++k) {  // in order: each is beside the next
    const TexturePoint &p = square.at(k), &q = square.at((k + 1) % 4);
    EXPECT_TRUE(p.x == q.x || p.y == q.y);
  }
}

// The support function: the farthest point in direction (a, b) moves |a| m + |b| m farther.
TEST(SpecBake, DilatedByASquare) {
  std::mt19937 random(4);
  const auto farthest = [](const Polygon& p, const Rational& a, const Rational& b) {
    Rational most = a * p.at(0).x + b * p.at(0).y;
    for (const TexturePoint& corner : p) most = std::max<Rational>(most, a * corner.x + b * corner.y);
    return most;
  };
  for (int round = 0; round < 60; ++round) {
    Polygon triangle;
    for (int k = 0; k < 3; ++k)
      triangle.push_back({q(static_cast<int>(random() % 9), 4), q(static_cast<int>(random() % 9), 4)});
    const Rational m = q(1 + static_cast<int>(random() % 9), 8);
    const Polygon dilated = bake::dilated(triangle, m);
    EXPECT_LE(dilated.size(), 7u);
    for (int a = -4; a <= 4; ++a)
      for (int b = -4; b <= 4; ++b)
        ASSERT_EQ(farthest(dilated, a, b), farthest(triangle, a, b) + (std::abs(a) + std::abs(b)) * m);
  }
  const Polygon triangle{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(bake::dilated(triangle, q(0)).size(), 3u);
  EXPECT_THROW(bake::dilated(triangle, q(-1)), std::invalid_argument);
  // An opaque texel half a texel off.
  const Texture t{
      2, 1, {0, 255}, Wrap::clamp_to_edge, Wrap::clamp_to_edge, 0, bake::one, bake::Filter::nearest};
  EXPECT_EQ(bake::range(t, bake::dilated(Polygon{{half, half}}, q(3, 8))).greatest, 0);
  EXPECT_EQ(bake::range(t, bake::dilated(Polygon{{half, half}}, half)).greatest, 1);
}

// The two number types, on the same polygons.
TEST(SpecBake, In128BitsItIsTheSame) {
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    const Texture t = random_texture(random);
    Polygon polygon;
    bake::Polygon<Rational128> same;
    for (int corner = 0; corner < 3; ++corner) {
      const int x = static_cast<int>(random() % 91) - 30, y = static_cast<int>(random() % 91) - 30;
      polygon.push_back({q(x, 8), q(y, 8)});
      same.push_back({bake::fraction<Rational128>(x, 8), bake::fraction<Rational128>(y, 8)});
    }
    const Range all = range(t, polygon);
    const auto in_128_bits = bake::range(t, same);
    ASSERT_EQ(in_128_bits.least.numerator(), all.least.numerator());
    ASSERT_EQ(in_128_bits.least.denominator(), all.least.denominator());
    ASSERT_EQ(in_128_bits.greatest.numerator(), all.greatest.numerator());
    ASSERT_EQ(in_128_bits.greatest.denominator(), all.greatest.denominator());
  }
  const Rational128 tiny = bake::fraction<Rational128>(1, INT64_MAX);
  EXPECT_THROW(tiny * tiny * tiny, std::overflow_error);
}

}  // namespace spec_bake_test
