// How large a node's coordinates are, what vectors are off with them, and the bounds that follow: all are derived in
// docs/BAKE_SIXTEEN.md.  Internal to impl/bake.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "impl/bake/plane/points.hpp"
#include "impl/bake/sixteen/shape.hpp"

namespace mmverify::impl::bake::detail {

/// The texels about a node, ends included: those of the cells that its box meets, and one more all round for what
/// binary32 is off.
struct SixteenWindow {
  std::int64_t left, right, top, bottom, width, height, size;

  /// Box: that of BilinearFilter (impl/bake/judge/filter.hpp).
  template <class Box>
  explicit SixteenWindow(const Box& box) noexcept
      : left(box.left - 1),
        right(box.right + 1),
        top(box.top - 1),
        bottom(box.bottom + 1),
        width(right - left + 1),
        height(bottom - top + 1),
        size(std::max(width, height)) {}

  /// A place, from texel (left, top).
  std::array<float, 2> local(PlanePoint p) const noexcept {
    return {static_cast<float>(p.x - static_cast<double>(left)),
            static_cast<float>(p.y - static_cast<double>(top))};
  }
};

/// S = extent + 6: no coordinate in the window of a node is larger, that of its last texel included.  Whole texels, one
/// more on each side, and one to spare.
constexpr double sixteen_size(double extent) { return extent + 6; }
/// delta = delta64 + 2^-20 S: what a place is off along either axis; delta64: what it is off in binary64.
constexpr double sixteen_delta(double size, double delta64) { return delta64 + 0x1p-20 * size; }
/// 2^-18 S + 2^10 delta64 >= 4 delta: how far lines, times 1 + |s|, and boxes are moved out.
constexpr double sixteen_margin(double size, double delta64) { return 0x1p-18 * size + 0x1p10 * delta64; }

/// Of a shape, what stored numbers are off.
/// scale: R, the greatest difference of two; clear: how far they are from their limits, at least.
inline void take_bounds(SixteenShape& of, double scale, double clear, double delta) noexcept {
  of.bound = static_cast<float>(scale * (2 * delta + 0x1p-19));
  of.edge_bound = static_cast<float>(scale * (24 * delta + 0x1p-17));
  of.beyond_bound = static_cast<float>(scale * (0x1p5 * delta + 0x1p-14));
  of.clear = clear > 8 * delta * scale;
}

}  // namespace mmverify::impl::bake::detail
