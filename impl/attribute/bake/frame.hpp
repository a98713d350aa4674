// A base triangle in texels, in binary64, with a bound of its rounding.  Internal to impl/attribute.
//
// Micro-vertex (i, j) is origin + i across + j down, with coordinates from a corner (left, top) nearby, so that none is
// below 1 nor beyond the box.  docs/ATTRIBUTE_BOUNDS.md, "Positions" and "The area", derives the bounds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "impl/attribute/bake/source.hpp"

namespace mmverify::impl::attribute::detail {

inline constexpr double half_ulp = 0x1p-53;  // check-magic: 0x1p-53 == 2 ** (1 - 53) / 2

struct Point {
  double x, y;
};

struct Frame {
  std::int64_t left, top, width,
      height;  ///< of the box: all texels that corners, or bilinear cells, of the triangle reach
  Point origin, across, down;
  double extent;    ///< E
  double position;  ///< bound of a coordinate's error
  double area;      ///< twice the signed area of a micro-triangle
  double area_off;  ///< bound of the error of `area`

  /// The frame of a triangle over a texture of this size.
  Frame(std::uint32_t texture_width, std::uint32_t texture_height, const BaseTriangle& uv,
        std::uint32_t level) {
    std::array<double, 3> x, y;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = double{uv[k].u} * texture_width;  // exact: 24 and 14 bits
      y[k] = double{uv[k].v} * texture_height;
    }
    const auto span = [](const std::array<double, 3>& at, std::int64_t& from, std::int64_t& count) {
      const auto [least, greatest] = std::minmax({at[0], at[1], at[2]});
      // The box has one texel more on either side, for rounding and for the cells' other texels.
      from = static_cast<std::int64_t>(std::floor(least)) - 2;
      count = static_cast<std::int64_t>(std::floor(greatest)) + 3 - from;
    };
    span(x, left, width);
    span(y, top, height);
    const auto side = static_cast<double>(std::uint32_t{1} << level);
    origin = {x[0] - static_cast<double>(left), y[0] - static_cast<double>(top)};
    across = {(x[1] - x[0]) / side, (y[1] - y[0]) / side};
    down = {(x[2] - x[0]) / side, (y[2] - y[0]) / side};
    extent = static_cast<double>(std::max(width, height));
    position = 8 * half_ulp * extent;  // six roundings, and room
    const double p = across.x * down.y, q = across.y * down.x;
    area = p - q;
    // docs/ATTRIBUTE_BOUNDS.md, "The area": 6 u of each product.
    area_off = 8 * half_ulp * (std::fabs(p) + std::fabs(q));
  }

  template <class Channel>
  Frame(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level)
      : Frame(source.texture().width, source.texture().height, uv, level) {}

  Point at(std::uint32_t i, std::uint32_t j) const noexcept {
    return {origin.x + i * across.x + j * down.x, origin.y + i * across.y + j * down.y};
  }
  TexelBox box() const noexcept { return {left, top, width, height}; }
};

/// Throws std::invalid_argument outside the domain of AttributeBaker, or if room is not `count`, the number of values.
void check(const BaseTriangle& uv, std::uint32_t level, std::size_t room, std::size_t count);

}  // namespace mmverify::impl::attribute::detail
