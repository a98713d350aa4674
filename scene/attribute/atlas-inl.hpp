// The loops of atlas.hpp.
#pragma once

#include <algorithm>
#include <cmath>

namespace mmverify::scene {

template <class Visit>
void for_each_centre(const TexelTriangle& corners, Visit visit) {
  const auto& [a, b, c] = corners;
  const TexelPlane plane(corners);
  if (plane.area() == 0) return;
  const auto first = [](double least) { return static_cast<std::int64_t>(std::ceil(least - 0.5)); };
  const auto last = [](double most) { return static_cast<std::int64_t>(std::floor(most - 0.5)); };
  const auto [left, right] = std::minmax({a[0], b[0], c[0]});
  const auto [top, bottom] = std::minmax({a[1], b[1], c[1]});
  for (std::int64_t y = first(top); y <= last(bottom); ++y)
    for (std::int64_t x = first(left); x <= last(right); ++x) {
      const auto [u, v] = plane.at(x, y);
      if (u >= 0 && v >= 0 && u + v <= 1 && !visit(x, y, u, v)) return;
    }
}

template <class Visit>
void for_each_texel(const ColourImage& image, const Sampler& sampler, const TexelTriangle& corners,
                    Visit visit) {
  for_each_centre(corners, [&](std::int64_t x, std::int64_t y, double u, double v) {
    visit(wrapped_texel(image, sampler, x, y), u, v);
    return true;
  });
}

}  // namespace mmverify::scene
