// Places for data that may lie anywhere: each address modulo 16, and 32 behind a processor's line, the
// strictest alignment that a vector's load wants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mmverify::dock {

/// Bytes of a processor's cache line; no vector is longer.
constexpr std::size_t line = 64;
constexpr std::size_t places = 18;

/// The offset from a line's start for place `turn`, a multiple of number_bytes. Place 0 is the line's start.
constexpr std::size_t place_behind_line(std::size_t turn, std::size_t number_bytes) {
  constexpr std::size_t all[places] = {0, 8, 1, 16, 2, 32, 3, 9, 4, 10, 5, 11, 6, 12, 7, 13, 14, 15};
  const std::size_t at = all[turn % places];
  return at - at % number_bytes;
}

/// Bytes of `room` before its first whole line.
inline std::size_t before_line(const std::vector<std::byte>& room) {
  return (line - reinterpret_cast<std::uintptr_t>(room.data()) % line) % line;
}

}  // namespace mmverify::dock
