// A triangle of many texels, by rows of bits: only cells whose four texels differ can hold a contour, and
// they are few.  Internal to impl/bake.
//
// A cell is mixed unless its four texels are all opaque, or none of them is visible (not transparent; with
// MASK that is opaque): one that is not bears one mark.  T is the triangle, closed; lines, margins and T' are
// those of bake_lines.hpp, D its margin, delta what corners are off.
//
//   met      Every cell that T meets is in a row from floor(min y - D) to floor(max y + D), between the lines
//            a margin outside at their least and greatest over that row: sum of the line at the row's top and
//            of min(s, 0), or max(s, 0).  A point on a cell's border counts for the cell to the right and
//            below.  If no cell that may be met is mixed, all of T bears one mark, since cells that share a
//            corner share a texel.
//   within   A centre between the lines a margin inside, and beyond a flat edge by D, is within T: if centres
//            of both marks are, T bears both.
//   edges    What T bears it bears on an edge or at a centre within (bake_exact.hpp).  Along an edge, from
//            the first corner on, a mark begins only in a mixed cell: cells with a border in common share the
//            texels that say what is on it.  So a mark that neither a corner bears, nor a piece of an edge in
//            a mixed cell, nor a centre that may be within - between the lines a margin outside -, T does not
//            bear.
//   pieces   In binary64.  The edge is P + t (Q - P); t from where it enters the cell, grown by 4 delta to
//            every side, to where it leaves it.  Each of t's ends is off by three roundings of a coordinate
//            difference, less than delta along the axis that it is taken from, so that all t of the true edge
//            in the true cell are among them, and no point between is farther than 6 delta from the cell.
//            There the cell's own a + bx + cy + dxy is off g by less than 2^4 R delta, as g changes by R a
//            texel at most: less than half of the bound of bake_filter.hpp, R (2^5 delta + 2^-43), the other
//            half of which is for roundings and the true edge's delta.  Between values v and w at the ends
//            it is least and greatest at one of them or where it stands still (bake_filter.hpp, walked()).
// A mark is borne where a value is beyond the bound, and lacked where all values are beyond it on the other
// side; else nothing is certain.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "impl/bake/judge/codes.hpp"
#include "impl/bake/plane/spot.hpp"

namespace mmverify::impl::bake::detail {

/// The cells about a triangle: `columns` by `rows` from the origin of what is local here.
struct CellWindow {
  /// The most along either axis.
  static constexpr std::int32_t most = 93;

  /// Words of a plane (bake_plane.hpp): row 0 of the strip that column 0 is in, at `bit`; visible is opaque
  /// with MASK.
  const std::uint32_t *opaque, *visible;
  std::size_t strip;
  std::uint32_t bit;
  std::int32_t columns, rows;
  /// The lines A, B, C: at row 0; what a row adds; margins.
  std::array<float, 3> at, slope, margin;
  bool ab_left;
};

template <class Texel>
struct CellTriangle {
  Triangle p;           ///< local
  double top, bottom;   ///< rows within are between these
  const Texel* texels;  ///< that at the origin
  std::size_t pitch;
  double threshold, gap, bound, delta, margin;  ///< margin: D
};

/// The marks that the triangle bears: one if no other, or both; else uncertain.
/// `texels_say_so` where no mixed cell is met.
/// Texel: std::uint8_t, std::uint16_t or float.
template <class Texel>
Marks judged(const CellWindow& window, const CellTriangle<Texel>& triangle, bool& texels_say_so);

}  // namespace mmverify::impl::bake::detail
