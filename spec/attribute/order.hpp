// The places of micro-vertices and micro-triangles in a map: three orders of each, in integers.
//
//   vertices   W-minor, rows from the w-corner; U-major, columns from the edge w-v; Bird, level by level in triplets
//   faces      the curve of the Vulkan specification; rows from the w-corner; U-major, strips from the edge w-v
//
// Word is an integer type.  With 64 bits it holds every product up to level 31.  With 32 bits the products of W-minor
// and U-major wrap at level 16, as they do in released code (docs/ERRATA.md).
#pragma once

#include <array>
#include <cstdint>

#include "spec/index/index.hpp"
#include "spec/number.hpp"

namespace mmverify::spec::attribute {

/// A micro-vertex (i/N, j/N): i counts along u, j along v, N-i-j along w.
using spec::index::Corners;
using spec::index::square;
using spec::index::Vertex;

/// A micro-triangle by its grid square: `upper` is the half of the square beyond its diagonal.
/// Domain at level n: iu + iv < N, with upper iu + iv < N-1.
struct MicroTriangle {
  std::uint32_t iu, iv;
  bool upper;
  friend constexpr bool operator==(const MicroTriangle&, const MicroTriangle&) = default;
};

enum class VertexOrder : std::uint32_t { w_minor, u_major, bird };
inline constexpr std::array vertex_orders{VertexOrder::w_minor, VertexOrder::u_major, VertexOrder::bird};

enum class FaceOrder : std::uint32_t { curve, rows, u_major };
inline constexpr std::array face_orders{FaceOrder::curve, FaceOrder::rows, FaceOrder::u_major};

/// T(r) = r(r+1)/2, the number of vertices in the rows before row r.
template <class Word>
constexpr Word triangular(const Word& r) {
  return r * (r + 1) / 2;
}

/// T(N+1) = (N+1)(N+2)/2, the number of micro-vertices with N micro-triangles to a side.
template <class Word>
constexpr Word vertices_of_side(const Word& N) {
  return triangular(N + 1);
}

/// V(n) = (N+1)(N+2)/2, the number of micro-vertices.  Domain: n in 0..31.
constexpr std::uint64_t vertex_count(Level n) { return vertices_of_side(std::uint64_t{side(n)}); }

/// 4^n, the number of micro-triangles.  Domain: n in 0..31.
constexpr std::uint64_t face_count(Level n) { return std::uint64_t{1} << (2 * n); }

/// One bit of a root: r + bit if T of that is x or less, else r.
/// T(r) <= x < T(r + 2 bit) before it, and T(r) <= x < T(r + bit) of the new r after it.
template <class Word>
constexpr Word triangular_root_turn(const Word& x, const Word& r, const Word& bit) {
  return x < triangular(r + bit) ? r : r + bit;
}

/// The greatest r with r(r+1)/2 <= x.  Domain: x below 2^63.
constexpr std::uint64_t triangular_root(std::uint64_t x) {
  std::uint64_t r = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit /= 2) r = triangular_root_turn(x, r, bit);
  return r;
}

/// A micro-vertex in words of any kind.
template <class Word>
struct VertexOf {
  Word i, j;
};
/// A micro-triangle in words of any kind; `upper` is 0 or 1.
template <class Word>
struct FaceOf {
  Word iu, iv, upper;
};

constexpr Vertex narrowed(const VertexOf<std::uint64_t>& at) {
  return {static_cast<std::uint32_t>(at.i), static_cast<std::uint32_t>(at.j)};
}
constexpr MicroTriangle narrowed(const FaceOf<std::uint64_t>& t) {
  return {static_cast<std::uint32_t>(t.iu), static_cast<std::uint32_t>(t.iv), t.upper != 0};
}

// ---- Vertices

