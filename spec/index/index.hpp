// The micro-triangle of a point of the base triangle: the index algorithms as their sources print them, over any
// Number.
//
//   reference       the bit formula of the Vulkan specification
//   step            the recursion of Succinct Opacity Micromaps, Algorithm 4, in the readings that the paper
//                   allows
//   corners         the micro-triangle with an index of the curve
//   w_minor_*       the older row order, Color and Attribute Micromaps, figure 4
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "spec/number.hpp"

namespace mmverify::spec::index {

// ---- The Vulkan reference

/// A micro-triangle by its grid square (iu, iv) and iw, a complement from which the curve's bits follow.
template <class Word>
struct Quantised {
  Word iu, iv, iw;
};

/// q clamped to [0, 1].  Domain: every number.
template <Coordinate Q>
constexpr Q within_unit(Q q) {
  const Q zero(0), one(1);
  q = q < zero ? zero : q;
  return one < q ? one : q;
}

/// The grid square for the whole parts iu = floor(uN), iv = floor(vN): both kept below N, and iu lowered until iu+iv <
/// N.  iw = NOT(iu+iv), one less if the point lies in the square's upper half, which the hypotenuse's squares do not
/// have.
/// Domain: iu, iv in [0, N].  Words wrap.
/// Source: VK_EXT_opacity_micromap, appendix "Reference Code".
template <class Word>
constexpr Quantised<Word> grid_square(Word iu, Word iv, bool upper_half, const Word& N) {
  iu = iu < N ? iu : N - 1;
  iv = iv < N ? iv : N - 1;
  const Word s = iu + iv;
  iu = s < N ? iu : iu - (s - N + 1);

  Word iw = ~(iu + iv);
  iw = upper_half && s < N - 1 ? iw - 1 : iw;
  return {iu, iv, iw};
}

/// The grid square of a point given by uN and vN, each in [0, N]; its upper half is uf+vf >= 1.
/// Source: VK_EXT_opacity_micromap, appendix "Reference Code".
template <class Word, Coordinate Q>
constexpr Quantised<Word> quantise_scaled(const Q& un, const Q& vn, const Word& N) {
  const Q one(1), uf = un - Q(whole(un)), vf = vn - Q(whole(vn));
  return grid_square<Word>(whole(un), whole(vn), !(uf + vf < one), N);
}

/// The grid square of a point at level n.
/// Domain: every point (u and v are clamped to [0,1]); n in 0..31. Words wrap.
/// Source: VK_EXT_opacity_micromap, appendix "Reference Code".
template <class Word, Number Q>
constexpr Quantised<Word> quantise(const Point<Q>& p, Level n) {
  const std::uint32_t N = side(n);
  return quantise_scaled<Word>(times(N, within_unit(p.u)), times(N, within_unit(p.v)), Word{N});
}

/// XOR of a word's bits at and above each bit: f_i = XOR of t_j for all j >= i, over the low `bits` bits.
/// Doubling: after the shifts 1, 2, ..., bits/2 each bit has met all above it.  Domain: t below 2^bits.
template <unsigned bits, unsigned shift = 1, class Word>
constexpr Word xor_from_above(Word t) {
  if constexpr (shift < bits) return xor_from_above<bits, 2 * shift>(t ^ t >> shift);
  return t;
}

/// The number of bits of a Word.
template <class Word>
inline constexpr unsigned word_bits = 8 * sizeof(Word);

/// Moves the bits of x to every other bit, from bit 0 up; the rest are zero.  The halves of each group of bits move
/// apart, group by group; ones / (2^shift + 1) masks the lower half of each.  Domain: x below 2^(bits of Word / 2).
template <unsigned shift, class Word>
constexpr Word spread(Word x) {
  const Word halves = ~Word{0} / ((Word{1} << shift) + 1);
  const Word apart = (x | x << shift) & halves;
  if constexpr (shift > 1) return spread<shift / 2>(apart);
  return apart;
}
template <class Word>
constexpr Word spread(Word x) {
  return spread<word_bits<Word> / 4>(x);
}

/// The curve's two bits of every digit, digit = b0 + 2 b1.
template <class Word>
struct CurveBits {
  Word b0, b1;
};

/// b0 = NOT(iu XOR iw), t = (iu XOR iv) AND b0, f = prefix_xor(t), b1 = ((f XOR iu) AND NOT b0) OR t, on the bits of
/// `low`.  All but prefix_xor work on each bit by itself.  Domain: a Quantised of the level of `low`.
/// Source: VK_EXT_opacity_micromap, appendix "Reference Code".
template <class Word, class PrefixXor>
constexpr CurveBits<Word> curve_bits(const Quantised<Word>& q, const Word& low, PrefixXor prefix_xor) {
  const Word b0 = ~(q.iu ^ q.iw) & low;
  const Word t = (q.iu ^ q.iv) & b0;
  const Word f = prefix_xor(t);
  const Word b1 = ((f ^ q.iu) & ~b0) | t;
  return {b0, b1};
}

/// b0 in the even bits, b1 in the odd ones.  Domain: words below 2^(bits of Word / 2).
template <class Word>
constexpr Word interleave(const CurveBits<Word>& bits) {
  return spread(bits.b0) | spread(bits.b1) << 1;
}

/// The curve's index from the grid square; low = N-1.
/// Domain: a Quantised of the same level.  Source: VK_EXT_opacity_micromap, appendix "Reference Code".
template <class Word>
constexpr Word curve(const Quantised<Word>& q, const Word& low) {
  return interleave(curve_bits(q, low, [](const Word& t) { return xor_from_above<word_bits<Word> / 2>(t); }));
}

/// The index of the micro-triangle that contains the point, by the Vulkan formula in 32-bit words.
/// Domain: every point; n in 0..16.  Result in [0, 4^n).  Source: VK_EXT_opacity_micromap, appendix
/// "Reference Code".
template <Number Q>
constexpr std::uint32_t reference(const Point<Q>& p, Level n) {
  return curve(quantise<std::uint32_t>(p, n), side(n) - 1);
}

/// The index as worded in Vulkan's chapter on ray traversal, with u and v scaled by N, which it leaves out: iu =
/// floor(uN) lowered until iu+iv <= N, iv = floor(vN); the rest as the reference code.  N is one too many: see
/// docs/ERRATA.md.
/// Domain: u, v >= 0, u+v <= 1; n in 0..16.
/// Source: VK_EXT_opacity_micromap, section "Ray Opacity Micromap"; VK_KHR_opacity_micromap has the same words.
template <Number Q>
constexpr std::uint32_t as_the_prose_says(const Point<Q>& p, Level n) {
  const std::uint32_t N = side(n);
  const Q one(1), un = times(N, within_unit(p.u)), vn = times(N, within_unit(p.v));
  std::uint32_t iu = whole(un);
  const std::uint32_t iv = whole(vn);
  const bool upper_half = !(un - Q(iu) + (vn - Q(iv)) < one);
  iu = iu + iv <= N ? iu : N - iv;
  std::uint32_t iw = ~(iu + iv);
  iw = upper_half && iu + iv < N - 1 ? iw - 1 : iw;
  return curve(Quantised<std::uint32_t>{iu, iv, iw}, N - 1);
}

/// The index by the same formula in 64-bit words, its prefix XOR over all n bits.  Domain: every point; n in 0..31.
template <Number Q>
constexpr std::uint64_t reference_wide(const Point<Q>& p, Level n) {
  return curve(quantise<std::uint64_t>(p, n), std::uint64_t{side(n)} - 1);
}

// ---- The step algorithm

/// The readings of Succinct Opacity Micromaps: Algorithm 4 as printed, or with one change from Appendix A or Algorithm 3.
enum class Reading {
  printed,          ///< Algorithm 4
  appendix_middle,  ///< M's new coordinates in the order u_M, v_M, w_M of Appendix A (2)
  appendix_ties,    ///< "round u and v tie-breaks to the middle": the R test's exception is on u, Appendix A
                    ///< (3)
  appendix_names,   ///< L, R and T move to the coordinates that Appendix A (2) gives under these letters
  restarted,        ///< each node calls step(u, v) with the point's own u and v, as Algorithm 3 does
};

/// The recursion's arguments: barycentrics on the current triangle, the digits so far, the two flips.
template <Coordinate Q, class Index = std::uint32_t>
struct Step {
  Q u, v, w;
  Index index = 0;
  bool mid_flip = false, top_flip = false;
};

/// The opening of uv2index: w = 1-u-v, no digit yet, nothing flipped.
template <Coordinate Q, class Index = std::uint32_t>
constexpr Step<Q, Index> first_step(const Point<Q>& p) {
  return {p.u, p.v, Q(1) - p.u - p.v};
}

/// One call of `step`: the one of L, M, R, T that contains the point, its digit, and the point's barycentrics on it.
/// Comparisons with 1/2 are made on doubled coordinates, which is exact in every binary number type.
/// Source: Succinct Opacity Micromaps, Algorithm 4; the readings, Appendix A and Algorithm 3.
template <Reading reading, Coordinate Q, class Index>
constexpr Step<Q, Index> next_step(const Step<Q, Index>& s) {
  const Q &u = s.u, &v = s.v, &w = s.w;
  if constexpr (reading == Reading::restarted)
    return {u, v, w, 4 * s.index + next_step<Reading::printed>(Step<Q, Index>{u, v, w}).index};
  const bool mid_flip = s.mid_flip, top_flip = s.top_flip;
  const std::uint32_t L = top_flip ? 2 : 0, M = 1, R = top_flip ? 0 : 2, T = 3;
  const Q one(1), u2 = times(2, u), v2 = times(2, v), w2 = times(2, w);
  const bool u_tie = u2 == one, v_tie = v2 == one;

  const auto w_corner = [&](std::uint32_t digit, bool top) {
    return Step<Q, Index>{u2, v2, w - u - v, 4 * s.index + digit, mid_flip, top};
  };
  const auto v_corner = [&](std::uint32_t digit, bool top) {
    return Step<Q, Index>{u2, v - u - w, w2, 4 * s.index + digit, mid_flip, top};
  };
  const auto u_corner = [&](std::uint32_t digit, bool top) {
    return Step<Q, Index>{u - v - w, v2, w2, 4 * s.index + digit, mid_flip, top};
  };
  constexpr bool renamed = reading == Reading::appendix_names;

  if (one < w2) return renamed ? u_corner(L, top_flip) : w_corner(L, top_flip);
  if (!(v2 < one) && !(v_tie && mid_flip)) return renamed ? w_corner(T, !top_flip) : v_corner(T, !top_flip);
  const bool r_exception = (reading == Reading::appendix_ties ? u_tie : v_tie) && mid_flip;
  if (!(u2 < one) && !r_exception) return renamed ? v_corner(R, top_flip) : u_corner(R, top_flip);
  const Q mu = u + v - w, mv = v + w - u, mw = w + u - v;
  if constexpr (reading == Reading::appendix_middle)
    return {mu, mv, mw, 4 * s.index + M, !mid_flip, top_flip};
  return {mu, mw, mv, 4 * s.index + M, !mid_flip, top_flip};
}

/// The index of the micro-triangle that contains the point, by Algorithm 4.
/// Domain: u, v >= 0, u+v <= 1; n in 0..16, in 64-bit words 0..31.  Result in [0, 4^n).
template <Reading reading, class Index = std::uint32_t, Number Q>
constexpr Index step(const Point<Q>& p, Level n) {
  Step<Q, Index> s = first_step<Q, Index>(p);
  for (Level depth = 0; depth < n; ++depth) s = next_step<reading>(s);
  return s.index;
}

// ---- From the index back to the micro-triangle

/// A micro-vertex (i/N, j/N): i counts along u, j along v.
struct Vertex {
  std::uint32_t i, j;
  friend constexpr bool operator==(const Vertex&, const Vertex&) = default;
};

/// Three corners, in the order of the children that touch them: child 0, child 2, child 3 (child 1 is the
/// middle).
using Corners = std::array<Vertex, 3>;

/// The corners of child `digit` of a triangle P = (w-corner, u-corner, v-corner), with P_ab the midpoint of P_a and P_b:
///   0: (P0, P01, P02)   1: (P02, P12, P01)   2: (P01, P1, P12)   3: (P12, P02, P2)
/// At: a pair of whole numbers i and j.  Domain: digit in 0..3; sums of two corners' numbers are even.
template <class At>
constexpr std::array<At, 3> corners_turn(const std::array<At, 3>& P, std::uint32_t digit) {
  const auto mid = [&P](std::size_t a, std::size_t b) {
    return At{(P[a].i + P[b].i) / 2, (P[a].j + P[b].j) / 2};
  };
  const At P01 = mid(0, 1), P02 = mid(0, 2), P12 = mid(1, 2);
  switch (digit) {
    case 0: return {P[0], P01, P02};
    case 1: return {P02, P12, P01};
    case 2: return {P01, P[1], P12};
    default: return {P12, P02, P[2]};
  }
}

/// The corners of the micro-triangle with an index, on the grid of level n: child by child, highest digit first.
/// Domain: index in [0, 4^n), n in 0..16.
/// Source: Succinct Opacity Micromaps, Algorithm 4, each case's map inverted; top-flip becomes the order of
/// P0 and P1.
constexpr Corners corners(std::uint32_t index, Level n) {
  const std::uint32_t N = side(n);
  Corners P{Vertex{0, 0}, Vertex{N, 0}, Vertex{0, N}};
  for (Level depth = n; depth-- > 0;) P = corners_turn(P, index >> (2 * depth) & 3);
  return P;
}

// ---- Row order

/// The lesser of floor(q) and limit.
template <class Word, Coordinate Q>
constexpr Word whole_up_to(const Word& limit, const Q& q) {
  const Word k = whole(q);
  return k < limit ? k : limit;
}

/// A micro-triangle in row order: its row counted from the w-corner, and its place in the row by v (col) and by u
/// (dia).
template <class Word>
struct RowPlace {
  Word row, col, dia;
};

/// The place of a point given by (1-w)N, vN and (1-u)N:
///   row = min(N-1, floor((1-w)N)), col = min(row, floor(vN)), dia = min(N-1, floor((1-u)N)).
/// Domain: vN and (1-u)N in [0, N], (1-w)N in [0, 2N].
/// Source: Color and Attribute Micromaps, figure 4, wminor_uv2triangle_index.
template <class Word, Coordinate Q>
constexpr RowPlace<Word> w_minor_place(const Q& beyond_w, const Q& vn, const Q& beyond_u, const Word& N) {
  const Word last = N - 1;
  const Word row = whole_up_to<Word>(last, beyond_w);
  return {row, whole_up_to<Word>(row, vn), whole_up_to<Word>(last, beyond_u)};
}

/// The place of a micro-triangle along its row: col + (dia - (N-1-row)).
template <class Word>
constexpr Word along_row(const RowPlace<Word>& p, const Word& N) {
  return p.col + (p.dia - (N - 1 - p.row));
}

/// The index in row order: row^2 + along_row() of the place.
/// Domain: u, v >= 0, u+v <= 1; n in 0..16.  Result in [0, 4^n).
/// Source: Color and Attribute Micromaps, figure 4, wminor_uv2triangle_index.
template <Number Q>
constexpr std::uint32_t w_minor(const Point<Q>& p, Level n) {
  const std::uint32_t N = side(n);
  const Q one(1), w = one - (p.u + p.v);
  const auto place = w_minor_place<std::uint32_t>(times(N, one - w), times(N, p.v), times(N, one - p.u), N);
  return place.row * place.row + along_row(place, N);
}

/// r^2, the number of micro-triangles in the rows before row r.
template <class Word>
constexpr Word square(const Word& r) {
  return r * r;
}

/// One bit of a root: r + bit if its square is x or less, else r.
/// r^2 <= x < (r + 2 bit)^2 before it, and r^2 <= x < (r + bit)^2 of the new r after it.
template <class Word>
constexpr Word square_root_turn(const Word& x, const Word& r, const Word& bit) {
  return x < square(r + bit) ? r : r + bit;
}

/// The row of an index of row order: the greatest row with row^2 <= index.
/// Domain: every index.  Source: Color and Attribute Micromaps, figure 4, with the square root taken in integers.
constexpr std::uint32_t w_minor_row(std::uint32_t index) {
  std::uint64_t row = 0;
  for (std::uint64_t bit = 1u << 15; bit != 0; bit /= 2)
    row = square_root_turn(std::uint64_t{index}, row, bit);
  return static_cast<std::uint32_t>(row);
}

/// The corners of the micro-triangle with an index of row order in its row, in the order v0, v1, v2 of the source.
/// A (row, column) vertex lies at i = row - column along u, j = column along v.
/// Domain: index in [0, 4^n), row = w_minor_row(index).
/// Source: Color and Attribute Micromaps, figure 4, wminor_uv2vertex_index.
constexpr Corners w_minor_corners_in(std::uint32_t row, std::uint32_t index) {
  const std::uint32_t col = index - row * row;
  const auto at = [](std::uint32_t r, std::uint32_t c) { return Vertex{r - c, c}; };
  if (col % 2 == 0) return {at(row, col / 2), at(row + 1, col / 2), at(row + 1, col / 2 + 1)};
  return {at(row, col / 2), at(row + 1, col / 2 + 1), at(row, col / 2 + 1)};
}

/// The same from the index alone.
constexpr Corners w_minor_corners(std::uint32_t index) {
  return w_minor_corners_in(w_minor_row(index), index);
}

}  // namespace mmverify::spec::index
