// Points and triangles in binary64.  Internal to impl/bake.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace mmverify::impl::bake::detail {

struct PlanePoint {
  double x, y;
};

/// A triangle's dilation: its sum with [-x, x] x [-y, y], in texels.
struct Dilation {
  double x = 0, y = 0;
  constexpr bool none() const noexcept { return x == 0 && y == 0; }
};

using Triangle = std::array<PlanePoint, 3>;

/// floor, without a call where the processor has no instruction for it.  Domain: |x| < 2^62.
inline std::int64_t floored(double x) noexcept {
  const auto i = static_cast<std::int64_t>(x);
  return i - (x < static_cast<double>(i) ? 1 : 0);
}

inline PlanePoint middle(PlanePoint a, PlanePoint b) noexcept {
  return {(a.x + b.x) * 0.5, (a.y + b.y) * 0.5};
}

/// The four triangles that one is cut into, in the order and with the corners of impl/index/index.hpp; the second is
/// turned.
inline std::array<Triangle, 4> children(const Triangle& p) noexcept {
  const PlanePoint p01 = middle(p[0], p[1]), p02 = middle(p[0], p[2]), p12 = middle(p[1], p[2]);
  return {Triangle{p[0], p01, p02}, {p02, p12, p01}, {p01, p[1], p12}, {p12, p02, p[2]}};
}

/// An interval of x; empty: from > to.
struct Reach {
  double from = 1e300, to = -1e300;
  void take(double x) noexcept {
    from = std::min(from, x);
    to = std::max(to, x);
  }
};

/// The x at which a segment crosses a level; within its ends' x, however that rounds.  Domain: its ends are on
/// different sides of the level.
inline double crossing(PlanePoint a, PlanePoint b, double level) noexcept {
  return std::clamp(a.x + (level - a.y) * ((b.x - a.x) / (b.y - a.y)), std::min(a.x, b.x),
                    std::max(a.x, b.x));
}

/// The reach of a triangle at y = level.
inline Reach at_level(const Triangle& p, double level) noexcept {
  Reach reach;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlanePoint a = p[k], b = p[k == 2 ? 0 : k + 1];
    if ((a.y <= level) != (b.y <= level)) reach.take(crossing(a, b, level));
  }
  return reach;
}

/// The reach of a triangle's part with low <= y <= high.
inline Reach between(const Triangle& p, double low, double high) noexcept {
  Reach reach;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlanePoint a = p[k], b = p[k == 2 ? 0 : k + 1];
    if (a.y >= low && a.y <= high) reach.take(a.x);
    for (const double level : {low, high})
      if ((a.y < level) != (b.y < level)) reach.take(crossing(a, b, level));
  }
  return reach;
}

}  // namespace mmverify::impl::bake::detail
