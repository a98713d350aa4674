// A node of sixteen micro-triangles at once, in binary32 and SIMD: the certain marks of each.  Internal to impl/bake.
//
// Coordinates are local: texels from a whole texel nearby, none beyond S <= 96 of it in size.  A micro-vertex is
//   p0 + i/4 (p1 - p0) + j/4 (p2 - p0),   i + j <= 4
// of a rounded corner and the base triangle's sides, cut to a node's and rounded.  Nine roundings of 2^-24 S or less,
// those of p0, p1 - p0, p2 - p0 and of thirds among them, leave it, and a centroid, within 2^-20 S of its place along
// either axis.  Another corner, or an end, computed from it by the common shape (impl/bake/sixteen/shape.hpp), is off
// by no more: five of the nine are made.  delta is 2^-20 S plus delta64, the error of coordinates in binary64.  T is a
// true triangle, T' the computed one, R as in impl/bake/judge/filter.hpp.
//
// delta64 is less than 2^-30, so that slopes (impl/bake/plane/lines.hpp) move no line by more than 2^-21 (1 + |s|) over
// the rows here.
//
// A cell is mixed unless its four texels are all opaque, or none of them is visible (not transparent; with MASK that is
// opaque).  A cell that is not mixed bears one mark, since only cells whose four texels differ contain a contour.
//
//   cells    Every cell that T meets is in a row that T reaches, and between the lines moved out by a margin.  If no
//            cell that may be met is mixed, all of T bears one mark: cells that share a corner share a texel.
//            A point on a cell's border counts for the cell to the right and below.
//            Lines go through the computed corners.  With their roundings they are off by less than 2 delta (1 + |s|)
//            along x; the margin is 4 delta (1 + |s|).
//   samples  g changes by at most R a texel along either axis, and its evaluation errs by less than 2^-19 R:
//            beyond bound = R (2 delta + 2^-19) its marks are certain.
//   centres  between the lines, each off by less than 1.6 delta (1 + |s|) along x, and in T's rows and columns:
//            within 1.6 delta of T along either axis, beside a flat edge twice that, so that g at a point of T
//            differs by less than 6.4 R delta.  They count as seen if clear, the least distance of a texel from
//            its limit, is more than 8 R delta.  Centres left out are within 3 delta of an edge, which bears
//            their marks to within its bound.
//   edges    Every mark of T is borne on an edge or at a centre within (impl/bake/exact/seen.hpp).  Along an
//            edge, from the first corner on, a mark begins only in a mixed cell, since cells with a common
//            border share the texels that decide alpha on it.  So only mixed cells are judged: those within
//            2^4 delta (1 + |s|) of the edge's line and 4 delta of its box.  s is rounded once and off by less
//            than 2^3 delta (1 + |s|) with the sides' errors, if the edge falls by a quarter of a texel or
//            more; if it falls by less, no line bounds it.
//   pieces   The edge is P + t (Q - P), t from where it enters the cell, grown to every side, to where it
//            leaves it, so that all t of the true edge in the true cell are among them.  There the cell's own
//            alpha a + bx + cy + dxy is least and greatest at an end or where it stands still
//            (impl/bake/judge/filter.hpp, walked()).  A cell's own alpha is off g by less than 12 R delta, the
//            true edge's by 2 R delta more, and roundings are less than 2^-18 R: less than
//            edge_bound = R (24 delta + 2^-17).
// A mark that neither a corner, nor a piece, nor a centre within bears, T lacks.
//
// Micro-triangles less than 2.5 texels wide and high, which meet few mixed cells, need no pieces for most:
//   beyond   Each mixed cell's own alpha g_C = a + bx + cy + dxy is continued beyond it over all of T.  It is
//            least and greatest on T's edges, and along one, from v to w,
//              g_C = v + (w - v) s - K s (1 - s) >= min(v, w) - max(K, 0) / 4,   K = d dx dy,
//            so that its values at T's corners, less the greatest max(K, 0) / 4, bound it from below; from
//            above likewise.  T is within 2.5 texels of a cell that it meets, where g_C changes by less than
//            6 R a texel along either axis: corners are off by 12 R delta, K / 4 by 5 R delta, and roundings
//            of values below 2^5 R are less than 2^-15 R: less than
//            beyond_bound = R (2^5 delta + 2^-14).
//            If g_C is beyond that in each mixed cell that T may meet, T's part in these lacks a mark.  The rest of T
//            is in cells of one mark each.  If one of these bore that mark, T would be two closed sets without a common
//            point; but T is connected.  So if a corner of T lacks the mark, too, all of T lacks it.  A cell that T
//            only seems to meet can leave the question open, but gives no wrong answer.
//   single   A cell where g_C is not beyond is judged alone.  T's part in it is bounded by pieces of T's edges and
//            of the cell's own; one bilinear alpha is least and greatest there, and on the cell's own edges
//            where their pieces end: at a centre, or on an edge of T.  If neither a piece of T's edges in
//            that cell bears the mark, nor a centre within, T's part in it lacks it, as if g_C were beyond.
// A mark that T is known to bear is not looked for.
//   places   A micro-vertex, or centroid, more than 2 delta from its cell's border is truly in it: if the cell is
//            not mixed, the place bears its texels' mark.  Nearer it does if, with one limit, clear is more than
//            8 R delta: alpha of the cell is that far from the limit, and differs by 2 R delta.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "impl/bake/sixteen/shape.hpp"

namespace mmverify::impl::bake::detail {

/// Rows and columns of texels that a node may span.
inline constexpr std::int64_t sixteen_window = 96;

struct SixteenInput {
  const SixteenShape* shape;
  /// The texel at the local origin; 4 bytes from each texel of the window on can be read.
  const void* texels;
  std::int32_t pitch;
  std::int32_t columns, rows;  ///< texels in the window
  std::array<float, 2> p0;     ///< x, y
  /// Words of a plane (impl/bake/texture/plane.hpp): row 0 of the strip of column 0, at `bit`.  visible is opaque with
  /// MASK.
  const std::uint32_t *opaque, *visible;
  std::size_t strip;
  std::uint32_t bit;
};

/// Marks of micro-triangles: bit k for micro-triangle k of the sixteen.
struct SixteenMarks {
  std::uint32_t below = 0, opaque = 0;              ///< certain marks
  std::uint32_t lacks_below = 0, lacks_opaque = 0;  ///< no alpha of it bears the mark, certainly
  std::uint32_t by_texels = 0;                      ///< those of them that texels alone decided
  std::uint32_t leans_to_opaque = 0, leans = 0;     ///< the centroid leans to opaque; its lean is certain
  std::uint32_t leaves = 0;                         ///< number of micro-triangles decided, and not by texels
};

/// Marks of sixteen nodes, which are the parts of a larger one as micro-triangles are: those that meet no mixed cell.
struct SixteenNodes {
  bool known = false;
  std::uint32_t of_one_mark = 0, opaque = 0;
};
/// The marks of sixteen nodes from bits alone; no texel is read.
SixteenNodes sixteen_nodes(const SixteenInput& input);

/// One of several nodes in a window; it replaces the input's shape and p0.
struct SixteenNode {
  const SixteenShape* shape;
  std::array<float, 2> p0;
};
/// Writes the marks of nodes[n] to marks[n].
/// Texel: std::uint8_t or std::uint16_t.
template <class Texel>
void sixteen(const SixteenInput& input, std::span<const SixteenNode> nodes, SixteenMarks* marks);

}  // namespace mmverify::impl::bake::detail
