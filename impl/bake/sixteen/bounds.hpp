// The size of a node's coordinates, the errors of vectors with them, and the bounds that follow: docs/BAKE_SIXTEEN.md
// derives them all.  Internal to impl/bake.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "impl/bake/plane/points.hpp"
#include "impl/bake/sixteen/shape.hpp"

namespace mmverify::impl::bake::detail {

/// The texels about a node, ends included: those of the cells that its box meets, and one more all round for rounding.
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

  /// A place, counted from texel (left, top).
  std::array<float, 2> local(PlanePoint p) const noexcept {
    return {static_cast<float>(p.x - static_cast<double>(left)),
            static_cast<float>(p.y - static_cast<double>(top))};
  }
};

/// S = extent + 6: the largest coordinate in a node's window, that of its last texel included.  It counts whole texels,
/// one more on each side, and one to spare.
constexpr double sixteen_size(double extent) { return extent + 6; }
/// delta = delta64 + 2^-20 S: the error of a place along either axis; delta64: its error in binary64.
constexpr double sixteen_delta(double size, double delta64) { return delta64 + 0x1p-20 * size; }
/// 2^-18 S + 2^10 delta64 >= 4 delta: lines are moved out by this times 1 + |s|, boxes by this.
constexpr double sixteen_margin(double size, double delta64) { return 0x1p-18 * size + 0x1p10 * delta64; }

/// Writes a shape's bounds on the errors of stored numbers.
/// scale: R, the greatest difference of two stored numbers; clear: their least distance from their limits.
inline void take_bounds(SixteenShape& of, double scale, double clear, double delta) noexcept {
  of.bound = static_cast<float>(scale * (2 * delta + 0x1p-19));
  of.edge_bound = static_cast<float>(scale * (24 * delta + 0x1p-17));
  of.beyond_bound = static_cast<float>(scale * (0x1p5 * delta + 0x1p-14));
  of.clear = clear > 8 * delta * scale;
}

}  // namespace mmverify::impl::bake::detail
