// A rectangle within a triangle: most of what is mixed shows it there.  Internal to impl/bake*.
#pragma once

#include <algorithm>

#include "impl/bake_filter.hpp"

namespace mmverify::impl::bake::detail {

/// From the triangle's centroid.  Empty: left > right.
struct InnerBox {
  double left = 1, right = -1, top = 1, bottom = -1;
};

/// The largest of a few, between rows at multiples of 1/12 of the height.
inline InnerBox inner_box(const Triangle& p) noexcept {
  const Spot c{(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3};
  const double low = std::min({p[0].y, p[1].y, p[2].y}), high = std::max({p[0].y, p[1].y, p[2].y});
  constexpr int rows = 12;
  std::array<double, rows + 1> from, to, at;
  for (std::size_t r = 0; r <= rows; ++r) {
    at[r] = low + (high - low) * static_cast<double>(r) / rows;
    from[r] = 1e300;
    to[r] = -1e300;
    for (std::size_t k = 0; k < 3; ++k) {
      const Spot a = p[k], b = p[(k + 1) % 3];
      if ((a.y <= at[r]) == (b.y <= at[r])) continue;
      const double x = std::clamp(a.x + (at[r] - a.y) * ((b.x - a.x) / (b.y - a.y)), std::min(a.x, b.x),
                                  std::max(a.x, b.x));
      from[r] = std::min(from[r], x);
      to[r] = std::max(to[r], x);
    }
  }
  InnerBox best;
  double area = 0;
  for (std::size_t r = 0; r <= rows; ++r)
    for (std::size_t s = r + 1; s <= rows; ++s) {
      const double left = std::max(from[r], from[s]), right = std::min(to[r], to[s]);
      if (left >= right || (right - left) * (at[s] - at[r]) <= area) continue;
      area = (right - left) * (at[s] - at[r]);
      best = {left - c.x, right - c.x, at[r] - c.y, at[s] - c.y};
    }
  return best;
}

}  // namespace mmverify::impl::bake::detail
