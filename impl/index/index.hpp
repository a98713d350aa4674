// The micro-triangle of a point of the base triangle, and the corners of a micro-triangle: exact answers for binary32
// input, in a handful of instructions.
//
//   from_barycentrics   index on the curve of the Vulkan specification
//   corners             the micro-triangle that carries an index of the curve
//   w_minor             index in row order (Gruen et al.)
//   w_minor_corners     the micro-triangle that carries an index of row order
//
// Each function has two forms, which give the same bits: in this header for a single value, which a compiler may also
// evaluate; for spans, in SIMD chosen at run time.
// IEEE arithmetic must be rounded to nearest, the default (no -ffast-math).  Flushing subnormals to zero changes no
// answer: a subnormal u or v completes no sum to 1, and before the first grid line dia is N-1 with or without it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "impl/common/bits.hpp"

namespace mmverify::impl::index {

/// A subdivision level n; N = 2^n micro-triangles to a side.  Every function here takes max_level for a greater level.
using Level = std::uint32_t;

/// The specification's limit, and the last level whose 4^n indices fit 32 bits.
inline constexpr Level max_level = 16;

/// A micro-vertex (i/N, j/N): i counts along u, j along v.
struct Vertex {
  std::uint32_t i, j;
  friend constexpr bool operator==(const Vertex&, const Vertex&) = default;
};

/// Three corners; on the curve in the order of the children that touch them: child 0, child 2, child 3.
using Corners = std::array<Vertex, 3>;

/// Corners of many micro-triangles: corner c of triangle k is (i<c>[k], j<c>[k]).
struct CornerSpans {
  std::span<std::uint32_t> i0, j0, i1, j1, i2, j2;
};

namespace detail {

// The steps from two floats to an index.  F, Signed, Word and Wide are float and integers of 32 and 64 bits, or a
// prover's types: the law `index.floats` runs these very templates on them.

/// x clamped to [0,1].  NaN and everything at or below zero become +0: std::max returns its first argument unless 0 <
/// x.
template <class F>
constexpr F clamped(F x) noexcept {
  return std::min(std::max(F(0.0f), x), F(1.0f));
}

/// x N for a clamped x, exact since N = 2^n is a power of two.  n in 0..30.
template <class F>
constexpr F scaled(F x, F N) noexcept {
  return clamped(x) * N;
}

/// A number's whole part, and the rest, which is below 1.
template <class Signed, class F>
struct Cut {
  Signed whole;
  F part;
};

/// y cut exactly: the rest only drops leading bits.  Domain: 0 <= y <= 2^30.
/// Signed: x86 converts only signed words in one instruction.
template <class Signed, class F>
constexpr Cut<Signed, F> cut(F y) noexcept {
  const Signed whole = static_cast<Signed>(y);
  return {whole, y - static_cast<F>(whole)};
}

/// Whether uf+vf >= 1, exactly, for both in [0, 1).  The sum may round, so the test is lesser >= 1 - greater.  If
/// greater >= 1/2 the difference is exact (Sterbenz).  Else both are below 1/2 and the sum is below 1, and the rounded
/// difference, at least 1/2, tells that.
template <class F>
constexpr bool reach_one(F uf, F vf) noexcept {
  return std::min(uf, vf) >= F(1.0f) - std::max(uf, vf);
}

/// Whether a part is not 0.
template <class F>
constexpr bool is_more_than_none(F uf) noexcept {
  return uf > F(0.0f);
}

/// The diagonal strip between u+v = row/N and (row+1)/N; the hypotenuse counts for the last, N-1.
template <class Word>
constexpr Word row_of(Word iu, Word iv, bool carry, Word N) noexcept {
  const Word last = N - Word{1};
  const Word diagonal = iu + iv + (carry ? Word{1} : Word{0});
  return diagonal < last ? diagonal : last;
}

/// A grid square below the diagonal, and its row.
template <class Word>
struct Square {
  Word iu, iv, row;
};

/// From iu = floor(uN), iv = floor(vN), both up to N, and whether uf+vf >= 1: the row; iv at most N-1, iu at
/// most N-1-iv, as beyond the diagonal the reference keeps v and lowers u.
template <class Word>
constexpr Square<Word> square(Word iu, Word iv, bool carry, Word N) noexcept {
  const Word last = N - Word{1};
  const Word row = row_of(iu, iv, carry, N);
  iv = iv < last ? iv : last;
  iu = iu < last - iv ? iu : last - iv;
  return {iu, iv, row};
}

/// A row, and the place in it counted by v (col) and by u (dia).
template <class Word>
struct RowPlace {
  Word row, col, dia;
};

/// From iu = floor(uN), iv = floor(vN), both up to N, whether uf+vf >= 1 and whether uf > 0: the row, col = min(row, iv)
/// and dia = min(N-1, N - ceil(uN)).
template <class Word>
constexpr RowPlace<Word> row_place(Word iu, Word iv, bool carry, bool beyond, Word N) noexcept {
  const Word last = N - Word{1};
  const Word row = row_of(iu, iv, carry, N);
  const Word from_u = N - (iu + (beyond ? Word{1} : Word{0}));
  return {row, iv < row ? iv : row, from_u < last ? from_u : last};
}

/// XOR of a 16-bit word's bits at and above each bit.
template <class Word>
constexpr Word xor_from_above(Word x) noexcept {
  x = x ^ x >> 1;
  x = x ^ x >> 2;
  x = x ^ x >> 4;
  return x ^ x >> 8;
}

/// The low 16 bits of b0 on the even bits and of b1 on the odd, both spread at once.  Domain: higher bits are clear.
template <class Wide = std::uint64_t, class Word>
constexpr Word interleaved(Word b0, Word b1) noexcept {
  const Wide x = impl::detail::spread<32>(Wide(b0) | Wide(b1) << 32);
  return static_cast<Word>(x | x >> 31);
}

/// The curve's index of a square, up to level 16:
///   b0 = iu XOR row, t = (iu XOR iv) AND b0, f = XOR from above of t, b1 = ((f XOR iu) AND NOT b0) OR t,
///   b0 to the even bits, b1 to the odd.  row takes the place of NOT iw, which saves the masks.
template <class Wide = std::uint64_t, class Word>
constexpr Word curve(const Square<Word>& q) noexcept {
  const Word b0 = q.iu ^ q.row;
  const Word t = (q.iu ^ q.iv) & b0;
  const Word b1 = ((xor_from_above(t) ^ q.iu) & ~b0) | t;
  return interleaved<Wide>(b0, b1);
}

/// The place of a point: iu = floor(uN), iv = floor(vN), N at u = 1 and v = 1; carry: uf+vf >= 1; beyond: uf > 0.
struct GridPoint {
  std::uint32_t iu, iv;
  bool carry, beyond;
};

/// Finds a point.  Domain: any bit patterns; n in 0..30.
constexpr GridPoint find(float u, float v, Level n) noexcept {
  const float N = static_cast<float>(std::int32_t{1} << n);
  const auto pu = cut<std::int32_t>(scaled(u, N)), pv = cut<std::int32_t>(scaled(v, N));
  return {static_cast<std::uint32_t>(pu.whole), static_cast<std::uint32_t>(pv.whole),
          reach_one(pu.part, pv.part), is_more_than_none(pu.part)};
}

/// The grid square (iu, iv) of a point, its row, and ceil(uN).
/// iu and iv may still be N here: at u = 1 and v = 1.
struct GridSquare {
  std::uint32_t iu, iv, row, u_ceil;
};

/// Locates a point by its u and v; rounding decides nothing.  n in 0..16.
constexpr GridSquare locate(float u, float v, Level n) noexcept {
  const GridPoint p = find(u, v, n);
  return {p.iu, p.iv, row_of(p.iu, p.iv, p.carry, std::uint32_t{1} << n), p.iu + (p.beyond ? 1u : 0u)};
}

}  // namespace detail

/// The index on the curve of the micro-triangle that contains (u, v), as the specification gives it for these very
/// numbers: detail::curve of the square of detail::find.
/// Domain: every bit pattern.  u and v are clamped to [0,1] one by one; NaN counts as 0.  level in 0..16, more is 16.
/// Result in [0, 4^level): exactly the rational evaluation of the reference for every pair of finite floats.
/// Source: VK_EXT_opacity_micromap, appendix "Reference Code".
/// Law: index.equals_reference, index.floats
constexpr std::uint32_t from_barycentrics(float u, float v, Level level) noexcept {
  const Level n = std::min(level, max_level);
  const detail::GridPoint p = detail::find(u, v, n);
  return detail::curve(detail::square(p.iu, p.iv, p.carry, std::uint32_t{1} << n));
}

/// The indices of many points: out[k] = from_barycentrics(u[k], v[k], level), bit for bit.
/// Domain: any length, any alignment; the three spans have one length, or std::invalid_argument is thrown and
/// nothing is written.  out must not overlap u or v.
/// Law: index.equals_reference, index.floats, index.exact_on_floats
void from_barycentrics(std::span<const float> u, std::span<const float> v, Level level,
                       std::span<std::uint32_t> out);

/// The corners of the micro-triangle with an index of the curve, on the grid of the level.
///   b0, b1 = even, odd bits; t = b0 AND b1, f = XOR from above of t, m = XOR from above of (b0 AND NOT b1);
///   iv = (m >> 1) XOR t, iu = b0 ? m >> 1 : b1 XOR f, bit by bit; with f0 and m0 the lowest bits of f and m:
///   (iu+f0, iv+m0), (iu+1-f0, iv+m0), (iu+m0, iv+1-m0)
/// m0 is 1 if middle children turned the triangle upside down, f0 if its first two corners lie the other way round
/// along u.
/// Domain: level in 0..16, more is 16; index is masked to its low 2 level bits.  Coordinates in [0, N].
/// Source: Succinct Opacity Micromaps, Algorithm 4, inverted; the closed form is ours.
/// Law: index.corners, index.corner_order
constexpr Corners corners(std::uint32_t index, Level level) noexcept {
  const Level n = std::min(level, max_level);
  const std::uint32_t low = (std::uint32_t{1} << n) - 1;
  const std::uint32_t b0 = impl::detail::gathered<32>(index) & low,
                      b1 = impl::detail::gathered<32>(index >> 1) & low;
  const std::uint32_t t = b0 & b1, f = detail::xor_from_above(t), m = detail::xor_from_above(b0 & ~b1);
  const std::uint32_t inverted = m >> 1;
  const std::uint32_t iu = (b0 & inverted) | (~b0 & (b1 ^ f)), iv = inverted ^ t;
  const std::uint32_t f0 = f & 1, m0 = m & 1;
  return {Vertex{iu + f0, iv + m0}, Vertex{iu + 1 - f0, iv + m0}, Vertex{iu + m0, iv + 1 - m0}};
}

/// The corners of many micro-triangles: corner c of out at k is corners(index[k], level)[c].
/// Domain: any length, any alignment; all seven spans have one length, or std::invalid_argument is thrown and
/// nothing is written.  No span of out may overlap another or index.
/// Law: index.corners, index.corner_order, index.on_samples
void corners(std::span<const std::uint32_t> index, Level level, const CornerSpans& out);

/// The index in row order, rows counted from the w-corner: row^2 + col + (dia - (N-1-row)), where
///   row = min(N-1, floor((u+v)N)), col = min(row, floor(vN)), dia = min(N-1, N - ceil(uN)).
/// Domain: every bit pattern.  u and v are clamped to [0,1] one by one; NaN counts as 0.  level in 0..16, more is 16.
/// Result in [0, 4^level), exact for every pair of finite floats in the triangle.  Outside it the formula is taken of
/// the clamped numbers; the result stays in the range because dia >= N-1-row even there.
/// Source: Color and Attribute Micromaps, figure 4, wminor_uv2triangle_index.
/// Law: index.row_order, index.row_floats
constexpr std::uint32_t w_minor(float u, float v, Level level) noexcept {
  const Level n = std::min(level, max_level);
  const detail::GridPoint p = detail::find(u, v, n);
  const std::uint32_t N = std::uint32_t{1} << n;
  const auto place = detail::row_place(p.iu, p.iv, p.carry, p.beyond, N);
  return place.row * place.row + place.col + (place.dia - (N - 1 - place.row));
}

/// The indices of many points: out[k] = w_minor(u[k], v[k], level), bit for bit.
/// Domain: any length, any alignment; the three spans have one length, or std::invalid_argument is thrown and
/// nothing is written.  out must not overlap u or v.
/// Law: index.row_order, index.row_floats, index.row_exact_on_floats
void w_minor(std::span<const float> u, std::span<const float> v, Level level, std::span<std::uint32_t> out);

/// The row of an index of row order: the greatest row with row^2 <= index.  Domain: every index.
/// A binary64 root is safe where the source's binary32 root is not.  Below 2^32 the index is exact, and the root of k^2
/// - 1 is more than 1/(2k) >= 2^-17 below k, while binary64 numbers there are at most 2^-37 apart.
/// Source: Color and Attribute Micromaps, figure 4.
/// Law: index.row_corners
inline std::uint32_t w_minor_row(std::uint32_t index) noexcept {
  return static_cast<std::uint32_t>(std::sqrt(static_cast<double>(index)));
}

/// The corners of the micro-triangle with an index of row order, in the order v0, v1, v2 of the source.
///   row = floor(sqrt(index)), c = floor((index - row^2) / 2), odd = (index - row^2) mod 2:
///   (row-c, c), (row-c+1-odd, c+odd), (row-c-odd, c+1)
/// Domain: every index; the level does not enter, as row order only appends rows.  Coordinates in [0, 2^16].
/// Source: Color and Attribute Micromaps, figure 4, wminor_uv2vertex_index.
/// Law: index.row_corners
inline Corners w_minor_corners(std::uint32_t index) noexcept {
  const std::uint32_t row = w_minor_row(index), col = index - row * row;
  const std::uint32_t c = col / 2, odd = col % 2, i = row - c;
  return {Vertex{i, c}, Vertex{i + 1 - odd, c + odd}, Vertex{i - odd, c + 1}};
}

/// The corners of many micro-triangles: corner c of out at k is w_minor_corners(index[k])[c].
/// Domain: any length, any alignment; all seven spans have one length, or std::invalid_argument is thrown and
/// nothing is written.  No span of out may overlap another or index.
/// Law: index.row_corners, index.on_samples
void w_minor_corners(std::span<const std::uint32_t> index, const CornerSpans& out);

}  // namespace mmverify::impl::index
