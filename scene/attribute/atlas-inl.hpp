// The loop of atlas.hpp.
#pragma once

#include <algorithm>
#include <cmath>

namespace mmverify::scene {

/// Calls visit(x, y, u, v) for each whole (x, y) whose centre (x + 1/2, y + 1/2) lies on the triangle, border included.
template <class Visit>
void for_each_centre(const TexelTriangle& corners, Visit visit) {
  const auto& [a, b, c] = corners;
  const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1],
               area = bx * cy - cx * by;
  if (area == 0) return;
  const auto first = [](double least) { return static_cast<std::int64_t>(std::ceil(least - 0.5)); };
  const auto last = [](double most) { return static_cast<std::int64_t>(std::floor(most - 0.5)); };
  const auto [top, bottom] = std::minmax({a[1], b[1], c[1]});
  for (std::int64_t y = first(top); y <= last(bottom); ++y) {
    // Where the row's middle meets the edges, a texel to be safe on both sides.
    const double at = static_cast<double>(y) + 0.5;
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &p = corners[k], &q = corners[(k + 1) % 3];
      if (std::min(p[1], q[1]) > at || std::max(p[1], q[1]) < at) continue;
      const double x = p[1] == q[1] ? p[0] : p[0] + (at - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
      left = std::min({left, x, p[1] == q[1] ? q[0] : x});
      right = std::max({right, x, p[1] == q[1] ? q[0] : x});
    }
    if (left > right) continue;
    for (std::int64_t x = first(left) - 1; x <= last(right) + 1; ++x) {
      const double px = static_cast<double>(x) + 0.5 - a[0], py = at - a[1];
      const double u = (px * cy - cx * py) / area, v = (bx * py - px * by) / area;
      if (u >= 0 && v >= 0 && u + v <= 1) visit(x, y, u, v);
    }
  }
}

}  // namespace mmverify::scene