/// Index of a vertex in rows counted from the w-corner, each from the edge w-u on:
///   r(r+1)/2 + j,  r = i+j
/// The level does not enter: a finer level appends rows.
/// Domain: a vertex of a level in 0..31.  Source: Color and Attribute Micromaps, 3.1 and figure 4, to_index.
template <class Word>
constexpr Word w_minor_index(Word i, Word j) {
  return triangular(i + j) + j;
}

/// The vertex with index x, in row r.  Domain: r the greatest with r(r+1)/2 <= x.
template <class Word>
constexpr VertexOf<Word> w_minor_in_row(const Word& x, const Word& r) {
  const Word j = x - triangular(r);
  return {r - j, j};
}

/// The vertex with an index: r the greatest with r(r+1)/2 <= x, j = x - r(r+1)/2, i = r-j.
/// Domain: x in [0, V(n)), n in 0..31.  Source: as w_minor_index.
constexpr Vertex w_minor_vertex(std::uint64_t x) { return narrowed(w_minor_in_row(x, triangular_root(x))); }

/// Index of a vertex in columns counted from the edge w-v (i = 0), each from its end at v = 0 on:
///   i(N+2) - i(i+1)/2 + j:  the i columns before it have N+1, N, ... vertices
/// Domain: a vertex of level n, n in 0..31.  Source: Color and Attribute Micromaps, 3.1 (U-major); the closed form is
/// ours.
template <class Word>
constexpr Word u_major_of_side(const Word& i, const Word& j, const Word& N) {
  return i * (N + 2) - triangular(i) + j;
}
template <class Word>
constexpr Word u_major_index(Word i, Word j, Level n) {
  return u_major_of_side(i, j, Word{side(n)});
}

/// The vertex whose index is y less than the last one, in row r from the u-corner.
/// Domain: y in [0, T(N+1)), r the greatest with r(r+1)/2 <= y.
template <class Word>
constexpr VertexOf<Word> u_major_in_row(const Word& y, const Word& r, const Word& N) {
  const Word c = y - triangular(r);
  return {N - r, r - c};
}

/// The vertex with an index: columns are rows counted from the u-corner, backwards:
///   y = V-1-x, r the greatest with r(r+1)/2 <= y, c = y - r(r+1)/2, i = N-r, j = r-c
/// Domain: x in [0, V(n)), n in 0..31.  Source: as u_major_index.
constexpr Vertex u_major_vertex(std::uint64_t x, Level n) {
  const std::uint64_t y = vertex_count(n) - 1 - x;
  return narrowed(u_major_in_row(y, triangular_root(y), std::uint64_t{side(n)}));
}

/// A count along the curve: twice the number of upright micro-triangles that were passed, less that of all passed; and
/// whether the triangle that is entered next stands upright.
template <class Word>
struct UprightExcess {
  Word excess;
  bool upright;
};

/// One digit of upright_before(), a child having S micro-triangles to a side: the children before digit 0, 1, 2, 3 have
/// an excess of 0, S, 0, S, or in a triangle upside down of 0, -S, 0, -S; child 1 stands the other way.
template <class Word>
constexpr UprightExcess<Word> upright_turn(const UprightExcess<Word>& at, std::uint64_t digit,
                                           const Word& S) {
  const Word excess = digit % 2 == 0 ? at.excess : at.upright ? at.excess + S : at.excess - S;
  return {excess, (digit == 1) != at.upright};
}

/// The number of micro-triangles before number x of the curve at level d that stand upright, that is, are lower ones:
///   (x + sum over digits l of o_l b_l 2^l) / 2,  b_l the low bit of digit l; o begins at +1 and turns its sign below
///   each digit 1, whose child is upside down
/// Source: ours.  A subtree of l levels has S(S+1)/2 micro-triangles of its root's orientation and S(S-1)/2 of the
/// other, S = 2^l: an excess of +S or -S over half of 4^l; the children 0, 1, 2 and 3 have signs +, -, +, +, so the
/// excess of those before digit 0, 1, 2, 3 is 0, S, 0, S.
/// Domain: x in [0, 4^d], d in 0..31.
constexpr std::uint64_t upright_before(std::uint64_t x, Level d) {
  UprightExcess<std::int64_t> at{0, true};
  for (Level l = d + 1; l-- > 0;)  // 4^d itself has a digit at d
    at = upright_turn(at, x >> (2 * l) & 3, std::int64_t{1} << l);
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(x) + at.excess) / 2;
}

