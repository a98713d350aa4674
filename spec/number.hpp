// The number types that specifications run on: exact or rounded, one text serves both.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "spec/rational.hpp"  // its whole() must be declared before the concept asks for it

namespace mmverify::spec {

/// A subdivision level n; the base triangle is cut into 4^n micro-triangles, N = 2^n to a side.
using Level = std::uint32_t;

/// N = 2^n, the number of micro-triangles along a side.  Domain: n in 0..31.
constexpr std::uint32_t side(Level n) { return std::uint32_t{1} << n; }

/// floor(q) for 0 <= q < 2^32.  Domain: number types whose conversion truncates.
template <class Q>
requires std::is_arithmetic_v<Q>
constexpr std::uint32_t whole(const Q& q) { return static_cast<std::uint32_t>(q); }

/// The product k q for an integer k.  A rounded type rounds k and the product, each once.
template <class Q>
constexpr Q times(std::uint32_t k, const Q& q) {
  return Q(k) * q;
}

/// A coordinate of the recursion: it has order, + and -, integers and multiplication by them.
template <class Q>
concept Coordinate = std::copyable<Q> && requires(const Q a, const Q b, const std::uint32_t k) {
  {Q(k)};
  { a + b } -> std::convertible_to<Q>;
  { a - b } -> std::convertible_to<Q>;
  { times(k, a) } -> std::convertible_to<Q>;
  { a < b } -> std::convertible_to<bool>;
  { a == b } -> std::convertible_to<bool>;
};

/// A number type that a specification can be run on: a coordinate with whole(q) = floor(q) for q >= 0.  Exact types
/// (Rational, Fixed) make the specification exact.  A rounded type makes it an instance under test and never an oracle.
template <class Q>
concept Number = Coordinate<Q> && requires(const Q a) {
  { whole(a) } -> std::convertible_to<std::uint32_t>;
};

/// A point of the base triangle: u and v belong to its second and third vertex; w = 1-u-v to its first.
template <class Q>
struct Point {
  Q u, v;
};

}  // namespace mmverify::spec
