// The recursion of the two sequences: an internal node is written, read or passed with all below it.  Internal to
// impl/tree.
//
// Each function calls itself for the children that are internal, and handles leaves by itself.  Proofs at level 3 and up
// take these calls by contract, from level to level: see proofs/codecs/impl_tree.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "impl/tree/bits.hpp"
#include "impl/tree/decode.hpp"
#include "impl/tree/pyramid.hpp"

namespace mmverify::impl::tree::detail {

/// A map on its way into the two sequences.
struct SequenceWriter {
  const Pyramid& pyramid;
  std::span<const std::uint8_t> map;
  Level n;
  std::uint32_t b;  ///< bits of a state
  BitWriter tree, data;
};

/// Writes node k of depth d, which is internal, and all below it: Algorithm 2 on the pyramid.
void write_node(SequenceWriter& to, Level d, std::uint64_t k) noexcept;

/// The two sequences on their way into a map.
struct SequenceReader {
  Level n;
  std::uint32_t b;  ///< bits of a state
  BitReader tree, data;
  std::uint64_t nodes;  ///< in the sequence
  std::uint8_t* map;    ///< zeros at the states to come
  std::optional<Fault> fault;
};

/// Reads all below an internal node of depth d, whose own bit is passed, into the states from bit `bit` of the map on.
/// False: the reader has the fault.
bool read_node(SequenceReader& from, Level d, std::uint64_t bit) noexcept;

/// The next node and the next leaf.
struct Place {
  std::uint64_t node = 0, leaf = 0;
};

/// One step over the subtrees that are to come: over a leaf, or into an internal node.  False: the tree ends before.
inline bool pass_one(const std::uint8_t* tree, std::uint64_t nodes, Place& at,
                     std::uint64_t& to_come) noexcept {
  if (at.node >= nodes) return false;
  const bool internal = bit_at(tree, at.node++);
  at.leaf += internal ? 0 : 1;
  to_come += internal ? 3 : ~std::uint64_t{0};
  return true;
}

/// Passes so many subtrees of a tree with `nodes` bits.  False: the tree ends before that.
bool pass_subtrees(const std::uint8_t* tree, std::uint64_t nodes, std::uint64_t count, Place& at) noexcept;

/// Passes all before the leaf of a state, by its index in a subtree of so many levels: Algorithm 3.  False: the tree
/// ends before it, or goes below its last level.
bool find_leaf(const std::uint8_t* tree, std::uint64_t nodes, Level levels, std::uint64_t index,
               Place& at) noexcept;

}  // namespace mmverify::impl::tree::detail
