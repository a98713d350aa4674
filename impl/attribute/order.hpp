// The places of micro-vertices and micro-triangles in a map: index <-> place in three orders of each, conversions
// between orders, and a face's three vertices.
//
//   vertices   W-minor, U-major, Bird
//   faces      the curve of the Vulkan specification, rows (Gruen et al.), U-major
//
// Each function has two forms, which give the same bits: inline for a single value; for spans, in SIMD chosen at run
// time.
// Every index up to level 16 fits 32 bits, and so does every product here: r(r+1)/2 is formed as ((r+1)/2) (r|1).
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "impl/common/bits.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::attribute {

using index::Level;
using index::max_level;
using index::Vertex;

enum class VertexOrder : std::uint32_t { w_minor, u_major, bird };
enum class FaceOrder : std::uint32_t { curve, rows, u_major };

/// A micro-triangle by its grid square: `upper` is the half of the square beyond its diagonal.
/// Domain at level n: iu + iv + upper < N.
struct MicroTriangle {
  std::uint32_t iu, iv;
  bool upper;
  friend constexpr bool operator==(const MicroTriangle&, const MicroTriangle&) = default;
};

/// V(n) = (N+1)(N+2)/2, the number of micro-vertices.  Domain: level in 0..16, more is 16.
constexpr std::uint32_t vertex_count(Level level) noexcept {
  const std::uint64_t N = std::uint64_t{1} << std::min(level, max_level);
  return static_cast<std::uint32_t>((N + 1) * (N + 2) / 2);
}

namespace detail {

/// r(r+1)/2, no product beyond it.  Domain: r in [0, 2^16].
constexpr std::uint32_t triangular(std::uint32_t r) noexcept { return ((r + 1) >> 1) * (r | 1); }

/// The greatest r with r(r+1)/2 <= x: floor((sqrt(8x+1) - 1) / 2).
/// Domain: x in [0, V(16)).  The binary64 root is safe: 8x+1 is exact, and where it is the square of 2r+1 the root is
/// exact as well; below such a square the true root is short of 2r+1 by more than 1/(2r+1) > 2^-18, far more than the
/// rounding.
inline std::uint32_t triangular_root(std::uint32_t x) noexcept {
  return static_cast<std::uint32_t>((std::sqrt(8.0 * x + 1.0) - 1.0) * 0.5);
}

/// The number on the curve of a micro-triangle, by its square and its row = iu + iv + upper.
constexpr std::uint32_t curve_number(std::uint32_t iu, std::uint32_t iv, std::uint32_t row) noexcept {
  const std::uint32_t b0 = iu ^ row, t = (iu ^ iv) & b0;
  const std::uint32_t b1 = ((index::detail::xor_from_above(t) ^ iu) & ~b0) | t;
  return index::detail::interleaved(b0, b1);
}

/// The square of a number on the curve, given as its digits' bits b0 and b1, and whether it is the upper half.
constexpr MicroTriangle curve_square(std::uint32_t b0, std::uint32_t b1) noexcept {
  const std::uint32_t t = b0 & b1, f = index::detail::xor_from_above(t),
                      m = index::detail::xor_from_above(b0 & ~b1), inverted = m >> 1;
  return {(b0 & inverted) | (~b0 & (b1 ^ f)), inverted ^ t, (m & 1) != 0};
}

}  // namespace detail

// ---- Vertices

/// Index of a vertex in rows counted from the w-corner: r(r+1)/2 + j, r = i+j; the level does not enter.
/// Domain: a vertex of a level in 0..16.  Source: Color and Attribute Micromaps, 3.1 and figure 4.
/// Law: attribute.order_is_walk, attribute.w_minor_all_levels
constexpr std::uint32_t w_minor_index(std::uint32_t i, std::uint32_t j) noexcept {
  return detail::triangular(i + j) + j;
}

