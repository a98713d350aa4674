// A share of the inputs, for what is too slow for each of them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mmverify::fuzz {

/// A number that all bytes of an input determine.  A fuzzer keeps the bytes that reach most, and so would spend its time on
/// the slowest of what a byte of the input chooses; but each change to any byte chooses anew here.
/// Source: FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv; its high bits depend on more bytes than its low ones.
inline std::uint32_t choice(const std::uint8_t* data, std::size_t size) {
  std::uint32_t sum = 0x811c9dc5;
  for (std::size_t k = 0; k < size; ++k) sum = (sum ^ data[k]) * 0x01000193;
  return sum ^ sum >> 16;
}

}  // namespace mmverify::fuzz
