// The integral of F dy along a micro-edge, F(x, y) the sum of its row's texels up to x.  Internal to impl/attribute.
//
// A row is [j, j + 1), a column [i, i + 1).  Where both stay the same F is linear in x, so that a piece of the edge adds
//   (P(i) + (x - i) c(i)) (its dy),   x the middle of it, P(i) the texels before i.
// Rounding, with c <= m, E and u those of frame.hpp, h = |dx| + |dy|, K <= h + 3 pieces:
//   a row's pieces end at whole y, so that what lies in each row is exact; x where the edge crosses a row, and y where it
//   crosses a column, are within 6 u E of the segment, which moves the integral by 6 u E m h at most; F is within
//   6 u m E of its value, and the sum of the pieces within K u of it, of numbers up to m E |dy|.
//   Together: m u E (12 + 6 + K) h.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "impl/attribute/bake/frame.hpp"

namespace mmverify::impl::attribute::detail {

using Four = std::array<double, 4>;

/// Adds sign times a piece of row j from (x0, .) to (x1, .) in column i.
template <class Sum>
inline void add_piece(const Sum* row, std::int32_t i, double x0, double x1, double dy, Four& to) noexcept {
  const Sum* const p = row + 4 * static_cast<std::size_t>(i);
  const double f = 0.5 * (x0 + x1) - i;
  for (std::size_t k = 0; k < 4; ++k) {
    const double before = static_cast<double>(p[k]), own = static_cast<double>(p[k + 4]) - before;
    to[k] += (before + f * own) * dy;
  }
}

/// Of the edge from p to q.  Domain: coordinates in [1, width or height of the sums).
template <class Sum>
inline Four edge_integral(const RowSums<Sum>& sums, Point p, Point q) noexcept {
  Four integral{};
  if (p.y == q.y) return integral;
  const double sign = p.y < q.y ? 1 : -1;
  if (q.y < p.y) std::swap(p, q);
  const double dx = q.x - p.x, dy = q.y - p.y, across = dx / dy, down = dy / dx, least = std::min(p.x, q.x),
               greatest = std::max(p.x, q.x);
  const auto last = static_cast<std::int32_t>(q.y);
  double x = p.x, y = p.y;
  for (auto j = static_cast<std::int32_t>(p.y); j <= last; ++j) {
    const bool ends = j == last;
    const double next_y = ends ? q.y : j + 1.0,
                 next_x = ends ? q.x : std::clamp(p.x + (next_y - p.y) * across, least, greatest);
    const Sum* const row = sums.first + 4 * sums.pitch * static_cast<std::size_t>(j);
    auto i = static_cast<std::int32_t>(x);
    const auto to = static_cast<std::int32_t>(next_x);
    while (i != to) {
      const double crossed = i < to ? i + 1.0 : i;
      const double at = std::clamp(p.y + (crossed - p.x) * down, y, next_y);
      add_piece(row, i, x, crossed, (at - y) * sign, integral);
      x = crossed;
      y = at;
      i += i < to ? 1 : -1;
    }
    add_piece(row, i, x, next_x, (next_y - y) * sign, integral);
    x = next_x;
    y = next_y;
  }
  return integral;
}

}  // namespace mmverify::impl::attribute::detail
