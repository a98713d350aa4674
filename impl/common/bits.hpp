// Bits of a word moved apart and together.  Internal to impl.
#pragma once

#include <cstdint>

namespace mmverify::impl::detail {

/// Moves bit i of the low half to bit 2i.  Domain: the high half is zero; bits, of the word, 32 or 64.  With 32, a word
/// of 64 is two words that are moved at once.
/// Word may be any type with shifts and `&`, `|`, a prover's too.
template <int bits = 64, class Word>
constexpr Word spread(Word x) noexcept {
  static_assert(bits == 32 || bits == 64);
  if constexpr (bits == 64) x = (x | x << 16) & Word(0x0000ffff0000ffff);
  x = (x | x << 8) & Word(0x00ff00ff00ff00ff);
  x = (x | x << 4) & Word(0x0f0f0f0f0f0f0f0f);
  x = (x | x << 2) & Word(0x3333333333333333);
  return (x | x << 1) & Word(0x5555555555555555);
}

/// Moves bit 2i to bit i of the low half; odd bits are ignored.
template <int bits = 64, class Word>
constexpr Word gathered(Word x) noexcept {
  static_assert(bits == 32 || bits == 64);
  x = x & Word(0x5555555555555555);
  x = (x | x >> 1) & Word(0x3333333333333333);
  x = (x | x >> 2) & Word(0x0f0f0f0f0f0f0f0f);
  x = (x | x >> 4) & Word(0x00ff00ff00ff00ff);
  x = (x | x >> 8) & Word(0x0000ffff0000ffff);
  if constexpr (bits == 64) x = (x | x >> 16) & Word(0x00000000ffffffff);
  return x;
}

}  // namespace mmverify::impl::detail
