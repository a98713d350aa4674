// [release] Rows of texels in a triangle (impl/bake/judge/centres.hpp), samples of four children
// (impl/bake/judge/samples.hpp) and small boxes of bits (impl/bake/texture/plane.hpp), beside whole numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "impl/bake/judge/centres.hpp"
#include "impl/bake/judge/samples.hpp"
#include "impl/bake/texture/plane.hpp"
#include "impl/bake/triangles.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace impl_bake_rows_test {

using namespace mmverify::impl::bake::detail;

/// Parts of a texel: coordinates are whole numbers of them.
constexpr std::int64_t texel = 256;
struct Point {
  std::int64_t x, y;
};
using Whole = std::array<Point, 3>;

std::int64_t cross(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// 1 within the open triangle, 0 on its outline, -1 outside of the closed one.
int side(const Whole& t, Point p) {
  const std::int64_t area = cross(t[0], t[1], t[2]), sign = area < 0 ? -1 : 1;
  std::int64_t least = INT64_MAX;
  for (std::size_t k = 0; k < 3; ++k) least = std::min(least, sign * cross(t[k], t[(k + 1) % 3], p));
  return least > 0 ? 1 : least == 0 ? 0 : -1;
}

/// 1 if the open triangle meets the open cell (i, j), -1 if the closed ones are apart, else 0: by separating axes.
int meets(const Whole& t, std::int64_t i, std::int64_t j) {
  const std::array<Point, 4> square{{{i * texel, j * texel},
                                     {(i + 1) * texel, j * texel},
                                     {(i + 1) * texel, (j + 1) * texel},
                                     {i * texel, (j + 1) * texel}}};
  std::array<Point, 5> axes{{{1, 0}, {0, 1}}};
  for (std::size_t k = 0; k < 3; ++k) axes[2 + k] = {t[(k + 1) % 3].y - t[k].y, t[k].x - t[(k + 1) % 3].x};
  int answer = 1;
  for (const Point& axis : axes) {
    const auto range = [&axis](const auto& points) {
      std::int64_t low = INT64_MAX, high = INT64_MIN;
      for (const Point& p : points) {
        const std::int64_t at = p.x * axis.x + p.y * axis.y;
        low = std::min(low, at), high = std::max(high, at);
      }
      return std::pair{low, high};
    };
    const auto [a, b] = range(t);
    const auto [c, d] = range(square);
    if (b < c || d < a) return -1;
    if (b == c || d == a) answer = 0;
  }
  return answer;
}

/// A picture of bits: opaque texels, and visible ones among which they are.
struct Bits {
  std::uint32_t width, height;
  std::vector<std::uint8_t> opaque, visible;
  Plane opaque_plane, visible_plane;

  Bits(std::mt19937& random, std::uint32_t w, std::uint32_t h, std::uint32_t density)
      : width(w), height(h), opaque(std::size_t{w} * h), visible(opaque) {
    for (std::size_t k = 0; k < opaque.size(); ++k) {
      opaque[k] = random() % density == 0;
      visible[k] = opaque[k] != 0 || random() % density == 0;
    }
    opaque_plane = plane(opaque);
    visible_plane = plane(visible);
  }
  Plane plane(const std::vector<std::uint8_t>& of) const {
    return Plane(width, height, [&](std::uint32_t y, std::uint8_t* bytes) {
      std::fill_n(bytes, (width + 7) / 8, std::uint8_t{0});
      for (std::uint32_t x = 0; x < width; ++x)
        bytes[x / 8] = static_cast<std::uint8_t>(bytes[x / 8] | of[x + std::size_t{width} * y] << (x % 8));
    });
  }
  bool is_mixed(std::int64_t i, std::int64_t j) const {
    int opaques = 0, visibles = 0;
    for (const std::int64_t y : {j, j + 1})
      for (const std::int64_t x : {i, i + 1}) opaques += opaque[at(x, y)], visibles += visible[at(x, y)];
    return opaques != 4 && visibles != 0;
  }
  std::size_t at(std::int64_t x, std::int64_t y) const { return static_cast<std::size_t>(x + width * y); }
};

/// A triangle of any size within a picture, its corners often on rows, columns and each other's.
Whole drawn(std::mt19937& random, const Bits& bits) {
  const auto extent = static_cast<std::int64_t>(2 + random() % (std::min(bits.width, bits.height) - 4));
  const auto left = static_cast<std::int64_t>(1 + random() %
                                                      (bits.width - static_cast<std::uint32_t>(extent) - 2)),
             top = static_cast<std::int64_t>(1 + random() %
                                                     (bits.height - static_cast<std::uint32_t>(extent) - 2));
  const auto place = [&](std::int64_t from) {
    const auto x = static_cast<std::int64_t>(random() % static_cast<std::uint32_t>(extent * texel));
    return from * texel + (random() % 3 == 0 ? x / texel * texel : x);
  };
  Whole t;
  for (Point& p : t) p = {place(left), place(top)};
  if (random() % 4 == 0) t[1].y = t[0].y;
  if (random() % 6 == 0) t[2].x = t[1].x;
  if (random() % 8 == 0) t[2].y = t[1].y = t[0].y;
  if (random() % 8 == 0) t[2] = {(t[0].x + t[1].x) / 2, (t[0].y + t[1].y) / 2};
  return t;
}

/// Whether the cell of a corner, or of some other point of an edge, is mixed.
bool is_mixed_at_outline(const Whole& t, const Bits& bits) {
  constexpr std::int64_t steps = 16;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::int64_t s = 0; s < steps; ++s) {
      const Point &a = t[k], &b = t[(k + 1) % 3];
      const std::int64_t x = a.x * (steps - s) + b.x * s, y = a.y * (steps - s) + b.y * s;
      if (bits.is_mixed(x / (steps * texel), y / (steps * texel))) return true;
    }
  return false;
}

