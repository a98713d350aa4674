// Common Subtree Merging of Chernaik, Modisett and Billeter (HPG 2026), the rival of impl/dag.  docs/DAG.md
//
// The layout.  Maps of all levels and of both formats are in one array of 32-bit words:
//   header    low half: a mask of the children that are not transparent; high half: the mean opacity, or zero
//   leaf      a subtree of level 4: a header, then for each child of the mask its 16 states, in 16 or 32 bits
//   interior  a subtree of level 6, 8, 10 or 12: a header, then for each child of the mask the place of its node
// A child is two levels below its node, so a node has 16.  A map of any other level is padded at the root: its root is a
// node of the next of these levels, and the map is its first children.  A node whose words are there already, in
// whatever map, is stored once.  Word 0 is the header of a transparent node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "impl/dag/table.hpp"

namespace mmverify::bench {

/// The maps of a scene in that layout.
class CommonSubtrees {
 public:
  using Level = std::uint32_t;
  static constexpr Level max_level = 12;

  explicit CommonSubtrees(bool with_means) : with_means_(with_means) {}

  /// Adds a map of b = 1 or 2 bits a state, and returns its number: 0, 1, ...
  /// Domain: n in 0..12 and ceil(4^n b / 8) bytes, else std::invalid_argument; padding bits may be anything.
  /// std::length_error if there would be 2^31 words.
  std::uint32_t add(Level n, std::uint32_t b, std::span<const std::uint8_t> map);

  std::uint32_t maps() const { return static_cast<std::uint32_t>(records_.size()); }
  /// The words of nodes, and 64 bits a map for its level, format and root.
  std::uint64_t bits() const { return 64 * records_.size() + 32 * words_.size(); }

  /// The state of a micro-triangle.  Domain: map < maps(); the low 2 n bits of the index count.
  std::uint8_t at(std::uint32_t map, std::uint64_t index) const;

  /// state[k] = at(map[k], index[k]), many side by side.
  /// Domain: spans of one length, map[k] < maps(), else std::invalid_argument.
  void lookup(std::span<const std::uint32_t> map, std::span<const std::uint32_t> index,
              std::span<std::uint8_t> state) const;

  /// The map again, padding bits zero.
  /// Domain: map < maps() and bytes of its level's size, else std::invalid_argument.
  void decode(std::uint32_t map, std::span<std::uint8_t> bytes) const;

  /// The share of opaque micro-triangles below micro-triangle `index` of the coarser level c, as
  /// round(65535 share): one read in the node that stands there.  T and UT count 0, O and UO count 1, as 2-state reads
  /// them.
  /// Domain: built with means; map < maps(); index < 4^c; c = 0, or n - c even and at least 4: there a node
  /// stands, else std::invalid_argument.
  std::uint16_t mean_opacity(std::uint32_t map, Level c, std::uint64_t index) const;

 private:
  struct Record {
    std::uint8_t level, bits;
    std::uint16_t reserved;
    std::uint32_t root;
  };
  static_assert(sizeof(Record) == 8);
  /// A subtree while its map is added: its node, and its opaque micro-triangles.
  struct Part {
    std::uint32_t node;
    std::uint64_t opaque;
  };

  Part leaf(std::uint32_t b, std::span<const std::uint32_t> states, std::uint64_t micro_triangles);
  Part interior(std::span<const Part> children, std::uint64_t micro_triangles);
  Part stored(std::uint32_t mask, std::uint64_t opaque, std::uint64_t micro_triangles,
              std::vector<std::uint32_t>& words);
  std::uint32_t child(std::uint32_t node, std::uint32_t number) const;
  void expand(std::uint32_t node, Level m, std::uint32_t b, std::uint64_t word,
              std::span<std::uint8_t> bytes) const;

  bool with_means_;
  std::vector<std::uint32_t> words_{0};
  std::vector<Record> records_;
  impl::dag::Table known_;
};

}  // namespace mmverify::bench