/// Index of a vertex in columns counted from the edge w-v: i(N+2) - i(i+1)/2 + j = V(n) - 1 - (r(r+1)/2 + r - j),
/// r = N-i.  Domain: a vertex of the level; level in 0..16, more is 16.
/// Source: Color and Attribute Micromaps, 3.1 (U-major); the closed form is ours.
/// Law: attribute.order_is_walk, attribute.u_major_all_levels
constexpr std::uint32_t u_major_index(std::uint32_t i, std::uint32_t j, Level level) noexcept {
  const std::uint32_t r = (std::uint32_t{1} << std::min(level, max_level)) - i;
  return vertex_count(level) - 1 - detail::triangular(r) - r + j;
}

/// Index of a vertex in the hierarchical order.  Corners w, u, v: 0, 1, 2.  Else, with m the first level that has the
/// vertex, (i, j) its place there and x the number on the curve at level m-1 of the lower micro-triangle of square
/// (i/2, j/2):
///   V(m-1) + 3 (x + floor(j/2)) / 2 + e,  e = 0 where i is even, 1 where i and j are odd, 2 where j is even
/// (x + floor(j/2)) / 2 of the micro-triangles before x are upright: there are iv = row - iu more upright than turned
/// ones, the sum of the digits' low bits b0 = iu XOR row, each with the sign of its node.
/// Domain: a vertex of the level; level in 0..16, more is 16.
/// Source: Color and Attribute Micromaps, 3.1 (Bird); the closed form is ours.
/// Law: attribute.order_is_walk, attribute.bird_all_levels
constexpr std::uint32_t bird_index(std::uint32_t i, std::uint32_t j, Level level) noexcept {
  const std::uint32_t N = std::uint32_t{1} << std::min(level, max_level);
  // At the corner w, where i | j is 0, N keeps the shift below 32 bits.
  const int s = std::countr_zero(i | j | N);
  const std::uint32_t M = N >> s >> 1;  // 2^(m-1)
  if (M == 0) return (i != 0 ? 1u : 0u) + (j != 0 ? 2u : 0u);
  i >>= s;
  j >>= s;
  const std::uint32_t e = (i & 1) == 0 ? 0 : 2 - (j & 1), a = i >> 1, b = j >> 1;
  return (M + 1) * (M + 2) / 2 + 3 * ((detail::curve_number(a, b, a + b) + b) >> 1) + e;
}

/// Index of a vertex in an order.  Domain: a vertex of the level; level in 0..16, more is 16.  Elsewhere the result is
/// some number.
/// Law: attribute.order_is_walk, attribute.order_bijective, attribute.vertices_on_samples
constexpr std::uint32_t vertex_index(VertexOrder order, std::uint32_t i, std::uint32_t j,
                                     Level level) noexcept {
  return order == VertexOrder::w_minor   ? w_minor_index(i, j)
         : order == VertexOrder::u_major ? u_major_index(i, j, level)
                                         : bird_index(i, j, level);
}

/// The vertex of an index in W-minor rows.  Domain: index in [0, V(16)).
/// Law: attribute.order_inverse
inline Vertex w_minor_vertex(std::uint32_t index) noexcept {
  const std::uint32_t r = detail::triangular_root(index), j = index - detail::triangular(r);
  return {r - j, j};
}

/// The vertex of an index in U-major columns.  Domain: index in [0, V(level)); level in 0..16, more is 16.
/// Law: attribute.order_inverse
inline Vertex u_major_vertex(std::uint32_t index, Level level) noexcept {
  const std::uint32_t N = std::uint32_t{1} << std::min(level, max_level), y = vertex_count(level) - 1 - index;
  const std::uint32_t r = detail::triangular_root(y), c = y - detail::triangular(r);
  return {N - r, r - c};
}

