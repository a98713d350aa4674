// A graph as bytes that can be stored, sent and checked.
//
// 32 bytes, numbers little-endian, then what they announce and nothing more:
//   0   "mmdg"
//   4   version, 1
//   5   format: 1 two states, 2 four states
//   6   zero, 16 bits
//   8   maps, 32 bits
//   12  tiles, 32 bits
//   16  units of flat, 32 bits
//   20  words of nodes, 32 bits
//   24  zero, 32 bits
//   28  CRC-32C of bytes 0..28 and of all that follows byte 32
//   32  records, tiles, flat, nodes, as impl/dag/dag.hpp has them
// Bytes are a container only if adding its maps to an empty graph gives the same bytes.  So a sequence of maps has one
// container.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "impl/dag/dag.hpp"

namespace mmverify::impl::dag {

inline constexpr std::size_t container_header = 32;

/// The error for bytes that are no container: "byte 40, record 1: level 13; 0 to 12 would do".
class BadContainer : public std::runtime_error {
 public:
  BadContainer(std::size_t byte, const std::string& where, const std::string& found,
               const std::string& would_do);
  std::size_t byte() const noexcept { return byte_; }

 private:
  std::size_t byte_;
};

std::vector<std::uint8_t> save(const Dag& dag);

/// The graph of a container, to which maps can be added as to the saved one: save(load(bytes)) == bytes.
/// Domain: any bytes; throws BadContainer for bytes that save() cannot have written.  Time and memory are proportional
/// to the bytes unless somebody made hashes collide on purpose.  A flat map that has a second record is added again if
/// tiles or nodes came in between.
/// Law: dag.canonical, dag.malformed, dag.malformed_on_samples
Dag load(std::span<const std::uint8_t> bytes);

}  // namespace mmverify::impl::dag
