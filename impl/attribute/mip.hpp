// Mips of face maps in RGBA8, and the level of detail that a ray cone asks for.
//
//   face_mip              the map one level below: means of four children along the curve
//   face_chain            all levels below, each from the one above it, or from the exact sums
//   lod_level, lod        the two levels that a cone asks for, and the share of each
//
// IEEE arithmetic must be rounded to nearest, the default (no -ffast-math).
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

#include "impl/attribute/order.hpp"

namespace mmverify::impl::attribute {

// ---- Mips

/// The rounding of the mean of four codes.  Its drift is the mean of code - mean over all quadruples of codes: the
/// average error that each level adds in a chain where each level is made from the one above it.
enum class Rounding : std::uint32_t {
  half_up,       ///< (a + b + c + d + 2) / 4; drift +1/8
  half_to_even,  ///< to the nearest, halves to the even one; drift 0
  truncate,      ///< (a + b + c + d) / 4; drift -3/8
  halves_up,     ///< h(h(a, b), h(c, d)), h(x, y) = (x + y + 1) / 2; drift +1/2
};

/// parents[k] = the mean of children[4k..4k+3] in each of the four codes, which are the bytes of a word in any order.
/// So the map of level n-1 follows from that of level n, both in the order of the curve.
/// Domain: any length, any alignment; four children a parent, or std::invalid_argument is thrown and nothing is written.
/// parents must not overlap children, but may begin where these do.
/// Source: Color and Attribute Micromaps, 4.4, which names no rounding.
/// Law: attribute.face_mip_is_mean, attribute.mip_rounding, attribute.mip_on_samples
void face_mip(std::span<const std::uint32_t> children, Rounding rounding, std::span<std::uint32_t> parents);

/// The number of values of the levels below m, and the place of level m in a chain stored from the coarsest level up:
/// (4^m - 1) / 3.  Domain: m in 0..31.
/// Law: attribute.face_mip_counts
constexpr std::uint64_t face_chain_size(Level m) noexcept { return ((std::uint64_t{1} << (2 * m)) - 1) / 3; }

/// The same for vertices, if the levels below m are stored one by one: ((4^m - 1)/3 + 3 (2^m - 1) + 2m) / 2.  The Bird
/// order stores no levels beside the map: level m is the first (M+1)(M+2)/2 values of every finer one, M = 2^m.
/// Domain: m in 0..30.
/// Law: attribute.face_mip_counts
constexpr std::uint64_t vertex_chain_size(Level m) noexcept {
  const std::uint64_t M = std::uint64_t{1} << m;
  return (face_chain_size(m) + 3 * (M - 1) + 2 * m) / 2;
}

/// The place, in the map of level n, of the value of vertex k of level m: k in the Bird order, else the index of
/// (i 2^(n-m), j 2^(n-m)), where (i, j) is the vertex.  No mip of vertices is stored.
/// Domain: m <= n <= 16, k a vertex of level m.
/// Source: Color and Attribute Micromaps, 4.4.1.
/// Law: attribute.vertex_mip_is_prefix
inline std::uint32_t vertex_mip_source(VertexOrder order, std::uint32_t k, Level m, Level n) noexcept {
  if (order == VertexOrder::bird) return k;
  const Vertex x = vertex_at(order, k, m);
  return vertex_index(order, x.i << (n - m), x.j << (n - m), n);
}

/// The source of each level of a chain.
enum class ChainOf : std::uint32_t {
  level_above,  ///< the codes above, rounded once more: off by up to 1/2 (truncate 3/4, halves_up 1) for each level
  exact_sums,  ///< the sums of the base's codes: off by 1/2 at most (truncate: below 1)
};

/// The levels 0..n-1 below a base of level n, the coarsest first: chain has face_chain_size(level) values, and level m
/// begins at face_chain_size(m).
/// Domain: level in 0..12, 4^level values in base; exact_sums has no halves_up; std::invalid_argument otherwise, and nothing
/// is written.  chain must not overlap base.
/// Law: attribute.face_mip_is_mean, attribute.mip_chain_error
void face_chain(Level level, std::span<const std::uint32_t> base, Rounding rounding, ChainOf of,
                std::span<std::uint32_t> chain);

// ---- Level of detail

namespace detail {
/// Areas in binary64, in which every positive float is a normal number.  NaN and everything below zero become 0.
inline double area(float x) noexcept { return static_cast<double>(std::max(0.0f, x)); }
inline std::int64_t bits_of(double x) noexcept { return std::bit_cast<std::int64_t>(x); }
}  // namespace detail

/// The greatest m in 0..level with 4^m cone <= triangle, 0 if there is none: floor(1/2 log2(triangle / cone)), clamped
/// to 0..level.  Exact for every pair of finite floats: a positive double read as a whole number is exponent 2^52 +
/// fraction, so the difference of two, shifted by 52, is e_t - e_c, less 1 if the first fraction is less.
/// Domain: every bit pattern; NaN and areas below 0 count as 0.  A cone of area 0 gives `level`.  level in 0..16, more
/// is 16.
/// Source: Color and Attribute Micromaps, 4.4.2; docs/ERRATA.md for its readings.
/// Law: attribute.lod_level
inline Level lod_level(float cone, float triangle, Level level) noexcept {
  const Level n = std::min(level, max_level);
  const double c = detail::area(cone), t = detail::area(triangle);
  if (c == 0) return n;
  const std::int64_t half = (detail::bits_of(t) - detail::bits_of(c)) >> 53;
  return static_cast<Level>(std::clamp<std::int64_t>(half, 0, n));
}

/// Two levels of a chain: level m has the weight 1 - blend, level m + 1 the weight blend.
struct Lod {
  Level level;
  float blend;  ///< in [0, 1)
};

/// lod_level, and blend = 1/2 log2(triangle / (4^m cone)) within 2^-24; 0 at the last level, and if the cone is no
/// smaller than the triangle.
/// Domain: as lod_level; areas finite.  Source: Color and Attribute Micromaps, 4.4.2, step 3.
/// Law: attribute.lod_blend
Lod lod(float cone, float triangle, Level level) noexcept;

/// The levels of many pairs: out[k] = lod_level(cone[k], triangle[k], level).
/// Domain: three spans of one length, or std::invalid_argument is thrown and nothing is written.
/// Law: attribute.lod_level
void lod_level(std::span<const float> cone, std::span<const float> triangle, Level level,
               std::span<Level> out);

}  // namespace mmverify::impl::attribute
