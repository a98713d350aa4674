// Where the parts of a Tree lie in its memory.  Internal to impl/tree*.
#pragma once

#include <cstdint>

#include "impl/tree_stream.hpp"

namespace mmverify::impl::tree::detail {

/// The header, unpacked.  Nodes, counts, blocks and leaves follow it without gaps but whole words of nodes.
struct Layout {
  std::uint32_t b;          ///< bits a state
  bool wide;                ///< counts of 32 bits
  std::uint32_t top;        ///< 2k
  std::uint32_t below_top;  ///< 2(n-k)
  std::uint32_t in_block;   ///< 2(n-m)
  std::uint64_t nodes;      ///< bits, at most (4^12 - 1) / 3 + 1
  std::uint64_t blocks;     ///< internal nodes of depth m

  static constexpr std::uint32_t nodes_bits = 23, blocks_bits = 23;

  constexpr std::uint64_t packed() const noexcept {
    return (b - 1) | std::uint64_t{wide} << 1 | std::uint64_t{top} << 2 | std::uint64_t{below_top} << 7 |
           std::uint64_t{in_block} << 12 | nodes << 17 | blocks << (17 + nodes_bits);
  }
  static constexpr Layout unpacked(std::uint64_t header) noexcept {
    return {.b = static_cast<std::uint32_t>(header & 1) + 1,
            .wide = (header >> 1 & 1) != 0,
            .top = static_cast<std::uint32_t>(header >> 2) & 31,
            .below_top = static_cast<std::uint32_t>(header >> 7) & 31,
            .in_block = static_cast<std::uint32_t>(header >> 12) & 31,
            .nodes = header >> 17 & ((1u << nodes_bits) - 1),
            .blocks = header >> (17 + nodes_bits)};
  }

  constexpr Level level() const noexcept { return (top + below_top) / 2; }
  constexpr std::uint32_t steps() const noexcept { return (below_top - in_block) / 2; }
  constexpr std::uint64_t first_children() const noexcept { return std::uint64_t{1} << top; }
  /// Ones of depths k..m-1: each has four children among the nodes.
  constexpr std::uint64_t parents() const noexcept { return (nodes - first_children()) / 4; }
  constexpr std::uint64_t leaves() const noexcept { return nodes - parents() - blocks; }
  constexpr std::uint64_t words() const noexcept { return (nodes + 63) / 64; }

  // Bits from the start of the memory.
  static constexpr std::uint64_t nodes_at = 64;
  constexpr std::uint64_t counts_at() const noexcept { return nodes_at + 64 * words(); }
  constexpr std::uint64_t blocks_at() const noexcept { return counts_at() + (wide ? 32 : 16) * words(); }
  constexpr std::uint64_t leaves_at() const noexcept { return blocks_at() + (blocks << in_block) * b; }
  constexpr std::uint64_t end() const noexcept { return leaves_at() + leaves() * b; }
};

}  // namespace mmverify::impl::tree::detail