/// The number of upright micro-triangles in a triangle with S to a side: S(S+1)/2 if it stands upright itself, else
/// S(S-1)/2.
template <class Word>
constexpr Word upright_within(const Word& S, bool upright) {
  return upright ? triangular(S) : triangular(S - 1);
}

/// The child, S micro-triangles to a side, that contains upright micro-triangle k of a triangle; k becomes its number
/// there.
/// Domain: k below upright_within(2S, upright).
template <class Word>
constexpr std::uint64_t upright_child(Word& k, const Word& S, bool upright) {
  std::uint64_t digit = 0;
  for (; digit < 3; ++digit) {
    const Word held = upright_within(S, (digit == 1) != upright);
    if (k < held) break;
    k = k - held;
  }
  return digit;
}

/// The number on the curve at level d of upright micro-triangle k: the inverse of upright_before.
/// Domain: k in [0, 2^d (2^d + 1) / 2), d in 0..31.
constexpr std::uint64_t upright_number(std::uint64_t k, Level d) {
  std::uint64_t x = 0;
  bool upright = true;
  for (Level l = d; l-- > 0;) {
    const std::uint64_t digit = upright_child(k, std::uint64_t{1} << l, upright);
    upright = (digit == 1) != upright;
    x = 4 * x + digit;
  }
  return x;
}

/// The words of a grid square that make up the curve's number: iu, iv and iw = NOT(iu+iv), one less for the upper half.
template <class Word>
constexpr spec::index::Quantised<Word> curve_words(const Word& iu, const Word& iv, bool upper) {
  const Word iw = ~(iu + iv);
  return {iu, iv, upper ? iw - 1 : iw};
}

/// The number on the curve of a micro-triangle of level n: the bits of its grid square, b0 = NOT(iu XOR iw) and so on.
/// Domain: a micro-triangle of level n, n in 0..31.  Source: VK_EXT_opacity_micromap, appendix "Reference Code".
constexpr std::uint64_t curve_index(const MicroTriangle& t, Level n) {
  return spec::index::curve(curve_words<std::uint64_t>(t.iu, t.iv, t.upper), std::uint64_t{side(n)} - 1);
}

/// The micro-triangle with these corners, in any order: a lower one has its square's corner (iu, iv), an upper one not.
template <class Word>
constexpr FaceOf<Word> face_of_any_corners(const std::array<VertexOf<Word>, 3>& c) {
  const auto least = [](const Word& a, const Word& b, const Word& d) {
    const Word ab = a < b ? a : b;
    return ab < d ? ab : d;
  };
  const Word iu = least(c[0].i, c[1].i, c[2].i), iv = least(c[0].j, c[1].j, c[2].j);
  bool upper = true;
  for (const VertexOf<Word>& at : c) upper = upper && !(at.i == iu && at.j == iv);
  return {iu, iv, Word(upper ? 1 : 0)};
}

/// The micro-triangle with a number on the curve, from its corners.  Domain: x in [0, 4^n), n in 0..16.
constexpr MicroTriangle curve_triangle(std::uint64_t x, Level n) {
  const Corners c = spec::index::corners(static_cast<std::uint32_t>(x), n);
  using V = VertexOf<std::uint64_t>;
  return narrowed(
      face_of_any_corners<std::uint64_t>({V{c[0].i, c[0].j}, {c[1].i, c[1].j}, {c[2].i, c[2].j}}));
}