/// The window of the cells that a triangle may meet.
WindowBits window(const Bits& bits, const Whole& t, std::int64_t moved_x, std::int64_t moved_y) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const std::int64_t top = std::min({t[0].y, t[1].y, t[2].y});
  const std::int64_t i = left / texel - (left % texel == 0 ? 1 : 0),
                     j = top / texel - (top % texel == 0 ? 1 : 0);
  const Plane &are = bits.opaque_plane, &seen = bits.visible_plane;
  const std::size_t word = are.strip() * static_cast<std::size_t>(i / 32) + static_cast<std::size_t>(j);
  return {are.strips() + word,
          seen.strips() + word,
          are.strip(),
          static_cast<std::uint32_t>(i % 32),
          i + moved_x,
          j + moved_y,
          static_cast<std::int32_t>(right / texel + 1 - i + 1),
          true};
}

void expect_rows(std::mt19937& random, const Bits& bits) {
  const Whole t = drawn(random, bits);
  const bool is_flat = t[0].y == t[1].y && t[1].y == t[2].y;
  // Elsewhere in a repeated texture: a window has its own origin.
  const std::int64_t moved_x = random() % 3 == 0 ? 12345 : 0, moved_y = random() % 3 == 0 ? -777 : 0;
  Triangle p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = {static_cast<double>(t[k].x) / texel + static_cast<double>(moved_x),
            static_cast<double>(t[k].y) / texel + static_cast<double>(moved_y)};
  WindowBits in = window(bits, t, moved_x, moved_y);
  Marks sure = 0, perhaps = 0;
  bool sure_mixed = is_mixed_at_outline(t, bits), perhaps_mixed = false, begins = false;
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  for (std::int64_t j = top / texel - 1; j <= bottom / texel; ++j)
    for (std::int64_t i = left / texel - 1; i <= right / texel; ++i) {
      const auto marks = static_cast<Marks>((bits.visible[bits.at(i, j)] != 0 ? opaque : 0) |
                                            (bits.opaque[bits.at(i, j)] == 0 ? below : 0));
      const int within = side(t, {i * texel, j * texel}), met = meets(t, i, j);
      if (within > 0) sure |= marks;
      if (within >= 0) perhaps |= marks;
      if (met > 0) begins = begins || bits.opaque[bits.at(i, j)] != 0;
      if (met > 0) sure_mixed = sure_mixed || bits.is_mixed(i, j);
      if (met >= 0) perhaps_mixed = perhaps_mixed || bits.is_mixed(i, j);
    }
  constexpr Marks never = 4;
  constexpr double delta = 0x1p-40;
  const TriangleBits all = bits_within(p, in, delta, never);
  ASSERT_EQ(all.centres & sure, sure);
  ASSERT_EQ(all.centres | perhaps, perhaps);
  ASSERT_TRUE(all.meets_mixed || !sure_mixed);
  ASSERT_TRUE(!all.meets_mixed || perhaps_mixed || is_flat);
  ASSERT_TRUE(all.meets_mixed || all.begins_opaque == begins);
  // It stops early where it has what is wanted.  Then it must not deny a mixed cell that it did not ask.
  for (const Marks wanted : {below, opaque, both}) {
    const TriangleBits some = bits_within(p, in, delta, wanted);
    ASSERT_EQ(some.centres & ~all.centres, 0);
    ASSERT_TRUE(some.centres == all.centres || (some.centres & wanted) == wanted);
    ASSERT_TRUE(some.meets_mixed || !sure_mixed);
    ASSERT_TRUE(some.meets_mixed || some.begins_opaque == begins);
  }
  in.has_cells = false;
  const TriangleBits centres = bits_within(p, in, delta, never);
  ASSERT_EQ(centres.centres, all.centres);
  ASSERT_TRUE(centres.meets_mixed);
}

