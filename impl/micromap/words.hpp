// Packed states by the word: bits moved apart and together, and the loop over a packed map.  Internal to impl.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>

#include "impl/common/bits.hpp"

namespace mmverify::impl::micromap::detail {

static_assert(std::endian::native == std::endian::little, "packed bytes are loaded as little-endian words");

inline constexpr std::uint64_t even_bits = 0x5555555555555555;

/// A mask of the low `bits` bits.  Domain: bits in 0..64.
constexpr std::uint64_t low(std::uint64_t bits) {
  return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

using impl::detail::gathered, impl::detail::spread;

/// Moves bit i of 16 to bit 4i.
constexpr std::uint64_t bits_to_nibbles(std::uint64_t x) {
  x = (x | x << 24) & 0x000000ff000000ff;
  x = (x | x << 12) & 0x000f000f000f000f;
  x = (x | x << 6) & 0x0303030303030303;
  return (x | x << 3) & 0x1111111111111111;
}

/// Moves bit 4i to bit i of 16.  Domain: other bits are zero.
constexpr std::uint64_t nibbles_to_bits(std::uint64_t x) {
  x = (x | x >> 3) & 0x0303030303030303;
  x = (x | x >> 6) & 0x000f000f000f000f;
  x = (x | x >> 12) & 0x000000ff000000ff;
  return (x | x >> 24) & 0x000000000000ffff;
}

/// Moves the two bits at 2i, i below 8, to the low bits of byte i.
constexpr std::uint64_t pairs_to_bytes(std::uint64_t x) {
  x = (x | x << 24) & 0x000000ff000000ff;
  x = (x | x << 12) & 0x000f000f000f000f;
  return (x | x << 6) & 0x0303030303030303;
}

/// Moves the low two bits of byte i to bits 2i and 2i+1.  Domain: other bits are zero.
constexpr std::uint64_t bytes_to_pairs(std::uint64_t x) {
  x = (x | x >> 6) & 0x000f000f000f000f;
  x = (x | x >> 12) & 0x000000ff000000ff;
  return (x | x >> 24) & 0x000000000000ffff;
}

/// Moves bit i of 8 to the low bit of byte i: of eight copies, byte i keeps bit i; adding 127 carries it to the top of
/// its byte.
constexpr std::uint64_t bits_to_bytes(std::uint64_t x) {
  const std::uint64_t kept = x * 0x0101010101010101 & 0x8040201008040201;
  return (kept + 0x7f7f7f7f7f7f7f7f) >> 7 & 0x0101010101010101;
}

/// Moves the low bit of byte i to bit i.  Domain: other bits are zero, so that no two terms of the product meet.
constexpr std::uint64_t bytes_to_bits(std::uint64_t x) { return x * 0x0102040810204080 >> 56; }

/// Loads a word from at most 8 bytes.
inline std::uint64_t load(const std::uint8_t* from, std::size_t bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, from, bytes);
  return word;
}

/// Writes f(word), in `out_step` bytes, for each `in_step` bytes of a packed map of in_bits bits; out_bits in all.
/// Bits after the last are zero in the words that f gets and in the written ones.
/// Domain: in has ceil(in_bits / 8) bytes or more, out exactly ceil(out_bits / 8); in_bits / in_step == out_bits /
/// out_step.
template <std::size_t in_step, std::size_t out_step, class F>
void each_word(std::span<const std::uint8_t> in, std::uint64_t in_bits, std::span<std::uint8_t> out,
               std::uint64_t out_bits, F f) {
  const std::size_t whole = static_cast<std::size_t>(in_bits / (8 * in_step));
  const std::uint8_t* from = in.data();
  std::uint8_t* to = out.data();
  for (std::size_t k = 0; k < whole; ++k, from += in_step, to += out_step) {
    const std::uint64_t word = f(load(from, in_step));
    std::memcpy(to, &word, out_step);
  }
  const std::uint64_t in_left = in_bits - 8 * in_step * std::uint64_t{whole};
  if (in_left == 0) return;
  const std::uint64_t out_left = out_bits - 8 * out_step * std::uint64_t{whole};
  const std::uint64_t word =
      f(load(from, static_cast<std::size_t>((in_left + 7) / 8)) & low(in_left)) & low(out_left);
  std::memcpy(to, &word, static_cast<std::size_t>((out_left + 7) / 8));
}

/// Calls f(word, mask of its valid bits) for each 8 bytes of a packed map; bits after the last are zero.
template <class F>
void each_word(std::span<const std::uint8_t> in, std::uint64_t in_bits, F f) {
  std::uint64_t at = 0;
  for (; in_bits - at >= 64; at += 64) f(load(in.data() + at / 8, 8), ~std::uint64_t{0});
  if (in_bits != at) {
    const std::uint64_t mask = low(in_bits - at);
    f(load(in.data() + at / 8, static_cast<std::size_t>((in_bits - at + 7) / 8)) & mask, mask);
  }
}

inline void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

}  // namespace mmverify::impl::micromap::detail
