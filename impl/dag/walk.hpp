// Lookups from nodes, many at once.  Internal to impl/dag.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mmverify::impl::dag::detail {

/// Lookups that begin at a node each, beside one another.
struct Walks {
  static constexpr std::size_t most = 256;
  std::size_t count = 0;
  alignas(64) std::uint32_t reference[most], level[most], index[most], state[most];
};

/// state[k] of each, for bits a state of 1 or 2.
/// Domain: count > 0; roots of a graph whose arrays these are, index < 4^level; tiles as words of 32 bits, fewer than 2^31, and
/// one of any value where there are none.
void walk(const std::uint32_t* nodes, const std::uint32_t* tiles, std::uint32_t bits, Walks& walks) noexcept;

}  // namespace mmverify::impl::dag::detail
