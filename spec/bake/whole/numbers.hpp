// Whole numbers of a few widths, all with the same operations: 128 bits of the compiler, and Boost's, which throw
// std::overflow_error beyond theirs.
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <stdexcept>

#include "spec/bake/texture.hpp"
#include "spec/fixed.hpp"

namespace mmverify::spec::bake::whole {

template <unsigned bits>
using Checked = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    bits, bits, boost::multiprecision::signed_magnitude, boost::multiprecision::checked, void>>;

/// A width, and one that holds the product of two numbers of it.
template <class Narrow, class Wide, int narrow_bits>
struct Width {
  using N = Narrow;
  using W = Wide;
  static constexpr int bits = narrow_bits;  ///< of a magnitude in N
};
using Width128 = Width<Int128, Checked<256>, 127>;
using Width256 = Width<Checked<256>, Checked<512>, 256>;
using Width512 = Width<Checked<512>, Checked<1024>, 512>;

/// The number of bits of a magnitude: 0 for 0, else k with 2^(k-1) <= |x| < 2^k.
inline int bit_length(std::int64_t x) {
  return static_cast<int>(
      std::bit_width(x < 0 ? 0 - static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x)));
}
inline int bit_length(Int128 x) {
  const Int128 size = x < 0 ? -x : x;
  const auto high = static_cast<std::uint64_t>(size >> 64);
  return static_cast<int>(high != 0 ? 64 + std::bit_width(high)
                                    : std::bit_width(static_cast<std::uint64_t>(size)));
}
template <class N>
int bit_length(const N& x) {
  return x == 0 ? 0 : 1 + static_cast<int>(msb(N(abs(x))));
}

/// The number of zeros below the lowest 1.  Domain: x != 0.
inline int trailing_zeros(Int128 x) {
  const auto low = static_cast<std::uint64_t>(x);
  return low != 0 ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(x >> 64));
}
template <class N>
int trailing_zeros(const N& x) {
  return static_cast<int>(lsb(N(abs(x))));
}

/// floor(a / b).  Domain: b > 0.
template <class N>
N floor_div(const N& a, const N& b) {
  const N q = a / b;
  return q * b > a ? N(q - 1) : q;
}
inline Int128 floor_div(Int128 a, Int128 b) {
  const auto a64 = static_cast<std::int64_t>(a), b64 = static_cast<std::int64_t>(b);
  if (a64 == a && b64 == b) return a64 / b64 - (a64 % b64 < 0 ? 1 : 0);
  return a / b - (a % b < 0 ? 1 : 0);
}

/// floor(x / 2^d).  Domain: d >= 0.
inline Int128 floor_shift(Int128 x, int d) { return x >> d; }
template <class N>
N floor_shift(const N& x, int d) {
  return floor_div(x, N(N(1) << d));
}

/// The number m 2^e, m odd, or 0.
struct Dyadic {
  std::int64_t m;
  int e;
};

/// The number of a binary32.  Errors: std::invalid_argument for NaN and infinities.
inline Dyadic dyadic(Binary32 x) {
  const std::uint32_t exponent = x.bits >> 23 & 255, fraction = x.bits & 0x7fffff;
  if (exponent == 255) throw std::invalid_argument("bake: a number that is not finite");
  const std::uint32_t m = exponent == 0 ? fraction : fraction | 0x800000;
  if (m == 0) return {0, 0};
  const int zeros = std::countr_zero(m);
  const auto odd = static_cast<std::int64_t>(m >> zeros);
  return {x.bits >> 31 != 0 ? -odd : odd, static_cast<int>(exponent == 0 ? 1 : exponent) - 150 + zeros};
}

}  // namespace mmverify::spec::bake::whole