TEST(ImplBakeRows, CentresAndCellsAreThoseOfWholeNumbers) {
  mmverify::tests::on_every_target([] {
    std::mt19937 random(31);
    for (const std::uint32_t density : {2u, 40u, 4000u})
      for (const std::uint32_t side : {9u, 30u, 70u, 150u})
        for (std::uint32_t round = 0; round < 4; ++round) {
          const Bits bits(random, side + round % 5, side, density);
          for (int k = 0; k < 60; ++k)
            ASSERT_NO_FATAL_FAILURE(expect_rows(random, bits)) << side << ' ' << density;
        }
  });
}

// Places are multiples of 2^-8 texels, so that every number is exact in binary64, fused or not.
template <class Texel>
void expect_samples() {
  std::mt19937 random(32);
  constexpr std::int32_t pitch = 23;
  std::vector<Texel> texels(pitch * 20 + 4);
  for (Texel& r : texels) r = static_cast<Texel>(random());
  for (int round = 0; round < (sanitized ? 100 : 2000); ++round) {
    FourPlaces places;
    const double left = round % 2 == 0 ? 0 : -1000;
    for (std::size_t k = 0; k < FourPlaces::count; ++k) {
      places.x[k] = left + static_cast<double>(random() % (21 * texel)) / texel;
      places.y[k] = static_cast<double>(random() % (18 * texel)) / texel;
    }
    const FourWindow in{texels.data(), pitch, left, 0, 127.5, 0, 3, 20};
    const FourSamples found = sampled<Texel>(in, places);
    for (std::size_t k = 0; k < FourPlaces::count; ++k) {
      const double x = places.x[k] - left, y = places.y[k];
      const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
      const double fx = x - static_cast<double>(i), fy = y - static_cast<double>(j);
      const auto at = [&](std::size_t a, std::size_t b) {
        return static_cast<double>(texels[a + pitch * b]);
      };
      const double g = (1 - fy) * ((1 - fx) * at(i, j) + fx * at(i + 1, j)) +
                       fy * ((1 - fx) * at(i, j + 1) + fx * at(i + 1, j + 1)) - 127.5;
      ASSERT_EQ(found.g[k], g);
      ASSERT_EQ(found.below >> k & 1, g < -20 ? 1u : 0u);
      ASSERT_EQ(found.opaque >> k & 1, g > 20 ? 1u : 0u);
      ASSERT_EQ(found.leans >> k & 1, std::fabs(g - 3) > 20 ? 1u : 0u);
      ASSERT_EQ(found.leans_to_opaque >> k & 1, g > 3 ? 1u : 0u);
    }
  }
}
TEST(ImplBakeRows, SamplesAreThoseOfWholeNumbers) {
  mmverify::tests::on_every_target([] {
    expect_samples<std::uint8_t>();
    expect_samples<std::uint16_t>();
  });
}