/// The index of a corner in the hierarchical order, w, u, v: 0, 1, 2; 3 for any other vertex.
template <class Word>
constexpr std::uint64_t bird_corner(const Word& i, const Word& j, const Word& N) {
  if (i == 0 && j == 0) return 0;
  if (i == N) return 1;
  return j == N ? 2 : 3;
}

/// Halves i and j if both are even, to the same vertex of the level below; false if not.
template <class Word>
constexpr bool halved(VertexOf<Word>& at) {
  if (!(at.i % 2 == 0 && at.j % 2 == 0)) return false;
  at = {at.i / 2, at.j / 2};
  return true;
}

/// The middle of an edge of an upright micro-triangle: its grid square, and edge 0 for w-v, 1 for u-v, 2 for w-u.
template <class Word>
struct EdgeMiddle {
  Word iu, iv, edge;
};

/// The edge that a vertex is the middle of, one level coarser: edge 0 if i is even, 2 if j is, 1 if neither is.
/// Domain: not both even.
template <class Word>
constexpr EdgeMiddle<Word> edge_middle(const VertexOf<Word>& at) {
  const Word edge = at.i % 2 == 0 ? 0 : at.j % 2 == 0 ? 2 : 1;
  return {at.i / 2, at.j / 2, edge};
}

/// The vertex in the middle of an edge; edge_middle() inverted.
template <class Word>
constexpr VertexOf<Word> in_the_middle(const EdgeMiddle<Word>& m) {
  return {m.edge == 0 ? 2 * m.iu : 2 * m.iu + 1, m.edge == 2 ? 2 * m.iv : 2 * m.iv + 1};
}

/// The index of a vertex that a level adds to one with M micro-triangles to a side: T(M+1) + 3 before + edge, `before`
/// the number of upright micro-triangles before the one with that edge.
template <class Word>
constexpr Word bird_number(const Word& before, const Word& edge, const Word& M) {
  return vertices_of_side(M) + 3 * before + edge;
}

/// `before` and edge of such an index; bird_number() inverted.
template <class Word>
struct BirdPlace {
  Word before, edge;
};
template <class Word>
constexpr BirdPlace<Word> bird_place(const Word& x, const Word& M) {
  const Word k = x - vertices_of_side(M);
  return {k / 3, k % 3};
}

/// Index of a vertex in the hierarchical order: corners w, u, v are 0, 1, 2.  Of any other let m be the first level
/// that has it.  It lies in the middle of an edge of level m-1, and that edge belongs to one upright micro-triangle:
///   V(m-1) + 3 upright_before(its number on the curve at level m-1) + e,
///   e = 0 on the edge w-v of the micro-triangle (i even), 1 on u-v (i and j odd), 2 on w-u (j even)
/// where i and j are those of level m.
/// Domain: a vertex of level n, n in 0..31.  Source: Color and Attribute Micromaps, 3.1 (Bird); the closed form is
/// ours.
constexpr std::uint64_t bird_index(std::uint32_t i, std::uint32_t j, Level n) {
  if (const std::uint64_t corner = bird_corner(i, j, side(n)); corner < 3) return corner;
  VertexOf<std::uint64_t> at{i, j};
  Level m = n;
  while (halved(at)) --m;
  const EdgeMiddle<std::uint64_t> on = edge_middle(at);
  const std::uint64_t before =
      upright_before(curve_index(narrowed(FaceOf<std::uint64_t>{on.iu, on.iv, 0}), m - 1), m - 1);
  return bird_number<std::uint64_t>(before, on.edge, side(m - 1));
}

