// From binary32 to the exact number types of the specification.
#pragma once

#include <bit>
#include <cstdint>

#include "proofs/index/point.hpp"
#include "spec/fixed.hpp"

namespace mmverify::proofs::index {

/// Whether Fixed128 holds the number: zero, or 2^-76 <= |x| <= 2.
constexpr bool fits_fixed128(float x) {
  const std::uint32_t magnitude = std::bit_cast<std::uint32_t>(x) & 0x7fffffffu;
  constexpr std::uint32_t least = (127u - 76u) << 23, most = 128u << 23;
  return magnitude == 0 || (magnitude >= least && magnitude <= most);
}

/// Domain: fits_fixed128(x).
constexpr spec::Fixed128 fixed128(float x) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(x), magnitude = bits & 0x7fffffffu;
  if (magnitude == 0) return spec::Fixed128(0);
  const int exponent = static_cast<int>(magnitude >> 23) - 127 - 23;
  const spec::Int128 significand = (magnitude & 0x7fffffu) | 0x800000u;
  const spec::Int128 raw = significand << (static_cast<int>(spec::Fixed128::fraction_bits) + exponent);
  return spec::Fixed128::from_raw((bits >> 31) != 0 ? -raw : raw);
}

/// Whether Fixed256 holds the number: any finite one up to 2 in size.
constexpr bool fits_fixed256(float x) {
  return (std::bit_cast<std::uint32_t>(x) & 0x7fffffffu) <= 128u << 23;
}

/// Domain: fits_fixed256(x).
inline spec::Fixed256 fixed256(float x) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(x), exponent = bits >> 23 & 0xffu;
  // A subnormal number has exponent field 0, no leading 1, and the scale of field 1.
  const spec::Int256 significand = (bits & 0x7fffffu) | (exponent == 0 ? 0u : 0x800000u);
  const spec::Int256 raw = significand
                           << (spec::Fixed256::fraction_bits - 150 + (exponent == 0 ? 1 : exponent));
  return spec::Fixed256::from_raw((bits >> 31) != 0 ? spec::Int256(-raw) : raw);
}

/// Calls algorithm(point) with the two numbers exact: in 128-bit fixed point where that holds them, else in
/// 256-bit, else as rationals.
template <class Algorithm>
auto on_exact(float u, float v, Algorithm algorithm) {
  if (fits_fixed128(u) && fits_fixed128(v))
    return algorithm(spec::Point<spec::Fixed128>{fixed128(u), fixed128(v)});
  if (fits_fixed256(u) && fits_fixed256(v))
    return algorithm(spec::Point<spec::Fixed256>{fixed256(u), fixed256(v)});
  return algorithm(RationalPoint{rational(u), rational(v)});
}

}  // namespace mmverify::proofs::index
