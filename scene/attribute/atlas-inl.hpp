// The loop of atlas.hpp.
#pragma once

#include <algorithm>
#include <cmath>

namespace mmverify::scene {

template <class Visit>
void for_each_texel(const ColourImage& image, const Sampler& sampler, const TexelTriangle& corners,
                    Visit visit) {
  const auto& [a, b, c] = corners;
  const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1],
               area = bx * cy - cx * by;
  if (area == 0) return;
  const auto first = [](double least) { return static_cast<std::int64_t>(std::ceil(least - 0.5)); };
  const auto last = [](double most) { return static_cast<std::int64_t>(std::floor(most - 0.5)); };
  const auto [left, right] = std::minmax({a[0], b[0], c[0]});
  const auto [top, bottom] = std::minmax({a[1], b[1], c[1]});
  for (std::int64_t y = first(top); y <= last(bottom); ++y)
    for (std::int64_t x = first(left); x <= last(right); ++x) {
      const double px = static_cast<double>(x) + 0.5 - a[0], py = static_cast<double>(y) + 0.5 - a[1];
      const double u = (px * cy - cx * py) / area, v = (bx * py - px * by) / area;
      if (u >= 0 && v >= 0 && u + v <= 1) visit(wrapped_texel(image, sampler, x, y), u, v);
    }
}

}  // namespace mmverify::scene
