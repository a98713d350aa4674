// The layout of a Tree's memory.  Internal to impl/tree.
#pragma once

#include <cstdint>
#include <cstring>

#include "impl/tree/bits.hpp"
#include "impl/tree/stream.hpp"

namespace mmverify::impl::tree::detail {

/// The header, unpacked.  Nodes, blocks and leaves follow it, each but the last in whole bytes.
struct Layout {
  std::uint32_t b;           ///< bits of a state
  std::uint32_t count_size;  ///< size of counts: 0, 1 or 2 for 8, 16 or 24 bits
  std::uint32_t top;         ///< 2k
  std::uint32_t below_top;   ///< 2(n-k)
  std::uint32_t in_block;    ///< 2(n-m)
  std::uint64_t parents;     ///< ones of depths k..m-1: each has four children among the nodes
  std::uint64_t blocks;      ///< ones of depth m

  // The greatest numbers are (4^11 - 1) / 3 parents and 4^11 blocks.
  static constexpr std::uint32_t parents_at = 15;    // check-magic: 15 == 1 + 2 + 4 + 4 + 4
  static constexpr std::uint32_t parents_bits = 21;  // check-magic: 21 == bit_length((4 ** 11 - 1) // 3)
  static constexpr std::uint32_t pack_blocks_at = parents_at + parents_bits;

  // The even numbers are stored halved, one place higher than they are read, so that reading doubles them.
  constexpr std::uint64_t packed() const noexcept {
    return (b - 1) | std::uint64_t{count_size} << 1 | std::uint64_t{top} << 2 |
           std::uint64_t{below_top} << 6 | std::uint64_t{in_block} << 10 | parents << parents_at |
           blocks << pack_blocks_at;
  }
  static constexpr Layout unpacked(std::uint64_t header) noexcept {
    const auto low = static_cast<std::uint32_t>(header);
    return {.b = (low & 1) + 1,
            .count_size = low >> 1 & 3,
            .top = low >> 2 & 30,
            .below_top = low >> 6 & 30,
            .in_block = low >> 10 & 30,
            .parents = header >> parents_at & ((1u << parents_bits) - 1),
            .blocks = header >> pack_blocks_at};
  }

  /// The layout of a form in memory.
  static Layout of(const std::uint8_t* memory) noexcept {
    std::uint64_t header;
    std::memcpy(&header, memory, sizeof header);
    return unpacked(header);
  }

  constexpr Level level() const noexcept { return (top + below_top) / 2; }
  constexpr std::uint32_t steps() const noexcept { return (below_top - in_block) / 2; }
  constexpr std::uint64_t first_children() const noexcept { return std::uint64_t{1} << top; }
  constexpr std::uint64_t nodes() const noexcept { return first_children() + 4 * parents; }
  constexpr std::uint64_t leaves() const noexcept { return nodes() - parents - blocks; }

  /// Nodes of a word; the count is above them.
  constexpr std::uint32_t per_word() const noexcept { return 56 - 8 * count_size; }
  /// The word of node p is p * reciprocal() >> reciprocal_shift: exact for p < 2^30, as the product is less
  /// than 48 p beyond 2^36 p / per_word().
  static constexpr std::uint32_t reciprocal_shift = 36;
  static constexpr std::uint64_t reciprocal_one = std::uint64_t{1} << reciprocal_shift;
  static constexpr std::uint64_t reciprocals[] = {(reciprocal_one + 55) / 56, (reciprocal_one + 47) / 48,
                                                  (reciprocal_one + 39) / 40, 0};
  constexpr std::uint64_t reciprocal() const noexcept { return reciprocals[count_size]; }
  constexpr std::uint64_t word_of(std::uint64_t p) const noexcept {
    return p * reciprocal() >> reciprocal_shift;
  }
  constexpr std::uint64_t words() const noexcept { return (nodes() + per_word() - 1) / per_word(); }

  // Places in bytes from the start of the memory.
  static constexpr std::uint64_t nodes_at = 8;
  constexpr std::uint64_t blocks_at() const noexcept { return nodes_at + 8 * words(); }
  /// The place of the leaves in bits from there.
  constexpr std::uint64_t leaves_at() const noexcept { return 8 * blocks_at() + (blocks << in_block) * b; }
  constexpr std::uint64_t size() const noexcept { return bytes_for(leaves_at() + leaves() * b); }
};

}  // namespace mmverify::impl::tree::detail
