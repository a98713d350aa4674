// The centres of texels within a triangle, and the mixed cells that it meets, several rows at a time.  Internal to
// impl/bake.
#pragma once

#include <cstddef>
#include <cstdint>

#include "impl/bake/marks.hpp"
#include "impl/bake/plane/points.hpp"

namespace mmverify::impl::bake::detail {

/// Bits of a window of texels, in the strips of planes (impl/bake/texture/plane.hpp).
struct WindowBits {
  /// Row 0 of the strip of column 0, which is at `bit` of its word.  visible is opaque with MASK.
  const std::uint32_t *opaque, *visible;
  std::size_t strip;
  std::uint32_t bit;
  std::int64_t left, top;  ///< the window's first texel
  std::int32_t columns;    ///< texels in a row of it
  bool has_cells;          ///< it holds all texels of the cells that the triangle meets
};

/// The cells of a triangle: each between the centres of four texels, and mixed unless its texels are all opaque or none
/// of them is visible.
struct TriangleBits {
  Marks centres = 0;        ///< the marks of the texels whose centres are within
  bool meets_mixed = true;  ///< it may meet a mixed cell; so may a triangle of which not all cells were asked
  bool begins_opaque = false;  ///< a cell that it may meet has an opaque first texel
};

/// Looks at rows until all `wanted` marks are found; the cells of the others are not asked then.
/// T is a true triangle, p the computed one, its corners within delta of T's along either axis.
///   crossing  of an edge by a row: off by less than delta along x.  No edge is evaluated beyond its ends, so five roundings
///             of 2^-53 of its extent, which is twice the greatest coordinate at most, and one of the sum are less than
///             11 2^-53 of that coordinate; delta is 22 2^-53 of it or more (impl/bake/mip.cpp).
///   centres   on row j are those from ceil(x) to floor(x') of the two crossings.  Those that rounding leaves out, or takes
///             in, are within delta of an edge of p.
///   cells     T's part in j <= y <= j + 1 is within delta, along both axes, of p's part in
///             j - delta <= y <= j + 1 + delta.  Its least and greatest x are at a crossing of one of the two levels, or at
///             a corner between them.  2 delta has room for the roundings.  So each cell that T meets is among those looked at.
/// A flat triangle, all of it on one row, has no centre here, for its edges have them, and may meet a mixed cell.
/// Domain: the window holds all centres in p; a plane has 8 rows beyond it.
/// Test: impl_bake_cells_test
TriangleBits bits_within(const Triangle& p, const WindowBits& bits, double delta, Marks wanted);

}  // namespace mmverify::impl::bake::detail
