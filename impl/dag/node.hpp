// The layout of a node.  Internal to impl/dag.
#pragma once

#include <bit>
#include <cstdint>

#include "impl/dag/dag.hpp"

namespace mmverify::impl::dag::detail {

inline constexpr Level tile_level = 3;

/// A node has 16 children two levels below, or 4 one level below, so that all levels of nodes but the top are odd.
constexpr Level child_level(Level m) noexcept { return m % 2 == 0 ? m - 1 : m - 2; }
constexpr std::uint32_t children(Level m) noexcept { return m % 2 == 0 ? 4 : 16; }

/// The number of subtrees of level `below` in one of level m.
constexpr std::uint64_t subtrees(Level m, Level below) noexcept {
  return std::uint64_t{1} << (2 * (m - below));
}

/// A subtree while a map is added: the number of a tile, a reference to a node, or one_state + state.
inline constexpr std::uint32_t one_state = 0xFFFF'FFFC;
constexpr bool mixed(std::uint32_t part) noexcept { return part < one_state; }

/// The limits of words: no place of a node and no number of a tile comes near one_state.
inline constexpr std::uint64_t most_words = std::uint64_t{1} << 31, most_nodes_end = most_words - 64;
inline constexpr std::uint32_t narrow_tiles = 1 << 16;

/// The number of words of a node.  Domain: references = ones of the mask.
constexpr std::uint32_t node_words(std::uint32_t b, std::uint32_t references, bool wide) noexcept {
  return wide ? b + references : (1 + b + references + 1) / 2;
}

/// The mask in the low half of a header's first word; the planes are in the halfwords after it.
constexpr std::uint32_t mask_of(std::uint32_t first) noexcept { return first & 0xFFFF; }
constexpr std::uint32_t ones(std::uint32_t mask) noexcept {
  return static_cast<std::uint32_t>(std::popcount(mask));
}

/// Halfword k of the words.
constexpr std::uint32_t half(const std::uint32_t* words, std::uint32_t k) noexcept {
  return words[k / 2] >> (16 * (k % 2)) & 0xFFFF;
}

/// The state of a child that is not mixed.
constexpr std::uint32_t state_of(const std::uint32_t* node, std::uint32_t b, std::uint32_t child) noexcept {
  const std::uint32_t low = node[0] >> (16 + child) & 1;
  return b == 1 ? low : low | (node[1] >> child & 1) << 1;
}

/// A word full of one state of b bits.
constexpr std::uint64_t repeated(std::uint64_t state, std::uint32_t b) noexcept {
  return state * (b == 1 ? ~std::uint64_t{0} : 0x5555'5555'5555'5555);
}

/// The number of bytes of a map.
constexpr std::uint64_t map_bytes(Level n, std::uint32_t b) noexcept { return ((b << (2 * n)) + 7) / 8; }

}  // namespace mmverify::impl::dag::detail
