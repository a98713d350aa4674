// States, and bits of bytes, least significant first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmverify::tests::foreign::tree {

enum State : unsigned { T = 0, O = 1, UT = 2, UO = 3 };

inline constexpr std::uint8_t internal = 4;  // of a node that is no leaf; a leaf has its state

using Bytes = std::vector<std::uint8_t>;

inline std::size_t states_of(unsigned level) { return std::size_t{1} << (2 * level); }
inline std::size_t bytes_of(std::size_t bits) { return (bits + 7) / 8; }

inline unsigned bit_at(const std::uint8_t* bytes, std::size_t at) { return (bytes[at / 8] >> (at % 8)) & 1u; }

inline unsigned bits_at(const std::uint8_t* bytes, std::size_t at, unsigned bits) {
  unsigned value = 0;
  for (unsigned b = 0; b < bits; ++b) value |= bit_at(bytes, at + b) << b;
  return value;
}

inline void set_bits(std::uint8_t* bytes, std::size_t at, unsigned bits, unsigned value) {
  for (unsigned b = 0; b < bits; ++b)
    if ((value >> b & 1u) != 0)
      bytes[(at + b) / 8] = static_cast<std::uint8_t>(bytes[(at + b) / 8] | 1u << (at + b) % 8);
}

}  // namespace mmverify::tests::foreign::tree
