// A node of sixteen micro-triangles at once, in binary32 and SIMD: what is certain of each.  Internal to
// impl/bake*.
//
// Coordinates are local: texels from a whole texel near by, none beyond S of it in size.  A micro-vertex is
//   p0 + i/4 (p1 - p0) + j/4 (p2 - p0),   i + j <= 4
// of three rounded corners; nine roundings of 2^-24 S or less, those of p0, p1 - p0, p2 - p0 and of thirds
// among them, leave it, and a centroid, within 2^-20 S of its place along either axis.  delta is that and
// what the corners in binary64 were off; T is a true triangle, T' the computed one.
//
//   cells    whose four texels bear one mark: so does the sample, by `clear` or more.  Where that is more
//   than
//            8 R delta, the true place, within delta, bears it, too.
//   samples  g changes by at most R a texel along either axis (bake_filter.hpp), and its evaluation errs by
//            less than 2^-19 R: beyond bound = R (2 delta + 2^-19) its marks are certain.
//   texels   of all cells that the box about T', grown by 2 delta, meets: what they do not bear T does not.
//   edges    are walked as in bake_filter.hpp; along one that moves by less than delta along an axis, that
//            coordinate is taken not to move.  On a piece from v to w, g is within |K| / 4 of what is between
//            v and w, K = d dx dy of the piece.  A cut, and so a piece that is lost or judged by its
//            neighbour's cell, is off by some delta: edge_bound = R (24 delta + 2^-17) is beyond what that
//            and the evaluation change.
//   centres  on a row between computed crossings, each within delta of its edge at a y within delta of the
//            row, are within 2 delta of T' and 3 of T: g at a point of T differs by less than 6 R delta. They
//            count as seen where clear, the least that a texel is from its limit, is more than 8 R delta.
//            Those left out are within 3 delta of an edge, which speaks for them to within its bound.
// What neither an edge nor a centre within bears, T does not (bake_exact.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mmverify::impl::bake::detail {

/// Rows and columns of texels that a node may span for more than samples to be taken.
inline constexpr std::int64_t sixteen_window = 32;

struct SixteenInput {
  /// That at the local origin; what is 4 bytes from those asked for can be read.
  const void* texels;
  std::int32_t pitch;
  std::array<float, 2> p0, p01, p02;  ///< x, y; the latter two from p0
  float threshold, gap, lean, bound, edge_bound, delta;
  /// Bit x of row y: opaque; not transparent.  None where the window is too small.
  const std::uint32_t *rows_opaque, *rows_visible;
  /// Else: the texture's, row 0 of the window at this byte, its column 0 at bit_x, rows bit_pitch bytes
  /// apart.
  const std::uint8_t *bits_opaque, *bits_visible;
  std::int32_t bit_x, bit_pitch;
  bool clear;
  /// Whether only the union of the sixteen is asked for: no more than `below` and `opaque` where both are
  /// borne.
  bool as_one;
};

/// Bit k of each: micro-triangle k of the sixteen.
struct SixteenMarks {
  std::uint32_t below = 0, opaque = 0;              ///< certain
  std::uint32_t lacks_below = 0, lacks_opaque = 0;  ///< certainly no alpha of it bears the mark
  std::uint32_t by_texels = 0;                      ///< of these, those whose texels said so
  std::uint32_t leans_to_opaque = 0, leans = 0;     ///< of those that bear both, how; that it is certain
};

/// Texel: std::uint8_t or std::uint16_t.
template <class Texel>
SixteenMarks sixteen(const SixteenInput& input);

}  // namespace mmverify::impl::bake::detail
