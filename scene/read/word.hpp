// Words of bytes.
#pragma once

#include <cstdint>
#include <span>

namespace mmverify::scene {

/// The 32 bits at a byte, little-endian.  Precondition: at + 4 bytes are there.
inline std::uint32_t word_at(std::span<const unsigned char> bytes, std::size_t at) {
  return bytes[at] | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
         std::uint32_t{bytes[at + 3]} << 24;
}

}  // namespace mmverify::scene
