// The eight transforms of table 1, for vectors of side x side regions.  Internal to impl/vq.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mmverify::impl::vq::detail {

/// The place to which a transform, a row of table 1, moves region k = x + side y: turned first, then exchanged.
template <std::uint32_t side>
constexpr std::uint32_t moved(std::uint32_t transform, std::uint32_t k) noexcept {
  std::uint32_t x = k % side, y = k / side;
  if ((transform & 1) != 0) {
    const std::uint32_t turned = side - 1 - y;
    y = x;
    x = turned;
  }
  if ((transform & 2) != 0) y = side - 1 - y;
  if ((transform & 4) != 0) x = side - 1 - x;
  return x + side * y;
}

/// Region k is filled from sources<side>[transform][k].
template <std::uint32_t side>
inline constexpr auto sources = [] {
  std::array<std::array<std::uint8_t, std::size_t{side} * side>, 8> table{};
  for (std::uint32_t t = 0; t < 8; ++t)
    for (std::uint32_t k = 0; k < side * side; ++k)
      table[t][moved<side>(t, k)] = static_cast<std::uint8_t>(k);
  return table;
}();

/// The state of a region by the index of its vector and two bits: 1 if it is C, 2 if the palette is {O, C}.  The first
/// three indices are states themselves.  It is a table because branches on the index would be mispredicted.
inline constexpr auto states_of = [] {
  std::array<std::array<std::uint8_t, 4>, 16> table{};
  for (std::uint8_t index = 0; index < 16; ++index)
    for (std::uint8_t bits = 0; bits < 4; ++bits)
      table[index][bits] = index < 3 ? index : (bits & 1) != 0 ? std::uint8_t{1} : bits;
  return table;
}();

}  // namespace mmverify::impl::vq::detail
