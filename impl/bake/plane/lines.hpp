// The lines that bound micro-triangles of one base triangle.  Each micro-triangle is the base triangle made smaller,
// and moved or turned by half a circle, so that all edges together have three slopes.  Internal to impl/bake.
//
// A line through (x', y') is at x' + (y - y') s on row y, with s = dx/dy of an edge of the base triangle.  Of the lines
// of a slope through a triangle's corners the outermost bounds it.  Two of the three, A and B, bound it on one side, C
// on the other; for a turned triangle the sides change.  A flat edge falls by less than a texel over the whole base
// triangle and bounds nothing here: rows end there.
//
// T is a true triangle, T' the computed one, its corners within delta of T's along either axis.  True and
// computed dx and dy differ by 2 delta at most and |dy| >= 1, so that slopes differ by less than
// 2^2 delta (1 + |s|), and lines on rows up to `reach` = 2^7 from (x', y') by less than
//   (2^9 + 1) delta (1 + |s|).
// Rows are whole, and places lie within `reach` of the origin.  Binary32 rounds the place at row 0, the slope and their
// sum: by 2^-24 each of at most 2^8 (1 + |s|), and once more if a margin is added or a strip's columns are taken off.
// With
//   margin (1 + |s|),   margin = 2^10 delta + 2^-12,
// to spare, points of T are computed to be on T's side of a line, and points that are not are computed so.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "impl/bake/plane/points.hpp"

namespace mmverify::impl::bake::detail {

struct Lines {
  static constexpr double reach = 128;

  /// Whether the members below are set; false for a triangle of no area or less than two texels high.
  bool usable = false;
  /// The slopes of A, B, C; A's twice if there is no B.
  std::array<double, 3> slope{};
  bool ab_left = false;  ///< A and B are on the left, unless turned
  bool has_flat = false;
  double margin = 0;

  Lines() = default;
  /// Domain: corners within delta of the true ones.
  Lines(const Triangle& p, double delta) noexcept : margin(0x1p10 * delta + 0x1p-12) {
    const auto dx = [&p](std::size_t k) { return p[(k + 1) % 3].x - p[k].x; };
    const auto dy = [&p](std::size_t k) { return p[(k + 1) % 3].y - p[k].y; };
    const double area = dx(0) * -dy(2) + dy(0) * dx(2),
                 size = std::fabs(dx(0)) + std::fabs(dy(0)) + std::fabs(dx(2)) + std::fabs(dy(2));
    // Each of four factors is off by 2 delta at most; 2^-40 of the sum of sizes exceeds the rounding of their products.
    if (!(margin < 0x1p-6) || !(std::fabs(area) > 1 + (4 * delta + 0x1p-40 * size) * size)) return;
    // With y down, an edge is on the left if its dy and the area have different signs.
    std::array<std::size_t, 3> left{}, right{};
    std::size_t lefts = 0, rights = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(std::fabs(dy(k)) >= 1)) continue;
      if ((dy(k) < 0) == (area > 0))
        left[lefts++] = k;
      else
        right[rights++] = k;
    }
    if (lefts == 0 || rights == 0) return;
    has_flat = lefts + rights == 2;
    ab_left = lefts >= rights;
    const auto& two = ab_left ? left : right;
    const std::size_t edge[] = {two[0], has_flat ? two[0] : two[1], ab_left ? right[0] : left[0]};
    for (std::size_t l = 0; l < 3; ++l) slope[l] = dx(edge[l]) / dy(edge[l]);
    usable = true;
  }
};

}  // namespace mmverify::impl::bake::detail
