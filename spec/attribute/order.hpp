// Where micro-vertices and micro-triangles lie in a map: three orders of each, in whole numbers.
//
//   vertices   W-minor, rows from the w-corner; U-major, columns from the edge w-v; Bird, level by level in triplets
//   faces      the curve of the Vulkan specification; rows from the w-corner; U-major, strips from the edge w-v
//
// Word is a whole number.  Of 64 bits it holds every product up to level 31; of 32 bits the products of W-minor and
// U-major wrap at level 16, as those of code that is in use do (docs/ERRATA.md).
#pragma once

#include <array>
#include <cstdint>

#include "spec/index/index.hpp"
#include "spec/number.hpp"

namespace mmverify::spec::attribute {

/// A micro-vertex (i/N, j/N): i counts along u, j along v, N-i-j along w.
using spec::index::Corners;
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

/// V(n) = (N+1)(N+2)/2, the number of micro-vertices.  Domain: n in 0..31.
constexpr std::uint64_t vertex_count(Level n) {
  const std::uint64_t N = side(n);
  return (N + 1) * (N + 2) / 2;
}

/// 4^n, the number of micro-triangles.  Domain: n in 0..31.
constexpr std::uint64_t face_count(Level n) { return std::uint64_t{1} << (2 * n); }

/// The greatest r with r(r+1)/2 <= x.  Domain: x below 2^63.
constexpr std::uint64_t triangular_root(std::uint64_t x) {
  std::uint64_t r = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 31; bit != 0; bit /= 2)
    if ((r + bit) * (r + bit + 1) / 2 <= x) r += bit;
  return r;
}

// ---------------------------------------------------------------------------------------------------------------------
// Vertices
// ---------------------------------------------------------------------------------------------------------------------

/// Index of a vertex in rows counted from the w-corner, each from the edge w-u on:
///   r(r+1)/2 + j,  r = i+j
/// The level does not enter: a finer level appends rows.
/// Domain: a vertex of a level in 0..31.  Source: Color and Attribute Micromaps, 3.1 and figure 4, to_index.
template <class Word>
constexpr Word w_minor_index(Word i, Word j) {
  const Word r = i + j;
  return r * (r + 1) / 2 + j;
}

/// The vertex of an index: r the greatest with r(r+1)/2 <= x, j = x - r(r+1)/2, i = r-j.
/// Domain: x in [0, V(n)), n in 0..31.  Source: as w_minor_index.
constexpr Vertex w_minor_vertex(std::uint64_t x) {
  const std::uint64_t r = triangular_root(x), j = x - r * (r + 1) / 2;
  return {static_cast<std::uint32_t>(r - j), static_cast<std::uint32_t>(j)};
}

/// Index of a vertex in columns counted from the edge w-v (i = 0), each from its end at v = 0 on:
///   i(N+2) - i(i+1)/2 + j:  the i columns before it have N+1, N, ... vertices
/// Domain: a vertex of level n, n in 0..31.  Source: Color and Attribute Micromaps, 3.1 (U-major); the closed form is
/// ours.
template <class Word>
constexpr Word u_major_index(Word i, Word j, Level n) {
  const Word N = Word{side(n)};
  return i * (N + 2) - i * (i + 1) / 2 + j;
}

/// The vertex of an index: columns are rows counted from the u-corner, backwards:
///   y = V-1-x, r the greatest with r(r+1)/2 <= y, c = y - r(r+1)/2, i = N-r, j = r-c
/// Domain: x in [0, V(n)), n in 0..31.  Source: as u_major_index.
constexpr Vertex u_major_vertex(std::uint64_t x, Level n) {
  const std::uint64_t y = vertex_count(n) - 1 - x, r = triangular_root(y), c = y - r * (r + 1) / 2;
  return {static_cast<std::uint32_t>(side(n) - r), static_cast<std::uint32_t>(r - c)};
}