/// The vertex of an index in the hierarchical order.  The first level m that has the vertex follows from V(m-1) <=
/// index < V(m).  Then upright micro-triangle number k of level m-1 is found on the curve, digit by digit: two
/// neighbouring subtrees hold S^2 upright ones.
/// Domain: index in [0, V(level)); level in 0..16, more is 16.
/// Law: attribute.order_inverse
constexpr Vertex bird_vertex(std::uint32_t index, Level level) noexcept {
  const Level n = std::min(level, max_level);
  const std::uint32_t N = std::uint32_t{1} << n;
  if (index < 3) return {index == 1 ? N : 0, index == 2 ? N : 0};
  // The greatest d with V(d) <= index: as 4^d < 2 V(d), none above log2(2 index) / 2; it is that or the one below.
  Level d = static_cast<Level>(std::bit_width(2 * std::uint64_t{index}) - 1) / 2;
  while (vertex_count(d) > index) --d;
  const std::uint32_t from_d = index - vertex_count(d), e = from_d % 3;
  std::uint32_t k = from_d / 3, b0 = 0, b1 = 0;
  bool upright = true;
  for (Level l = d; l-- > 0;) {
    const std::uint32_t S = std::uint32_t{1} << l, first = (S * S + (upright ? S : -S)) / 2;
    const bool high = k >= S * S;
    k -= high ? S * S : 0;
    const bool low = k >= first;
    k -= low ? first : 0;
    b1 = 2 * b1 + high;
    b0 = 2 * b0 + low;
    upright = upright != (low && !high);
  }
  const MicroTriangle t = detail::curve_square(b0, b1);
  const Level up = n - d - 1;
  return {(2 * t.iu + (e != 0)) << up, (2 * t.iv + (e != 2)) << up};
}

/// The vertex of an index in an order.  Domain: index in [0, V(level)); level in 0..16, more is 16.  Elsewhere the
/// result is some vertex or none.
/// Law: attribute.order_inverse, attribute.vertices_on_samples
inline Vertex vertex_at(VertexOrder order, std::uint32_t index, Level level) noexcept {
  return order == VertexOrder::w_minor   ? w_minor_vertex(index)
         : order == VertexOrder::u_major ? u_major_vertex(index, level)
                                         : bird_vertex(index, level);
}

/// Many vertices, i and j apart.
struct VertexSpans {
  std::span<std::uint32_t> i, j;
};

/// The same for spans: out[k] = vertex_index(order, i[k], j[k], level), and back.
/// Domain: any length, any alignment; all spans have one length, or std::invalid_argument is thrown and nothing is
/// written.  No span written may overlap another.
/// Law: attribute.order_is_walk, attribute.order_inverse, attribute.vertices_on_samples
void vertex_index(VertexOrder order, std::span<const std::uint32_t> i, std::span<const std::uint32_t> j,
                  Level level, std::span<std::uint32_t> out);
void vertex_at(VertexOrder order, std::span<const std::uint32_t> index, Level level, const VertexSpans& out);

/// Converts indices: out[k] = vertex_index(to, vertex_at(from, index[k], level), level).  Domain: as above; out may be
/// index itself.
/// Law: attribute.convert
void convert(VertexOrder from, VertexOrder to, std::span<const std::uint32_t> index, Level level,
             std::span<std::uint32_t> out);

// ---- Faces

/// Index of a micro-triangle in an order: its number on the curve; r^2 + 2 iv + upper, r = iu+iv+upper;
/// 4^n - (N-iu)^2 + 2 iv + upper.
/// Domain: a micro-triangle of the level; level in 0..16, more is 16.  Elsewhere the result is some number.
/// Source: VK_EXT_opacity_micromap, appendix "Reference Code"; Color and Attribute Micromaps, figure 4 and 3.1.
/// Law: attribute.face_orders, attribute.faces_on_samples
constexpr std::uint32_t face_index(FaceOrder order, const MicroTriangle& t, Level level) noexcept {
  const Level n = std::min(level, max_level);
  const std::uint32_t up = t.upper ? 1 : 0, row = t.iu + t.iv + up, left = (std::uint32_t{1} << n) - t.iu;
  // 4^16 wraps to 0 and the difference back.
  const auto all = static_cast<std::uint32_t>(std::uint64_t{1} << (2 * n));
  return order == FaceOrder::curve  ? detail::curve_number(t.iu, t.iv, row)
         : order == FaceOrder::rows ? row * row + 2 * t.iv + up
                                    : all - left * left + 2 * t.iv + up;
}

