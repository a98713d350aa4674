// A binary32 number as its exact value, in either of the specification's number types.
#pragma once

#include <bit>
#include <cstdint>

#include "spec/fixed.hpp"
#include "spec/rational.hpp"

namespace mmverify::fuzz {

/// The parts of a finite binary32 number: (-1)^negative * significand * 2^exponent.
struct Float {
  bool negative;
  std::uint32_t significand;  ///< below 2^24
  int exponent;               ///< -149 and above
};

/// Takes x apart.  Domain: x finite.  Source: IEEE 754-2019, clause 3.4.
constexpr Float taken_apart(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const std::uint32_t biased = bits >> 23 & 0xff, fraction = bits & 0x7fffff;
  if (biased == 0) return {bits >> 31 != 0, fraction, -149};
  return {bits >> 31 != 0, fraction | 0x800000, static_cast<int>(biased) - 150};
}

/// Whether Fixed128 represents x and everything that the index algorithms form from it up to level 16:
/// x = 0 or 2^-76 <= |x| <= 2.
constexpr bool fits_fixed128(float x) {
  const float magnitude = x < 0 ? -x : x;
  return x == 0 || (magnitude >= 0x1p-76f && magnitude <= 2);
}

/// The value of x.  Domain: fits_fixed128(x).
constexpr spec::Fixed128 exact_fixed128(float x) {
  const Float f = taken_apart(x);
  if (f.significand == 0) return spec::Fixed128::from_raw(0);
  const auto raw = static_cast<spec::Int128>(f.significand)
                   << (f.exponent + int{spec::Fixed128::fraction_bits});
  return spec::Fixed128::from_raw(f.negative ? -raw : raw);
}

/// The value of x.  Domain: x finite.
inline spec::Rational exact_rational(float x) {
  const Float f = taken_apart(x);
  const spec::Integer significand = f.negative ? -spec::Integer(f.significand) : spec::Integer(f.significand);
  if (f.exponent >= 0) return spec::Rational(significand << f.exponent);
  return spec::Rational(significand, spec::Integer(1) << -f.exponent);
}

}  // namespace mmverify::fuzz
