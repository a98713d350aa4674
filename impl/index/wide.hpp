// The curve's index beyond level 16, in 64-bit words: the same formula with a wider prefix XOR and
// interleave.
#pragma once

#include <cstdint>

#include "impl/common/bits.hpp"
#include "impl/index/index.hpp"

namespace mmverify::impl::index {

/// The last level whose N fits signed 32-bit numbers, to which processors convert floats: N = 2^30.
inline constexpr Level max_wide_level = 30;

namespace detail {

/// XOR of a 32-bit word's bits at and above each bit, in a word of 64.
template <class Word>
constexpr Word wide_xor_from_above(Word x) noexcept {
  x = x ^ x >> 1;
  x = x ^ x >> 2;
  x = x ^ x >> 4;
  x = x ^ x >> 8;
  return x ^ x >> 16;
}

/// The curve's index of a square, as detail::curve, in words of 64 bits.
template <class Word>
constexpr Word wide_curve(const Square<Word>& q) noexcept {
  const Word b0 = q.iu ^ q.row;
  const Word t = (q.iu ^ q.iv) & b0;
  const Word b1 = ((wide_xor_from_above(t) ^ q.iu) & ~b0) | t;
  return impl::detail::spread(b0) | impl::detail::spread(b1) << 1;
}

}  // namespace detail

/// The index on the curve of the micro-triangle that contains (u, v), at levels whose indices exceed 32 bits.
/// Domain: every bit pattern.  u and v are clamped to [0,1] one by one; NaN counts as 0.  level in 0..30, more is 30.
/// Result in [0, 4^level): exactly the rational evaluation of the formula, in unbounded words, for every pair of finite
/// floats; at levels 0..16 that of from_barycentrics.  The whole parts and the carry are exact for the reasons given at
/// detail::cut and detail::reach_one.
/// Source: VK_EXT_opacity_micromap, appendix "Reference Code"; the words' width is ours.
/// Law: index.wide_equals_reference, index.impl_wide_is_wide, index.wide_exact_on_floats
constexpr std::uint64_t from_barycentrics_wide(float u, float v, Level level) noexcept {
  const Level n = std::min(level, max_wide_level);
  const detail::GridPoint p = detail::find(u, v, n);
  return detail::wide_curve(
      detail::square(std::uint64_t{p.iu}, std::uint64_t{p.iv}, p.carry, std::uint64_t{1} << n));
}

}  // namespace mmverify::impl::index