/// The micro-triangle of an index.  Domain: index in [0, 4^level), level in 0..16, more is 16.  Elsewhere the result is
/// some micro-triangle or none.
/// Law: attribute.face_orders, attribute.faces_on_samples
inline MicroTriangle face_at(FaceOrder order, std::uint32_t index, Level level) noexcept {
  const Level n = std::min(level, max_level);
  if (order == FaceOrder::curve) {
    const std::uint32_t low = (std::uint32_t{1} << n) - 1;
    return detail::curve_square(impl::detail::gathered<32>(index) & low,
                                impl::detail::gathered<32>(index >> 1) & low);
  }
  const auto all = static_cast<std::uint32_t>(std::uint64_t{1} << (2 * n));
  if (order == FaceOrder::rows) {
    const std::uint32_t row = index::w_minor_row(index), c = index - row * row;
    return {row - ((c + 1) >> 1), c >> 1, (c & 1) != 0};
  }
  const std::uint32_t left = index::w_minor_row(all - 1 - index) + 1, c = index - (all - left * left);
  return {(std::uint32_t{1} << n) - left, c >> 1, (c & 1) != 0};
}

/// Many micro-triangles; `upper` is 0 or 1.
struct FaceSpans {
  std::span<std::uint32_t> iu, iv, upper;
};

/// The same for spans, with `upper` 0 or 1.  Domain: as the spans of vertices.
/// Law: attribute.face_orders, attribute.faces_on_samples
void face_index(FaceOrder order, std::span<const std::uint32_t> iu, std::span<const std::uint32_t> iv,
                std::span<const std::uint32_t> upper, Level level, std::span<std::uint32_t> out);
void face_at(FaceOrder order, std::span<const std::uint32_t> index, Level level, const FaceSpans& out);

/// Converts indices; out may be index itself.
/// Law: attribute.convert_faces
void convert(FaceOrder from, FaceOrder to, std::span<const std::uint32_t> index, Level level,
             std::span<std::uint32_t> out);

// ---- Faces and their vertices

/// Corners of a micro-triangle: the base, and one step along u and along v from there, +1 or, in an upper one, -1:
///   lower (iu, iv) (iu+1, iv) (iu, iv+1);  upper (iu+1, iv+1) (iu, iv+1) (iu+1, iv)
/// Law: attribute.triangle_vertices
constexpr std::array<Vertex, 3> corners_of(const MicroTriangle& t) noexcept {
  const std::uint32_t up = t.upper ? 1 : 0, i = t.iu + up, j = t.iv + up;
  return {Vertex{i, j}, Vertex{i + 1 - 2 * up, j}, Vertex{i, j + 1 - 2 * up}};
}

/// Indices of a micro-triangle's corners, in that order.  Domain: a micro-triangle of the level; level in 0..16, more
/// is 16.
/// Law: attribute.triangle_vertices, attribute.faces_on_samples
constexpr std::array<std::uint32_t, 3> triplet(VertexOrder order, const MicroTriangle& t,
                                               Level level) noexcept {
  const auto c = corners_of(t);
  return {vertex_index(order, c[0].i, c[0].j, level), vertex_index(order, c[1].i, c[1].j, level),
          vertex_index(order, c[2].i, c[2].j, level)};
}

/// The micro-triangle of a triplet, from its first two indices alone.  Domain: the triplet of a micro-triangle.
/// Law: attribute.triangle_vertices
inline MicroTriangle triangle_of(VertexOrder order, const std::array<std::uint32_t, 3>& index,
                                 Level level) noexcept {
  const Vertex a = vertex_at(order, index[0], level), b = vertex_at(order, index[1], level);
  return b.i > a.i ? MicroTriangle{a.i, a.j, false} : MicroTriangle{b.i, b.j - 1, true};
}

/// Many triplets: corner c of face k is x<c>[k].
struct TripletSpans {
  std::span<std::uint32_t> x0, x1, x2;
};

/// The vertices of faces, both by index: triplet(vertices, face_at(faces, face[k], level), level); and the faces, from
/// the first two indices of each triplet.  Domain: as the spans of vertices.
/// Law: attribute.triangle_vertices, attribute.faces_on_samples
void triplets(FaceOrder faces, VertexOrder vertices, std::span<const std::uint32_t> face, Level level,
              const TripletSpans& out);
void faces_of(FaceOrder faces, VertexOrder vertices, std::span<const std::uint32_t> x0,
              std::span<const std::uint32_t> x1, Level level, std::span<std::uint32_t> out);

}  // namespace mmverify::impl::attribute
