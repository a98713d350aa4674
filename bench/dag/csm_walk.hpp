// Many lookups in nodes of Common Subtree Merging at once, as impl/dag/walk.hpp does it for our graph.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mmverify::bench {

/// Lookups side by side, each of which begins at a root.
struct CsmWalks {
  static constexpr std::size_t most = 256;
  std::size_t count = 0;
  alignas(64) std::uint32_t node[most], level[most], bits[most], index[most], state[most];
};

/// Writes state[k] of each lookup.
/// Domain: count > 0; roots of level 4, 6, ..., 12 in fewer than 2^31 words; index < 4^level; bits 1 or 2.
void csm_walk(const std::uint32_t* words, CsmWalks& walks) noexcept;

}  // namespace mmverify::bench
