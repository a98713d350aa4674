// The tree for random access: the map's tree in level order with rank, cut at both ends.
//
// The form.  Two numbers are chosen for each map: a top depth k and a block depth m, k <= m <= n.
//   nodes   one bit each, 1 internal, 0 leaf: all 4^k nodes of depth k in order (nodes below a shallower leaf are
//           leaves), then the four children of each internal node of depths k..m-1, in level order.  A word of 64
//           bits has 56, 48 or 40 nodes, and above them the number of ones in all words before: one load brings both
//   blocks  the 4^(n-m) states below each internal node of depth m, in the map's order
//   leaves  the state of each 0 in nodes
// The children of the r-th one in nodes (from 0) start at 4^k + 4r; a 0 at p is leaf number p - (ones before p).  So a
// step down is a load, a shift and a population count, and a lookup takes m-k steps.  The form of a map is one block of
// memory; its size leaves out the handle to it, as the sizes of other forms do.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "impl/tree/stream.hpp"

namespace mmverify::impl::tree {

/// A map in a form that finds a state in one to four steps, in about the size of the paper's sequences.
class Tree {
 public:
  /// The form of a map.  A form fits if it takes at most 18/17 of the paper's stream (the bits of its two sequences)
  /// and the header.  Of the forms that fit, those with the fewest steps count; of these the shallowest is chosen that
  /// takes at most 1/32 more than the smallest.  If none fits, the smallest of all is.  Equal maps give equal forms.
  /// Domain: n in 0..12 and a map of its size, or std::invalid_argument is thrown.
  /// Law: tree.round_trip, tree.on_samples
  static Tree encode(Level n, Format b, std::span<const std::uint8_t> map);

  /// The depths k, where a form's nodes begin, and m, where its blocks do.
  struct Depths {
    Level top, block;
  };

  /// The form with these depths, whatever memory it takes, for tests of each of them.
  /// Domain: as above, and top <= block < max(n, 1), or std::invalid_argument is thrown.
  /// Law: tree.round_trip, tree.on_samples
  static Tree encode(Level n, Format b, std::span<const std::uint8_t> map, Depths depths);

  /// The state of a micro-triangle.  Domain: index < 4^level; its low 2 level bits count.
  /// Law: tree.lookup_is_decode, tree.on_samples
  std::uint8_t operator[](std::uint64_t index) const noexcept;

  /// state[k] = (*this)[index[k]].  Domain: spans of one length, or std::invalid_argument is thrown and
  /// nothing is written; no overlap.
  /// Law: tree.lookup_is_decode, tree.on_samples
  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const;

  /// The state at barycentrics (u, v): (*this)[index::from_barycentrics(u, v, level())].
  /// Domain: every bit pattern, as there.
  /// Law: tree.point_is_index, tree.point_exact_on_floats
  std::uint8_t at(float u, float v) const noexcept;

  /// Writes the map, padding bits zero.  Domain: a map of the level's size, or std::invalid_argument is thrown.
  /// Law: tree.round_trip, tree.on_samples
  void decode(std::span<std::uint8_t> map) const;

  /// The size of the form in bits, header and counts included, without this handle, a pointer.
  std::uint64_t bits() const noexcept;
  Level level() const noexcept;
  Format format() const noexcept;

  /// The bytes that lookups read, from the header on, for models of the cache.
  const std::uint8_t* memory() const noexcept { return memory_.get(); }

 private:
  explicit Tree(std::unique_ptr<std::uint8_t[]> memory) noexcept : memory_(std::move(memory)) {}

  std::unique_ptr<std::uint8_t[]> memory_;  // a header of 64 bits, nodes with counts, blocks, leaves
};

/// Looks up states in many trees, in any order: state[k] = (*trees[which[k]])[index[k]].
/// Domain: which, index and state of one length, and which[k] < trees.size(), or std::invalid_argument is
/// thrown and nothing is written; index[k] < 4^level of its tree (its low bits count); no overlap.
/// Law: tree.lookup_is_decode
void lookup(std::span<const Tree* const> trees, std::span<const std::uint32_t> which,
            std::span<const std::uint32_t> index, std::span<std::uint8_t> state);

}  // namespace mmverify::impl::tree
