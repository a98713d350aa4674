// A map as bytes that can be stored, sent and checked.
//
// 16 bytes, numbers little-endian, then what they announce and nothing more:
//   0   "mmtr"
//   4   version, 1
//   5   level, 0..12
//   6   format: 1 two states, 2 four states
//   7   kind: 0 flat, 1 tree
//   8   internal nodes i of the tree, 32 bits; 0 if flat
//   12  CRC-32C of bytes 0..12 and of all that follows byte 16
//   16  flat: the map.  Tree: the two sequences of impl/tree/stream.hpp, 4i+1 nodes in whole bytes, then 3i+1
//       states in whole bytes
// The kind is tree if that takes fewer bytes than the map, else flat; padding bits are zero.  So a map has one
// container, and it is at most 16 bytes longer than the map.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "impl/tree/stream.hpp"

namespace mmverify::impl::tree {

/// The error for bytes that are no container: "byte 5: level 13; 0 to 12 would do".
class BadContainer : public std::runtime_error {
 public:
  BadContainer(std::size_t byte, const std::string& found, const std::string& would_do);
  std::size_t byte() const noexcept { return byte_; }

 private:
  std::size_t byte_;
};

inline constexpr std::size_t container_header = 16;

/// The container of a map.  Domain: n in 0..12 and a map of its size, or std::invalid_argument is thrown.
/// Law: tree.round_trip, tree.sizes
std::vector<std::uint8_t> write(Level n, Format b, std::span<const std::uint8_t> map);

/// The contents of a container: a packed map.
struct Contents {
  Level level;
  Format format;
  std::vector<std::uint8_t> map;
};

/// The map of a container; write(level, format, map) gives back the very bytes.
/// Domain: any bytes; throws BadContainer for bytes that write() cannot have written.  Memory: the input and the map of
/// its level, 4 MiB at most.  The map is allocated only if all announced bytes are there.
/// Law: tree.round_trip, tree.canonical, tree.malformed
Contents read(std::span<const std::uint8_t> bytes);

/// Like read(), but returns nothing where read() throws BadContainer: faster if many inputs are bad.
/// Law: tree.canonical, tree.malformed
std::optional<Contents> try_read(std::span<const std::uint8_t> bytes);

}  // namespace mmverify::impl::tree
