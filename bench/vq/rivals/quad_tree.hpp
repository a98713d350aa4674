// A quad-tree of a square opacity map within a budget of bits, a region of which is read at random.
//
// Compressed Opacity Maps, 3, names "a 3-level quad-tree hierarchy" and says no more.  This reading: the map is
// cut into roots of 4x4 regions; a node whose regions are alike has their state, another is split; a split 2x2
// is a code of figure 4.  That makes three levels: 4x4, 2x2, regions.  One root for the whole map is the other
// end: any number of levels.
//
// Bits, level after level, nodes in the order of their parents, (x, y) at x + 2 y within one:
//   roots            2 each, row by row from the bottom: 0 T, 1 C, 2 O, 3 split
//   children         2 each, four of each split node
//   split 2x2        5 each: decode_mini of spec/vq/vq.hpp, bits 0..3 are C, bit 4 the palette
// No pointers: a level begins where the one above ends, and the children of a node come after those of the
// split nodes before it, which are counted.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/vq/rivals/bits.hpp"
#include "bench/vq/rivals/prune.hpp"

namespace mmverify::bench::rivals {

struct QuadTree {
  std::uint32_t root = 4;  ///< regions along a root's side
  Weights weights = {};

  static constexpr TreeCost cost{.root = 0, .node = 2, .inner = 0, .last = 5};

  /// The tree of the map, or the best pruning of it within the budget.  Nothing is lost if tree_bits(map,
  /// root, cost) <= budget and no 2x2 from an even place on has O beside T; else some O and T become C.
  /// Errors: std::invalid_argument, as pruned().
  Bits encode(States map, std::uint32_t budget) const;
  /// The map of side x side regions.  Domain: words from encode() for such a map.
  std::vector<State> decode(Words words, std::uint32_t side) const;
  /// One region of the map.  Domain: the same; x and y below side.
  State region(Words words, std::uint32_t side, std::uint32_t x, std::uint32_t y) const;
};

}  // namespace mmverify::bench::rivals
