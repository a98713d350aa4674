// Binary numbers taken apart, for whole-number arithmetic.  Internal to impl.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace mmverify::impl {

/// The number m 2^e; m is odd, or both are 0.
struct Binary {
  std::int64_t m = 0;
  int e = 0;
};

/// m 2^e with an odd m.  Domain: |m| < 2^63; e + 62 fits int.
inline Binary normal(std::int64_t m, int e) noexcept {
  if (m == 0) return {};
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(m));
  return {m / (std::int64_t{1} << zeros), e + zeros};
}

/// x taken apart.  Domain: finite x.
/// Source: IEEE 754-2019, 3.4.
inline Binary binary(float x) noexcept {
  const auto word = std::bit_cast<std::uint32_t>(x), field = word >> 23 & 0xff;
  const std::int64_t size = (word & 0x7fffff) | (field == 0 ? 0 : 0x800000);
  return normal(word >> 31 != 0 ? -size : size, (field == 0 ? 1 : static_cast<int>(field)) - 150);
}

inline Binary binary(double x) noexcept {
  int e = 0;
  const double half = std::frexp(x, &e);
  return normal(static_cast<std::int64_t>(std::ldexp(half, 53)), e - 53);
}

/// The number in binary64, rounded once.
inline double rounded(const Binary& b) noexcept { return std::ldexp(static_cast<double>(b.m), b.e); }

/// The number of bits of |x|.
inline int bits(std::int64_t x) noexcept {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(x < 0 ? -x : x)));
}

}  // namespace mmverify::impl
