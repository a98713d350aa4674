// Binary numbers taken apart, for whole-number arithmetic.  Internal to impl.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace mmverify::impl::bake::detail {

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
inline Binary binary(float x) noexcept {
  if (x == 0) return {};
  int e;
  const float half = std::frexp(x, &e);
  return normal(static_cast<std::int64_t>(std::ldexp(half, 24)), e - 24);  // 24 bits: exact
}

/// The number in binary64, rounded once.
inline double rounded(const Binary& b) noexcept { return std::ldexp(static_cast<double>(b.m), b.e); }

/// The number of bits of |x|.
inline int bits(std::int64_t x) noexcept {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(x < 0 ? -x : x)));
}

}  // namespace mmverify::impl::bake::detail
