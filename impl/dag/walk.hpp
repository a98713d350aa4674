// Many lookups from nodes at once.  Internal to impl/dag.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mmverify::impl::dag::detail {

/// Lookups side by side, each of which begins at a node.
struct Walks {
  static constexpr std::size_t most = 256;
  std::size_t count = 0;
  alignas(64) std::uint32_t reference[most], level[most], index[most], state[most];
};

/// Writes state[k] of each lookup; `bits` a state is 1 or 2.
/// Domain: count > 0; references to roots of a graph with these arrays, index < 4^level; tiles as words of 32 bits,
/// fewer than 2^31; a graph without tiles passes one word of any value.
void walk(const std::uint32_t* nodes, const std::uint32_t* tiles, std::uint32_t bits, Walks& walks) noexcept;

}  // namespace mmverify::impl::dag::detail