/// How many of the micro-triangles before number x of the curve at level d stand upright, that is, are lower ones:
///   (x + sum over digits l of o_l b_l 2^l) / 2,  b_l the low bit of digit l; o begins at +1 and turns its sign below
///   each digit 1, whose child is upside down
/// Source: ours.  A subtree of l levels has S(S+1)/2 micro-triangles of its root's orientation and S(S-1)/2 of the
/// other, S = 2^l: an excess of +S or -S over half of 4^l; the children 0, 1, 2 and 3 have signs +, -, +, +, so the
/// excess of those before digit 0, 1, 2, 3 is 0, S, 0, S.
/// Domain: x in [0, 4^d], d in 0..31.
constexpr std::uint64_t upright_before(std::uint64_t x, Level d) {
  std::int64_t excess = 0, sign = 1;
  for (Level l = d + 1; l-- > 0;) {  // 4^d itself has a digit at d
    const std::uint64_t digit = x >> (2 * l) & 3;
    if (digit % 2 != 0) excess += sign * (std::int64_t{1} << l);
    if (digit == 1) sign = -sign;
  }
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(x) + excess) / 2;
}

/// The number on the curve at level d of upright micro-triangle k: the inverse of upright_before.
/// Domain: k in [0, 2^d (2^d + 1) / 2), d in 0..31.
constexpr std::uint64_t upright_number(std::uint64_t k, Level d) {
  std::uint64_t x = 0;
  bool upright = true;
  for (Level l = d; l-- > 0;) {
    const std::uint64_t S = std::uint64_t{1} << l;
    std::uint64_t digit = 0;
    for (;; ++digit) {
      const bool child_upright = digit == 1 ? !upright : upright;
      const std::uint64_t held = child_upright ? S * (S + 1) / 2 : S * (S - 1) / 2;
      if (k < held) break;
      k -= held;
    }
    if (digit == 1) upright = !upright;
    x = 4 * x + digit;
  }
  return x;
}

/// Number on the curve of a micro-triangle of level n: the bits of its grid square, b0 = NOT(iu XOR iw) and so on.
/// Domain: a micro-triangle of level n, n in 0..31.  Source: VK_EXT_opacity_micromap, appendix "Reference Code".
constexpr std::uint64_t curve_index(const MicroTriangle& t, Level n) {
  const std::uint64_t iu = t.iu, iv = t.iv, iw = ~(iu + iv) - (t.upper ? 1 : 0);
  return spec::index::curve(spec::index::Quantised<std::uint64_t>{iu, iv, iw}, std::uint64_t{side(n)} - 1);
}

/// The micro-triangle of a number on the curve, from its corners.  Domain: x in [0, 4^n), n in 0..16.
constexpr MicroTriangle curve_triangle(std::uint64_t x, Level n) {
  const Corners c = spec::index::corners(static_cast<std::uint32_t>(x), n);
  const auto least = [](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
    const std::uint32_t ab = a < b ? a : b;
    return ab < d ? ab : d;
  };
  const std::uint32_t iu = least(c[0].i, c[1].i, c[2].i), iv = least(c[0].j, c[1].j, c[2].j);
  // A lower one has its square's corner (iu, iv); an upper one does not.
  bool upper = true;
  for (const Vertex& at : c) upper = upper && !(at == Vertex{iu, iv});
  return {iu, iv, upper};
}

/// How often 2 divides i and j both.  Domain: i or j above 0.
constexpr Level halvings(std::uint32_t i, std::uint32_t j) {
  Level s = 0;
  while (((i | j) >> s & 1) == 0) ++s;
  return s;
}

