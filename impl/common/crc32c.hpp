// CRC-32C (Castagnoli) of bytes: reflected polynomial 0x82f63b78, all ones before and inverted after.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace mmverify::impl {

namespace detail {

constexpr std::array<std::uint32_t, 256> crc32c_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0x82f63b78u : 0u);
    table[byte] = crc;
  }
  return table;
}();

}  // namespace detail

/// The checksum of bytes that follow others, whose checksum is `before`.
constexpr std::uint32_t crc32c(std::span<const std::uint8_t> bytes, std::uint32_t before = 0) noexcept {
  std::uint32_t crc = ~before;
  for (const std::uint8_t byte : bytes) crc = crc >> 8 ^ detail::crc32c_table[(crc ^ byte) & 255];
  return ~crc;
}

}  // namespace mmverify::impl
