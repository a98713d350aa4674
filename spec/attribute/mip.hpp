// Mip chains of micromaps, and the level of detail that a ray cone asks for.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spec/attribute/order.hpp"
#include "spec/number.hpp"

namespace mmverify::spec::attribute {

// ---- Faces: the mean of four children

/// The rounding of a mean of codes.  The paper names none.
enum class Rounding : std::uint32_t {
  half_up,       ///< to the nearest, halves up
  half_to_even,  ///< to the nearest, halves to the even one
  truncate,      ///< down
  halves_up,     ///< two means of two, and their mean, each with halves up: (x + y + 1) / 2
};
inline constexpr std::array roundings{Rounding::half_up, Rounding::half_to_even, Rounding::truncate,
                                      Rounding::halves_up};

/// sum / count as a code.  Domain: count > 0; not halves_up, which is no function of the sum.
constexpr std::uint64_t rounded(std::uint64_t sum, std::uint64_t count, Rounding rounding) {
  const std::uint64_t down = sum / count, left = sum % count;
  if (rounding == Rounding::truncate || 2 * left < count) return down;
  if (rounding == Rounding::half_to_even && 2 * left == count) return down + down % 2;
  return down + 1;
}

/// The mean of the four children as a code.
constexpr std::uint8_t mean_code(const std::array<std::uint8_t, 4>& children, Rounding rounding) {
  const auto [a, b, c, d] = children;
  const auto half = [](std::uint32_t x, std::uint32_t y) { return (x + y + 1) / 2; };
  if (rounding == Rounding::halves_up) return static_cast<std::uint8_t>(half(half(a, b), half(c, d)));
  return static_cast<std::uint8_t>(rounded(std::uint64_t{a} + b + c + d, 4, rounding));
}

/// The map one level below, exactly: value k is the mean of the values 4k..4k+3, the children of micro-triangle k on
/// the curve, which have equal areas.  (In row order or U-major order these are no siblings.)
/// Domain: 4^n values in the order of the curve, n >= 1.  Source: Color and Attribute Micromaps, 4.4.
template <Coordinate Q>
std::vector<Q> face_mip(std::span<const Q> values) {
  std::vector<Q> means;
  for (std::size_t k = 0; 4 * k < values.size(); ++k)
    means.push_back((values[4 * k] + values[4 * k + 1] + values[4 * k + 2] + values[4 * k + 3]) / Q(4));
  return means;
}

/// The map one level below, in codes.
inline std::vector<std::uint8_t> face_mip(std::span<const std::uint8_t> codes, Rounding rounding) {
  std::vector<std::uint8_t> means;
  for (std::size_t k = 0; 4 * k < codes.size(); ++k)
    means.push_back(
        mean_code({codes[4 * k], codes[4 * k + 1], codes[4 * k + 2], codes[4 * k + 3]}, rounding));
  return means;
}

/// The number of values of the levels below m, 1 + 4 + ... + 4^(m-1) = (4^m - 1) / 3, which is also the place of level
/// m in a chain stored from the coarsest level up.  The whole chain of level n ends at face_chain(n + 1).
/// Domain: m in 0..31.  Source: Color and Attribute Micromaps, 4.4: "roughly 33 %".
constexpr std::uint64_t face_chain(Level m) { return (face_count(m) - 1) / 3; }

// ---- Vertices: a lower level

/// The place, in the map of level n >= m, of the value of vertex k of level m: the same place of the triangle is vertex
/// (i 2^(n-m), j 2^(n-m)).  In the Bird order that is k itself, so that a map begins with all its mips; in the others
/// it is a stride.  Nothing is stored beside the map.
/// Domain: k in [0, V(m)), m <= n, n in 0..16.
/// Source: Color and Attribute Micromaps, 4.4.1: "a lower subdivision level ... in the same way".
constexpr std::uint64_t vertex_mip_source(VertexOrder order, std::uint64_t k, Level m, Level n) {
  const Vertex x = vertex_at(order, k, m);
  return vertex_index(order, Vertex{x.i << (n - m), x.j << (n - m)}, n);
}

/// The number of values of the levels below m, if each is stored: ((4^m - 1)/3 + 3 (2^m - 1) + 2m) / 2.
/// Domain: m in 0..30.
constexpr std::uint64_t vertex_chain(Level m) {
  const std::uint64_t M = side(m);
  return (face_chain(m) + 3 * (M - 1) + 2 * m) / 2;
}

// ---- Level of detail

/// The last level whose micro-triangles the cone does not outgrow: the greatest m in 0..n with 4^m A_c <= A_t, which is
/// floor(1/2 log2(A_t / A_c)) clamped to 0..n; 0 if there is none.
/// So a cone of area 0 asks for level n, and a triangle of area 0 for level 0, unless the cone's is 0, too.
/// Domain: areas >= 0, n in 0..16.
/// Source: Color and Attribute Micromaps, 4.4.2; which reading of it: docs/ERRATA.md.
template <Coordinate Q>
constexpr Level lod_level(const Q& cone, const Q& triangle, Level n) {
  Q grown = cone;
  Level m = 0;
  // The areas 4^m A_c, in the order in which they grow.  The inequality is tested from level 1 on.
  for (grown = times(4, grown); m < n && !(triangle < grown); grown = times(4, grown)) ++m;
  return m;
}

/// The first level whose micro-triangles are no larger than the cone, A_c >= A_t / 4^m: ceil(1/2 log2(A_t / A_c)), from
/// 0 on.  Domain: as lod_level, A_c > 0.  Source: the formula of 4.4.2.
template <Coordinate Q>
constexpr Level first_level_covered(const Q& cone, const Q& triangle) {
  Level m = 0;
  for (Q grown = cone; grown < triangle; grown = times(4, grown)) ++m;
  return m;
}

/// The first level whose micro-triangles are smaller than the cone, A_c > A_t / 4^m: floor(1/2 log2(A_t / A_c)) + 1, from
/// 0 on.  Domain: as first_level_covered.  Source: the words of 4.4.2.
template <Coordinate Q>
constexpr Level first_level_exceeded(const Q& cone, const Q& triangle) {
  Level m = 0;
  for (Q grown = cone; !(triangle < grown); grown = times(4, grown)) ++m;
  return m;
}

/// Bounds of x: low <= 2^bits x <= high.
struct Bounds {
  Integer low, high;
};

namespace detail {

/// floor or ceil of 2^bits 1/2 log2(r), one digit after the other: the first digit is r >= 2, the next is that of the
/// square, and so on.  r is in units of 2^-point, rounded down or up after each step; so the result is too low or too
/// high, never on the other side.  Domain: r in [1, 4).
inline Integer half_log2(Integer r, unsigned point, unsigned bits, bool up) {
  const Integer one = Integer(1) << point, two = one << 1;
  const auto shifted = [up](const Integer& x, unsigned by) {
    Integer q = x >> by;
    if (up && (q << by) != x) ++q;
    return q;
  };
  Integer digits = 0;
  bool rest = false;
  for (unsigned k = 0; k < bits; ++k) {
    if (k != 0) r = shifted(r * r, point);
    digits <<= 1;
    if (r >= two) {
      ++digits;
      r = shifted(r, 1);
    }
    rest = r != one;
  }
  return up && rest ? digits + 1 : digits;
}

}  // namespace detail

/// Bounds of t = 1/2 log2(A_t / (4^m A_c)), the weight of level m + 1 where level m has 1 - t.  It is irrational but
/// for powers of 2.  The bounds are 2 units apart at most while bits <= 64.
/// Domain: 4^m A_c <= A_t < 4^(m+1) A_c, A_c > 0.  Source: Color and Attribute Micromaps, 4.4.2, step 3.
inline Bounds lod_blend(const Rational& cone, const Rational& triangle, Level m, unsigned bits) {
  const unsigned point = 2 * bits + 64;
  const Rational r = triangle / (cone * Rational(Integer(1) << (2 * m)));
  const Integer scaled = r.numerator() << point, down = scaled / r.denominator();
  const Integer up = down * r.denominator() == scaled ? down : Integer(down + 1);
  return {detail::half_log2(down, point, bits, false), detail::half_log2(up, point, bits, true)};
}

}  // namespace mmverify::spec::attribute