/// Index of a vertex in the hierarchical order: corners w, u, v are 0, 1, 2.  Of any other let m be the first level
/// that has it.  It lies in the middle of an edge of level m-1, and that edge belongs to one upright micro-triangle:
///   V(m-1) + 3 upright_before(its number on the curve at level m-1) + e,
///   e = 0 on the edge w-v of the micro-triangle (i even), 1 on u-v (i and j odd), 2 on w-u (j even)
/// where i and j are those of level m.
/// Domain: a vertex of level n, n in 0..31.  Source: Color and Attribute Micromaps, 3.1 (Bird); the closed form is
/// ours.
constexpr std::uint64_t bird_index(std::uint32_t i, std::uint32_t j, Level n) {
  const std::uint32_t N = side(n);
  if (i == 0 && j == 0) return 0;
  if (i == N) return 1;
  if (j == N) return 2;
  const Level s = halvings(i, j), m = n - s;
  i >>= s;
  j >>= s;
  const std::uint32_t e = i % 2 == 0 ? 0 : j % 2 != 0 ? 1 : 2;
  const std::uint64_t before = upright_before(curve_index({i / 2, j / 2, false}, m - 1), m - 1);
  return vertex_count(m - 1) + 3 * before + e;
}

/// The vertex of an index: m the first level with x < V(m); then the edge, the upright micro-triangle, its square.
/// Domain: x in [0, V(n)), n in 0..16.  Source: as bird_index.
constexpr Vertex bird_vertex(std::uint64_t x, Level n) {
  const std::uint32_t N = side(n);
  if (x < 3) return x == 0 ? Vertex{0, 0} : x == 1 ? Vertex{N, 0} : Vertex{0, N};
  Level m = 1;
  while (x >= vertex_count(m)) ++m;
  const std::uint64_t k = x - vertex_count(m - 1);
  const MicroTriangle t = curve_triangle(upright_number(k / 3, m - 1), m - 1);
  const std::uint32_t i = 2 * t.iu + (k % 3 == 0 ? 0 : 1), j = 2 * t.iv + (k % 3 == 2 ? 0 : 1);
  return {i << (n - m), j << (n - m)};
}

/// Index of a vertex in an order.  Domain: a vertex of level n, n in 0..31.  Result in [0, V(n)).
constexpr std::uint64_t vertex_index(VertexOrder order, const Vertex& at, Level n) {
  switch (order) {
    case VertexOrder::w_minor:
      return w_minor_index<std::uint64_t>(at.i, at.j);
    case VertexOrder::u_major:
      return u_major_index<std::uint64_t>(at.i, at.j, n);
    case VertexOrder::bird:
      break;
  }
  return bird_index(at.i, at.j, n);
}

/// The vertex of an index in an order.  Domain: x in [0, V(n)), n in 0..16.
constexpr Vertex vertex_at(VertexOrder order, std::uint64_t x, Level n) {
  switch (order) {
    case VertexOrder::w_minor:
      return w_minor_vertex(x);
    case VertexOrder::u_major:
      return u_major_vertex(x, n);
    case VertexOrder::bird:
      break;
  }
  return bird_vertex(x, n);
}

// ---------------------------------------------------------------------------------------------------------------------
// Faces
// ---------------------------------------------------------------------------------------------------------------------

/// Index of a micro-triangle in rows counted from the w-corner: r^2 + 2 iv + upper, r = iu+iv+upper.
/// Domain: a micro-triangle of a level in 0..31.  Source: Color and Attribute Micromaps, figure 4.
template <class Word>
constexpr Word row_index(Word iu, Word iv, bool upper) {
  const Word up = upper ? 1 : 0, r = iu + iv + up;
  return r * r + 2 * iv + up;
}

/// The micro-triangle of an index in rows.  Domain: x in [0, 4^n), n in 0..16.  Source: as row_index.
constexpr MicroTriangle row_triangle(std::uint64_t x) {
  const std::uint32_t index = static_cast<std::uint32_t>(x), r = spec::index::w_minor_row(index);
  const std::uint32_t c = index - r * r;
  return {r - c / 2 - c % 2, c / 2, c % 2 != 0};
}

/// Index of a micro-triangle in strips counted from the edge w-v, each from v = 0 on:
///   2N iu - iu^2 + 2 iv + upper:  the iu strips before it have 2N-1, 2N-3, ... micro-triangles
/// Domain: a micro-triangle of level n, n in 0..31.  Source: Color and Attribute Micromaps, 3.1 (U-major); the closed
/// form is ours.
template <class Word>
constexpr Word u_major_face_index(Word iu, Word iv, bool upper, Level n) {
  const Word N = Word{side(n)}, up = upper ? 1 : 0;
  return 2 * N * iu - iu * iu + 2 * iv + up;
}

