// The same tree over sdsl-lite, the peer: bit_vector with rank_support_v5, and an int_vector of states.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "impl/tree/stream.hpp"

namespace mmverify::bench {

/// A tree in level order.  Nodes of depths 0..n-1 have a bit each (nodes of depth n are leaves and need
/// none); the children of the r-th internal node (from 0) are nodes 4r+1..4r+4; the states of the leaves are
/// in level order.  A lookup stops at its leaf.
class SdslTree {
 public:
  /// Builds the tree of a map.  Domain: level 0..12 and a map of its size.
  SdslTree(impl::tree::Level n, impl::tree::Format b, std::span<const std::uint8_t> map);
  ~SdslTree();
  SdslTree(SdslTree&&) noexcept;
  SdslTree& operator=(SdslTree&&) noexcept;

  /// The state of a micro-triangle.  Domain: index < 4^n.
  std::uint8_t operator[](std::uint32_t index) const;

  /// state[k] = trees[which[k]][index[k]].
  static void lookup(std::span<const SdslTree> trees, std::span<const std::uint32_t> which,
                     std::span<const std::uint32_t> index, std::span<std::uint8_t> state);
  /// Looks up a chain: each index is XORed with the state before it.  Returns the last state.
  static std::uint8_t chain(std::span<const SdslTree> trees, std::span<const std::uint32_t> which,
                            std::span<const std::uint32_t> index);

  /// The size of the tree, as sdsl reports its own structures.
  std::uint64_t bits() const;
  /// The 64-byte lines of its three arrays that a lookup reads; each array is taken to begin on a line.
  std::size_t lines(std::uint32_t index) const;

  struct Sequences;

 private:
  std::unique_ptr<Sequences> parts_;
};

}  // namespace mmverify::bench