/// The vertex with an index: m the first level with x < V(m); then the edge, the upright micro-triangle, its square.
/// Domain: x in [0, V(n)), n in 0..16.  Source: as bird_index.
constexpr Vertex bird_vertex(std::uint64_t x, Level n) {
  const std::uint32_t N = side(n);
  if (x < 3) return x == 0 ? Vertex{0, 0} : x == 1 ? Vertex{N, 0} : Vertex{0, N};
  Level m = 1;
  while (x >= vertex_count(m)) ++m;
  const BirdPlace<std::uint64_t> place = bird_place<std::uint64_t>(x, side(m - 1));
  const MicroTriangle t = curve_triangle(upright_number(place.before, m - 1), m - 1);
  const Vertex at = narrowed(in_the_middle(EdgeMiddle<std::uint64_t>{t.iu, t.iv, place.edge}));
  return {at.i << (n - m), at.j << (n - m)};
}

/// The index of a vertex in an order.  Domain: a vertex of level n, n in 0..31.  Result in [0, V(n)).
constexpr std::uint64_t vertex_index(VertexOrder order, const Vertex& at, Level n) {
  switch (order) {
    case VertexOrder::w_minor: return w_minor_index<std::uint64_t>(at.i, at.j);
    case VertexOrder::u_major: return u_major_index<std::uint64_t>(at.i, at.j, n);
    case VertexOrder::bird: break;
  }
  return bird_index(at.i, at.j, n);
}

/// The vertex with an index in an order.  Domain: x in [0, V(n)), n in 0..16.
constexpr Vertex vertex_at(VertexOrder order, std::uint64_t x, Level n) {
  switch (order) {
    case VertexOrder::w_minor: return w_minor_vertex(x);
    case VertexOrder::u_major: return u_major_vertex(x, n);
    case VertexOrder::bird: break;
  }
  return bird_vertex(x, n);
}

// ---- Faces

/// Index of a micro-triangle in rows counted from the w-corner: r^2 + 2 iv + upper, r = iu+iv+upper.
/// Domain: a micro-triangle of a level in 0..31.  Source: Color and Attribute Micromaps, figure 4.
template <class Word>
constexpr Word row_index(Word iu, Word iv, bool upper) {
  const Word up = upper ? 1 : 0, r = iu + iv + up;
  return square(r) + 2 * iv + up;
}

/// The micro-triangle with index x, in row r.  Domain: r the greatest with r^2 <= x.
template <class Word>
constexpr FaceOf<Word> row_face(const Word& x, const Word& r) {
  const Word c = x - square(r);
  return {r - c / 2 - c % 2, c / 2, c % 2};
}

/// The micro-triangle with an index in rows.  Domain: x in [0, 4^n), n in 0..16.  Source: as row_index.
constexpr MicroTriangle row_triangle(std::uint64_t x) {
  return narrowed(row_face<std::uint64_t>(x, spec::index::w_minor_row(static_cast<std::uint32_t>(x))));
}

/// Index of a micro-triangle in strips counted from the edge w-v, each from v = 0 on:
///   2N iu - iu^2 + 2 iv + upper:  the iu strips before it have 2N-1, 2N-3, ... micro-triangles
/// Domain: a micro-triangle of level n, n in 0..31.  Source: Color and Attribute Micromaps, 3.1 (U-major); the closed
/// form is ours.
template <class Word>
constexpr Word u_major_face_of_side(const Word& iu, const Word& iv, bool upper, const Word& N) {
  const Word up = upper ? 1 : 0;
  return 2 * N * iu - square(iu) + 2 * iv + up;
}
template <class Word>
constexpr Word u_major_face_index(Word iu, Word iv, bool upper, Level n) {
  return u_major_face_of_side(iu, iv, upper, Word{side(n)});
}

/// The micro-triangle with index x, in the strip r strips before the last.
/// Domain: x in [0, N^2), r the greatest with r^2 <= N^2 - 1 - x.
template <class Word>
constexpr FaceOf<Word> u_major_face_in_strip(const Word& x, const Word& r, const Word& N) {
  const Word iu = N - 1 - r, rest = x - u_major_face_of_side(iu, Word(0), false, N);
  return {iu, rest / 2, rest % 2};
}