/// The micro-triangle of an index in strips: iu strips are full, and the rest lies in the next; counted backwards,
/// strips are rows: iu = N-1 - floor(sqrt(4^n - 1 - x)).
/// Domain: x in [0, 4^n), n in 0..16.  Source: as u_major_face_index.
constexpr MicroTriangle u_major_triangle(std::uint64_t x, Level n) {
  const std::uint32_t N = side(n);
  const std::uint32_t iu =
      N - 1 - spec::index::w_minor_row(static_cast<std::uint32_t>(face_count(n) - 1 - x));
  const auto rest = static_cast<std::uint32_t>(x - u_major_face_index<std::uint64_t>(iu, 0, false, n));
  return {iu, rest / 2, rest % 2 != 0};
}

/// Index of a micro-triangle in an order.  Domain: a micro-triangle of level n, n in 0..31.  Result in [0, 4^n).
constexpr std::uint64_t face_index(FaceOrder order, const MicroTriangle& t, Level n) {
  switch (order) {
    case FaceOrder::curve:
      return curve_index(t, n);
    case FaceOrder::rows:
      return row_index<std::uint64_t>(t.iu, t.iv, t.upper);
    case FaceOrder::u_major:
      break;
  }
  return u_major_face_index<std::uint64_t>(t.iu, t.iv, t.upper, n);
}

/// The micro-triangle of an index in an order.  Domain: x in [0, 4^n), n in 0..16.
constexpr MicroTriangle triangle_at(FaceOrder order, std::uint64_t x, Level n) {
  switch (order) {
    case FaceOrder::curve:
      return curve_triangle(x, n);
    case FaceOrder::rows:
      return row_triangle(x);
    case FaceOrder::u_major:
      break;
  }
  return u_major_triangle(x, n);
}

// ---------------------------------------------------------------------------------------------------------------------
// Faces and their vertices
// ---------------------------------------------------------------------------------------------------------------------

/// Corners of a micro-triangle: the base, and one step along u and along v from there, +1 or, in an upper one, -1:
///   lower (iu, iv) (iu+1, iv) (iu, iv+1);  upper (iu+1, iv+1) (iu, iv+1) (iu+1, iv)
/// Both wind like the base triangle.
constexpr Corners corners_of(const MicroTriangle& t) {
  const std::uint32_t i = t.iu, j = t.iv;
  if (t.upper) return {Vertex{i + 1, j + 1}, Vertex{i, j + 1}, Vertex{i + 1, j}};
  return {Vertex{i, j}, Vertex{i + 1, j}, Vertex{i, j + 1}};
}

/// The micro-triangle of three corners, from the first two alone.  Domain: corners_of a micro-triangle.
constexpr MicroTriangle triangle_of(const Corners& c) {
  if (c[1].i > c[0].i) return {c[0].i, c[0].j, false};
  return {c[1].i, c[1].j - 1, true};
}

/// Indices of three vertices.
using Triplet = std::array<std::uint64_t, 3>;

/// Indices of a micro-triangle's corners, in their order.  Domain: a micro-triangle of level n, n in 0..31.
constexpr Triplet triplet(VertexOrder order, const MicroTriangle& t, Level n) {
  const Corners c = corners_of(t);
  return {vertex_index(order, c[0], n), vertex_index(order, c[1], n), vertex_index(order, c[2], n)};
}

/// The micro-triangle that a triplet belongs to.  Domain: the triplet of one; n in 0..16.
constexpr MicroTriangle triangle_of_triplet(VertexOrder order, const Triplet& x, Level n) {
  return triangle_of({vertex_at(order, x[0], n), vertex_at(order, x[1], n), vertex_at(order, x[2], n)});
}

}  // namespace mmverify::spec::attribute
