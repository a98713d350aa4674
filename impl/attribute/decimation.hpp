// Edge decimation of micro-vertex maps: exact for binary32 input, one at a time.
//
//   snapped             the vertex that a value is read from, if edges have a neighbour of level n-1
//   averaged            the other rule: the two vertices whose mean is the value
//   mean_rgba8          that mean, in codes
//   decimated_lookup    three vertices and their weights at a point, with the edges decimated
//
// IEEE arithmetic must be rounded to nearest, the default (no -ffast-math).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "impl/attribute/order.hpp"

namespace mmverify::impl::attribute {

/// A bit for each edge whose neighbour has level n-1: 1 edge w-u (v = 0), 2 edge u-v (w = 0), 4 edge v-w (u = 0); other
/// bits are ignored.
using EdgeFlags = std::uint32_t;

namespace detail {
/// Whether the vertex is one of level n, and level n has odd vertices on its edges.
constexpr bool may_move(Vertex x, std::uint32_t N) noexcept { return N > 1 && x.i <= N && x.j <= N - x.i; }
}  // namespace detail

/// The vertex from which the value of x is read.  An odd vertex of a flagged edge snaps to the even neighbour that is
/// farther from the edge's middle.  At level 1 the odd vertex is the middle; it snaps to w, u, v on the edges w-u, u-v,
/// v-w.  With k = N-i-j:
///   v = 0: i+1 if k < N/2, else i-1     w = 0: (i-1, j+1) if i < N/2, else (i+1, j-1)     u = 0: j+1 if j >= N/2, else j-1
/// Domain: level in 0..16, more is 16; a vertex outside the triangle stays.
/// Source: BaryFile's rule; Color and Attribute Micromaps, figure 3.
/// Law: attribute.decimation_watertight, attribute.decimation_on_samples
constexpr Vertex snapped(Vertex x, Level level, EdgeFlags flags) noexcept {
  const std::uint32_t N = std::uint32_t{1} << std::min(level, max_level), middle = N / 2;
  if (!detail::may_move(x, N)) return x;
  const std::uint32_t k = N - x.i - x.j;
  const bool odd_i = x.i % 2 != 0, odd_j = x.j % 2 != 0;
  if ((flags & 1) != 0 && x.j == 0 && odd_i) return {k < middle ? x.i + 1 : x.i - 1, 0};
  if ((flags & 2) != 0 && k == 0 && odd_j)
    return x.i < middle ? Vertex{x.i - 1, x.j + 1} : Vertex{x.i + 1, x.j - 1};
  if ((flags & 4) != 0 && x.i == 0 && odd_j) return {0, x.j < middle ? x.j - 1 : x.j + 1};
  return x;
}

/// The two vertices whose mean is the value of x where edges are decimated by means: an odd vertex's neighbours on its
/// flagged edge, else x twice.  Domain: as snapped.
/// Law: attribute.decimation_means
constexpr std::array<Vertex, 2> averaged(Vertex x, Level level, EdgeFlags flags) noexcept {
  const std::uint32_t N = std::uint32_t{1} << std::min(level, max_level);
  if (!detail::may_move(x, N)) return {x, x};
  const std::uint32_t k = N - x.i - x.j;
  const bool odd_i = x.i % 2 != 0, odd_j = x.j % 2 != 0;
  if ((flags & 1) != 0 && x.j == 0 && odd_i) return {Vertex{x.i - 1, 0}, Vertex{x.i + 1, 0}};
  if ((flags & 2) != 0 && k == 0 && odd_j) return {Vertex{x.i + 1, x.j - 1}, Vertex{x.i - 1, x.j + 1}};
  if ((flags & 4) != 0 && x.i == 0 && odd_j) return {Vertex{0, x.j + 1}, Vertex{0, x.j - 1}};
  return {x, x};
}

/// The mean of two RGBA8 values, halves up in each of the four codes, which are the bytes of a word in any order:
/// (x + y + 1) / 2.  It is within half a code of the exact mean.
/// Law: attribute.decimation_half_a_code
constexpr std::uint32_t mean_rgba8(std::uint32_t x, std::uint32_t y) noexcept {
  return (x | y) - ((x ^ y) >> 1 & 0x7f7f7f7f);  // x + y = 2 (x | y) - (x ^ y), byte by byte
}

/// Writes the means into a map of level n: each odd vertex on a flagged edge gets the mean of its even neighbours'
/// values.  values[index_of(x)] is the value of vertex x.  N/2 values change for each flagged edge.
/// Domain: level in 0..16, more is 16; index_of(x) < values.size() for each vertex x.
/// Test: impl_attribute_decimation_test
template <class IndexOf>
void decimate_by_means(std::span<std::uint32_t> values, Level level, EdgeFlags flags, IndexOf index_of) {
  const std::uint32_t N = std::uint32_t{1} << std::min(level, max_level);
  for (std::uint32_t at = 1; at < N; at += 2)
    for (const Vertex x : {Vertex{at, 0}, Vertex{N - at, at}, Vertex{0, at}}) {
      const auto [a, b] = averaged(x, level, flags);
      if (a != b) values[index_of(x)] = mean_rgba8(values[index_of(a)], values[index_of(b)]);
    }
}

/// Three vertices and the weights of their values.
struct VertexWeights {
  std::array<Vertex, 3> vertices;
  std::array<float, 3> weights;
};

/// The three vertices and weights that interpolate a point, after the odd vertices of flagged edges have snapped.  The
/// three vertices are those of a micro-triangle that contains the point, exactly, for the very floats u and v; each
/// weight is within 2^-24 of the exact one.
/// Domain: every bit pattern.  u and v are clamped to [0,1] one by one; NaN counts as 0.  A point outside the triangle
/// gets the micro-triangle next to it, and a weight below 0.  level in 0..16, more is 16.
/// Source: ours: docs/ATTRIBUTE.md, "Decimation"; spec::attribute::decimated_place.
/// Law: attribute.decimation_lookup, attribute.decimation_lookup_on_floats
VertexWeights decimated_lookup(float u, float v, Level level, EdgeFlags flags) noexcept;

}  // namespace mmverify::impl::attribute
