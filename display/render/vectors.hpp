// Vectors of three floats.
#pragma once

#include <algorithm>
#include <cmath>

#include "display/render/world.hpp"

namespace mmverify::render {

inline Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point times(const Point& a, float s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline float dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// `a` at length 1; (0, 0, -1) if it has no length.
inline Point unit(const Point& a) {
  // The squares of greater numbers would be infinite, of lesser ones lost.
  const float most = std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
  if (most > 0 && (most < 0x1p-50f || most > 0x1p50f)) {
    const Point scaled{a[0] / most, a[1] / most, a[2] / most};
    return times(scaled, 1 / std::sqrt(dot(scaled, scaled)));
  }
  const float length = std::sqrt(dot(a, a));
  return length > 0 ? times(a, 1 / length) : Point{0, 0, -1};
}

}  // namespace mmverify::render
