#include "impl/micromap/level.hpp"

#include "impl/micromap/words.hpp"

namespace mmverify::impl::micromap {
namespace {

using namespace detail;

// Merges four 4-state children a byte.  The parent's low bit is the majority under force-2-state: four O have it, four
// T do not, and for the others it is a choice.  Its high bit is set if any child is unknown or the low bits differ.
std::uint64_t merged_pairs(std::uint64_t x) {
  const std::uint64_t l = x & even_bits, h = x >> 1 & even_bits;
  std::uint64_t sum = (l & 0x3333333333333333) + (l >> 2 & 0x3333333333333333);
  sum = (sum + (sum >> 4)) & 0x0f0f0f0f0f0f0f0f;
  const std::uint64_t majority = (sum + 0x0606060606060606) >> 3 & 0x0101010101010101;
  std::uint64_t any = l | l >> 2, all = l & l >> 2, asked = h | h >> 2;
  any |= any >> 4;
  all &= all >> 4;
  asked |= asked >> 4;
  const std::uint64_t unknown = (asked | (any & ~all)) & 0x0101010101010101;
  return bytes_to_pairs(majority | unknown << 1);
}

// Merges four 2-state children a nibble: 1 if two or more are 1.
std::uint64_t merged_bits(std::uint64_t x) {
  std::uint64_t sum = (x & even_bits) + (x >> 1 & even_bits);
  sum = (sum & 0x3333333333333333) + (sum >> 2 & 0x3333333333333333);
  return nibbles_to_bits((sum + 0x6666666666666666) >> 3 & 0x1111111111111111);
}

void require_sizes(std::span<const std::uint8_t> in, std::uint64_t in_size, std::span<std::uint8_t> out,
                   std::uint64_t out_size) {
  require(in.size() >= in_size, "micromap: too few bytes");
  require(out.size() == out_size, "micromap: out has not packed_bytes bytes");
}

}  // namespace

void up(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count, std::span<std::uint8_t> out) {
  require_sizes(bytes, packed_bytes(count, f), out, packed_bytes(4 * count, f));
  if (f == Format::two_state)
    each_word<2, 8>(bytes, count, out, 4 * count, [](std::uint64_t x) { return bits_to_nibbles(x) * 0xf; });
  else
    each_word<2, 8>(bytes, 2 * count, out, 8 * count,
                    [](std::uint64_t x) { return pairs_to_bytes(x) * 0x55; });
}

void down(std::span<const std::uint8_t> bytes, Format f, std::uint64_t count, std::span<std::uint8_t> out) {
  require_sizes(bytes, packed_bytes(4 * count, f), out, packed_bytes(count, f));
  if (f == Format::two_state)
    each_word<8, 2>(bytes, 4 * count, out, count, merged_bits);
  else
    each_word<8, 2>(bytes, 8 * count, out, 2 * count, merged_pairs);
}

void to_mode(std::span<const std::uint8_t> four_state, std::uint64_t count, Mode mode,
             std::span<std::uint8_t> out) {
  require_sizes(four_state, packed_bytes(count, Format::four_state), out,
                packed_bytes(count, Format::two_state));
  each_word<8, 4>(four_state, 2 * count, out, count, [mode](std::uint64_t x) {
    if (mode == Mode::T_O) return gathered(x);
    if (mode == Mode::T_C) return gathered(x | x >> 1);
    return gathered(~x | x >> 1);
  });
}

void from_mode(std::span<const std::uint8_t> one_bit, std::uint64_t count, Mode mode,
               std::span<std::uint8_t> out) {
  require_sizes(one_bit, packed_bytes(count, Format::two_state), out,
                packed_bytes(count, Format::four_state));
  each_word<4, 8>(one_bit, count, out, 2 * count, [mode](std::uint64_t x) {
    const std::uint64_t wide = spread(x);
    if (mode == Mode::T_O) return wide;
    if (mode == Mode::T_C) return wide | wide << 1;
    return wide << 1 | (~wide & even_bits);
  });
}

Cost cost(const StateCounts& states) noexcept {
  return {2 * (states[0] + states[1] + states[2] + states[3]), states[2] + states[3]};
}

Cost cost(const StateCounts& states, Mode mode) noexcept {
  const std::uint64_t all = states[0] + states[1] + states[2] + states[3];
  if (mode == Mode::T_O) return {all, 0};
  return {all, all - states[mode == Mode::T_C ? 0 : 1]};
}

}  // namespace mmverify::impl::micromap
