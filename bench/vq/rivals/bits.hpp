// Fields one after another in words of 64 bits, from bit 0 of word 0 on.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace mmverify::bench::rivals {

using Words = std::span<const std::uint64_t>;

/// A sequence of fields that an encoder writes.
struct Bits {
  std::vector<std::uint64_t> words;
  std::uint32_t size = 0;  ///< bits written

  /// Appends a field.  Domain: bits in 1..32, value < 2^bits.
  void put(std::uint32_t value, std::uint32_t bits) {
    for (std::uint32_t k = 0; k < bits; ++k, ++size) {
      if (size % 64 == 0) words.push_back(0);
      words.back() |= std::uint64_t{value >> k & 1} << (size % 64);
    }
  }
};

/// The field of `bits` bits from bit `at` on.  Domain: bits in 1..32; it lies within the words.
inline std::uint32_t field(Words words, std::uint32_t at, std::uint32_t bits) {
  const std::uint32_t word = at / 64, from = at % 64;
  std::uint64_t value = words[word] >> from;
  if (from + bits > 64) value |= words[word + 1] << (64 - from);
  return static_cast<std::uint32_t>(value & ((std::uint64_t{1} << bits) - 1));
}

/// Word k, one of those that bits first..first + count - 1 touch, with all its other bits cleared.
inline std::uint64_t word_within(Words words, std::uint32_t k, std::uint32_t first, std::uint32_t count) {
  std::uint64_t word = words[k];
  if (k == first / 64) word &= ~std::uint64_t{0} << (first % 64);
  if (k == (first + count) / 64) word &= (std::uint64_t{1} << ((first + count) % 64)) - 1;
  return word;
}

/// The number of set bits among first..first + count - 1.
inline std::uint32_t ones(Words words, std::uint32_t first, std::uint32_t count) {
  std::uint32_t found = 0;
  for (std::uint32_t k = first / 64; 64 * k < first + count; ++k)
    found += static_cast<std::uint32_t>(std::popcount(word_within(words, k, first, count)));
  return found;
}

/// The number of fields equal to 3 among `count` fields of two bits from bit `first` on.  Domain: first is
/// even.
inline std::uint32_t threes(Words words, std::uint32_t first, std::uint32_t count) {
  std::uint32_t found = 0;
  for (std::uint32_t k = first / 64; 64 * k < first + 2 * count; ++k) {
    const std::uint64_t word = word_within(words, k, first, 2 * count);
    found += static_cast<std::uint32_t>(std::popcount(word & word >> 1 & 0x5555555555555555));
  }
  return found;
}

}  // namespace mmverify::bench::rivals
