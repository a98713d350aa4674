// Numbers as they are received, scaled to the grid and compared, none of it rounded.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "tests/foreign/index/faults.hpp"

namespace mmverify::tests::foreign::index {

using Word = std::uint32_t;

inline Word side_of(Word level) { return Word{1} << level; }
inline Word indices_of(Word level) { return level < 16 ? Word{1} << (2 * level) : 0; }  // 2^32 wraps to 0

// ---- numbers

/// The fault-free number is the one that came.
template <bool rows, typename Real>
Real received(Real x) {
  const auto cut = [&](Real scale) { return std::trunc(x * scale) / scale; };
  if (std::is_same_v<Real, double> && has(narrowed)) x = static_cast<Real>(static_cast<float>(x));
  if (has(rows ? rows_fixed_24 : fixed_24)) x = cut(Real(0x1p24));
  if (has(rows ? rows_fixed_32 : fixed_32)) x = cut(Real(0x1p32));
  if (has(rows ? rows_fixed_39 : fixed_39)) x = cut(Real(0x1p39));
  if (has(rows ? rows_flush_30 : flush_30) && x < Real(0x1p-30)) x = 0;
  if (has(rows ? rows_flush_39 : flush_39) && x < Real(0x1p-39)) x = 0;
  if (has(rows ? rows_subnormal_by_significand : subnormal_by_significand) && x < Real(0x1p-126))
    x *= Real(0x1p126);
  if (has(rows ? rows_minus_zero_is_one : minus_zero_is_one) && std::signbit(x)) x = 1;
  return std::clamp(x, Real(0), Real(1));
}

/// x N = whole + part, both exact: N is a power of two, and the part has a subset of the significand's bits.
template <typename Real>
struct Scaled {
  Word whole;
  Real part;
};

inline Word shifted(float x, Word level, Word bits) {
  const auto word = std::bit_cast<Word>(x);
  const Word exponent = word >> 23;
  const std::uint64_t significand = (word & 0x7fffff) | (exponent ? 0x800000 : 0);
  const Word by = (150 - level - std::max(exponent, Word{1})) & ((Word{1} << bits) - 1);
  return by < 64 ? static_cast<Word>(significand >> by) : 0;
}

template <bool rows, typename Real>
Scaled<Real> scaled(Word level, Real x) {
  Real xn = x * static_cast<Real>(side_of(level));
  if (!rows && has(rounded_16_16)) xn = std::round(xn * Real(0x1p16)) / Real(0x1p16);
  const auto whole = static_cast<Word>(xn);
  Scaled<Real> s{whole, xn - static_cast<Real>(whole)};
  if constexpr (std::is_same_v<Real, float>) {
    if (rows && has(rows_shift_in_6_bits)) s.whole = shifted(x, level, 6);
    if (!rows && has(shift_in_7_bits)) s.whole = shifted(x, level, 7);
  }
  return s;
}

/// a + b >= 1 for 0 <= a, b < 1.  From 1/2 on 1 - max is exact; below, the sum is less than 1 and 1 - max is 1/2
/// or more, rounded or not.
template <typename Real>
bool reach_one(Real a, Real b) {
  return std::min(a, b) >= 1 - std::max(a, b);
}

/// u + v > 1, by the same argument.
template <typename Real>
bool over_one(Real u, Real v) {
  return std::min(u, v) > 1 - std::max(u, v);
}

}  // namespace mmverify::tests::foreign::index