/// The micro-triangle with an index in strips: iu strips are full, and the rest lies in the next; counted backwards,
/// strips are rows: iu = N-1 - floor(sqrt(4^n - 1 - x)).
/// Domain: x in [0, 4^n), n in 0..16.  Source: as u_major_face_index.
constexpr MicroTriangle u_major_triangle(std::uint64_t x, Level n) {
  const std::uint32_t r = spec::index::w_minor_row(static_cast<std::uint32_t>(face_count(n) - 1 - x));
  return narrowed(u_major_face_in_strip<std::uint64_t>(x, r, side(n)));
}

/// The index of a micro-triangle in an order.  Domain: a micro-triangle of level n, n in 0..31.  Result in [0, 4^n).
constexpr std::uint64_t face_index(FaceOrder order, const MicroTriangle& t, Level n) {
  switch (order) {
    case FaceOrder::curve: return curve_index(t, n);
    case FaceOrder::rows: return row_index<std::uint64_t>(t.iu, t.iv, t.upper);
    case FaceOrder::u_major: break;
  }
  return u_major_face_index<std::uint64_t>(t.iu, t.iv, t.upper, n);
}

/// The micro-triangle with an index in an order.  Domain: x in [0, 4^n), n in 0..16.
constexpr MicroTriangle triangle_at(FaceOrder order, std::uint64_t x, Level n) {
  switch (order) {
    case FaceOrder::curve: return curve_triangle(x, n);
    case FaceOrder::rows: return row_triangle(x);
    case FaceOrder::u_major: break;
  }
  return u_major_triangle(x, n);
}

// ---- Faces and their vertices

/// The corners of a micro-triangle: the base, and one step along u and along v from there, +1 or, in an upper one, -1:
///   lower (iu, iv) (iu+1, iv) (iu, iv+1);  upper (iu+1, iv+1) (iu, iv+1) (iu+1, iv)
/// Both wind like the base triangle.
template <class Word>
constexpr std::array<VertexOf<Word>, 3> corners_of_square(const Word& i, const Word& j, bool upper) {
  if (upper) return {VertexOf<Word>{i + 1, j + 1}, {i, j + 1}, {i + 1, j}};
  return {VertexOf<Word>{i, j}, {i + 1, j}, {i, j + 1}};
}
constexpr Corners corners_of(const MicroTriangle& t) {
  const auto c = corners_of_square<std::uint64_t>(t.iu, t.iv, t.upper);
  return {narrowed(c[0]), narrowed(c[1]), narrowed(c[2])};
}

/// The micro-triangle with three corners, from the first two alone.  Domain: corners_of() a micro-triangle.
template <class Word>
constexpr FaceOf<Word> face_of_corners(const VertexOf<Word>& first, const VertexOf<Word>& second) {
  if (second.i > first.i) return {first.i, first.j, Word(0)};
  return {second.i, second.j - 1, Word(1)};
}
constexpr MicroTriangle triangle_of(const Corners& c) {
  return narrowed(face_of_corners<std::uint64_t>({c[0].i, c[0].j}, {c[1].i, c[1].j}));
}

/// The indices of three vertices.
using Triplet = std::array<std::uint64_t, 3>;

/// The indices of a micro-triangle's corners, in their order.  Domain: a micro-triangle of level n, n in 0..31.
constexpr Triplet triplet(VertexOrder order, const MicroTriangle& t, Level n) {
  const Corners c = corners_of(t);
  return {vertex_index(order, c[0], n), vertex_index(order, c[1], n), vertex_index(order, c[2], n)};
}

/// The micro-triangle of a triplet.  Domain: the triplet of a micro-triangle; n in 0..16.
constexpr MicroTriangle triangle_of_triplet(VertexOrder order, const Triplet& x, Level n) {
  return triangle_of({vertex_at(order, x[0], n), vertex_at(order, x[1], n), vertex_at(order, x[2], n)});
}

}  // namespace mmverify::spec::attribute