TEST(ImplBakeRows, BoxesOfBitsAreThoseOfTheirTexels) {
  std::mt19937 random(33);
  for (const std::uint32_t density : {2u, 300u})
    for (int round = 0; round < (sanitized ? 500 : 20000); ++round) {
      static const Bits some(random, 101, 77, 2), few(random, 101, 77, 300);
      const Bits& bits = density == 2 ? some : few;
      const auto below = [&random](std::int64_t n) { return static_cast<std::int64_t>(random()) % n; };
      const std::int64_t left = below(101), right = left + below(101 - left), top = below(77),
                         bottom = top + below(77 - top);
      bool have = false, have_not = false;
      for (std::int64_t y = top; y <= bottom; ++y)
        for (std::int64_t x = left; x <= right; ++x)
          (bits.opaque[bits.at(x, y)] != 0 ? have : have_not) = true;
      const Plane::BoxMarks found = bits.opaque_plane.in(left, right, top, bottom);
      ASSERT_EQ(found.some, have);
      ASSERT_EQ(found.some_not, have_not);
    }
}

/// A right triangle with legs of 120 texels, its right angle at one of four corners.
Triangle right_triangle(std::size_t corner) {
  const double x = corner % 2 != 0 ? 140 : 20, y = corner / 2 != 0 ? 140 : 20;
  return {{{x, y}, {160 - x, y}, {x, 160 - y}}};
}

/// Level 1 of a triangle on a texture with one opaque texel: only micro-triangle k, which has it, is unknown.
void expect_only(const Triangle& p, std::size_t k, PlanePoint speck) {
  using namespace mmverify::impl::bake;
  constexpr std::uint32_t side = 160;
  std::vector<std::uint8_t> alpha(std::size_t{side} * side);
  alpha[static_cast<std::size_t>(speck.x) + side * static_cast<std::size_t>(speck.y)] = 255;
  BaseTriangle uv;
  for (std::size_t c = 0; c < 3; ++c)
    uv[c] = {static_cast<float>(p[c].x / side), static_cast<float>(p[c].y / side)};
  std::array<std::uint8_t, 1> map{};
  TriangleBaker(AlphaView{alpha.data(), side, side, side}, Cutoff{1, 2}).bake(uv, 1, map);
  for (std::size_t micro = 0; micro < 4; ++micro)
    ASSERT_EQ((map[0] >> (2 * micro) & 3) >= 2, micro == k) << k << ' ' << micro;
}

// Micro-triangles of 60 rows, with a flat edge at the top or at the bottom.
TEST(ImplBakeRows, LargeRightTrianglesSeeASpeck) {
  for (std::size_t corner = 0; corner < 4; ++corner)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t near = 0; near < 3; ++near) {
        const Triangle p = right_triangle(corner), q = children(p)[k];
        const PlanePoint &a = q[near], &b = q[(near + 1) % 3], &c = q[(near + 2) % 3];
        const PlanePoint speck{0.7 * a.x + 0.15 * (b.x + c.x), 0.7 * a.y + 0.15 * (b.y + c.y)};
        ASSERT_NO_FATAL_FAILURE(expect_only(p, k, speck)) << corner << ' ' << near;
      }
}

}  // namespace impl_bake_rows_test
