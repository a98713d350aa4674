// A node of sixteen micro-triangles at once, in binary32 and SIMD: what is certain of each.  Internal to
// impl/bake*.
//
// Coordinates are local: texels from a whole texel near by, none beyond S <= 96 of it in size.  A
// micro-vertex is
//   p0 + i/4 (p1 - p0) + j/4 (p2 - p0),   i + j <= 4
// of a rounded corner and the base triangle's sides, cut to a node's and rounded; nine roundings of 2^-24 S
// or less, those of p0, p1 - p0, p2 - p0 and of thirds among them, leave it, and a centroid, within 2^-20 S
// of its place along either axis.  Another corner, or an end, taken from one by what all micro-triangles or
// edges have in common (bake_sixteen_shape.hpp), is off by no more: five of the nine are made. delta is that
// and what coordinates in binary64 were off; T is a true triangle, T' the computed one, R as in
// bake_filter.hpp.
//
// The latter is less than 2^-30, so that slopes (bake_lines.hpp) put no line off by more than 2^-21 (1 + |s|)
// over the rows here.
//
//   cells    As in bake_cells.hpp: where T meets no mixed cell, its texels bear one mark, and so does it.
//            Lines go through the computed corners; with the roundings of this they are within
//            2 delta (1 + |s|) along x, and 4 delta (1 + |s|) more than that.
//   samples  g changes by at most R a texel along either axis, and its evaluation errs by less than 2^-19 R:
//            beyond bound = R (2 delta + 2^-19) its marks are certain.
//   centres  between the lines, each within 2 delta (1 + |s|) of its edge along x and so within 3 delta of
//            it: g at a point of T differs by less than 6 R delta.  They count as seen where clear, the least
//            that a texel is from its limit, is more than 8 R delta.  Those left out are within 3 delta of an
//            edge, which speaks for them to within its bound.
//   edges    In the mixed cells that they may meet alone, for the reasons in bake_cells.hpp: those within
//            2^4 delta (1 + |s|) of the edge's line and 4 delta of its box; s is rounded once, off by less
//            than 2^3 delta (1 + |s|) with what sides are off, where it falls by a quarter of a texel or
//            more, and no line bounds it where it falls by less.
//   pieces   as there, delta in place of its delta: a cell's own alpha is off g by less than 12 R delta, the
//            true edge's by 2 R delta more, and roundings are less than 2^-18 R: less than
//            edge_bound = R (24 delta + 2^-17).
// What neither a corner, nor a piece, nor a centre within bears, T does not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "impl/bake_sixteen_shape.hpp"

namespace mmverify::impl::bake::detail {

/// Rows and columns of texels that a node may span.
inline constexpr std::int64_t sixteen_window = 96;

struct SixteenInput {
  const SixteenShape* shape;
  /// That at the local origin; what is 4 bytes from those asked for can be read.
  const void* texels;
  std::int32_t pitch;
  std::int32_t columns, rows;  ///< of texels in the window
  std::array<float, 2> p0;     ///< x, y
  /// Words of a plane (bake_plane.hpp): row 0 of the strip that column 0 is in, at `bit`; visible is opaque
  /// with MASK.
  const std::uint32_t *opaque, *visible;
  std::size_t strip;
  std::uint32_t bit;
};

/// Bit k of each: micro-triangle k of the sixteen.
struct SixteenMarks {
  std::uint32_t below = 0, opaque = 0;              ///< certain
  std::uint32_t lacks_below = 0, lacks_opaque = 0;  ///< certainly no alpha of it bears the mark
  std::uint32_t by_texels = 0;                      ///< of these, those whose texels said so
  std::uint32_t leans_to_opaque = 0, leans = 0;     ///< of those that bear both, how; that it is certain
  std::uint32_t leaves = 0;                         ///< how many are decided, and not by texels
};

/// Of sixteen nodes, the parts of a larger one as micro-triangles are: those that meet no mixed cell.
struct SixteenNodes {
  bool known = false;
  std::uint32_t of_one_mark = 0, opaque = 0;
};
/// No texel is read.
SixteenNodes sixteen_nodes(const SixteenInput& input);

/// Texel: std::uint8_t or std::uint16_t.
template <class Texel>
SixteenMarks sixteen(const SixteenInput& input);

}  // namespace mmverify::impl::bake::detail
