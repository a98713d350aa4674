// A wavelet of a square opacity map over the integers modulo 3, within a budget of bits, a region of which is read
// at random.
//
// Compressed Opacity Maps, 3, names "a 'wavelet mod 3'" and says no more.  This reading: the states are T 0, C 1,
// O 2, and a level of the transform keeps one state of each 2x2 and the differences of the others to it, which
// modulo 3 are three values again, not five:
//   s' = s(0,0),   d(x,y) = s(x,y) - s(0,0) mod 3,   inverse: s(x,y) = s' + d(x,y) mod 3
// Differences are all zero just where the square is uniform, so a zero-tree ends there.  In a 2x2 of regions
// without O beside T they are all in {0, 1} or all in {0, 2}: one bit says which, and one each whether it is 0.
//
// Bits, level after level, nodes in the order of their parents, (x, y) at x + 2 y within one:
//   roots            2 each, row by row from the bottom: the state of the root's (0, 0)
//   flags            1 each: something below differs
//   differences      of each split node: 5 bits, d(1,0) + 3 d(0,1) + 9 d(1,1), of states half a node apart;
//                    of 2x2 regions 4 bits: bit k - 1 is set where d of k = x + 2 y is not 0, bit 3 where it is 2
//   flags            of the four children of each split node; and so on
// Not the average as the kept value: modulo 3 the average of T and C is O.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/vq/rivals/bits.hpp"
#include "bench/vq/rivals/prune.hpp"

namespace mmverify::bench::rivals {

struct Wavelet {
  std::uint32_t root = 4;  ///< regions along the square of one value of the coarsest level
  Weights weights = {};

  static constexpr TreeCost cost{.root = 2, .node = 1, .inner = 5, .last = 4};

  /// The wavelet of the map or, within the budget, of the map whose pruning loses least: differences are not
  /// dropped, since that turns T into O.  Nothing is lost if tree_bits(map, root, cost) <= budget and no 2x2
  /// from an even place on has O beside T; else some O and T become C.
  /// Errors: std::invalid_argument, as pruned().
  Bits encode(States map, std::uint32_t budget) const;
  /// The map of side x side regions.  Domain: words from encode() for such a map.
  std::vector<State> decode(Words words, std::uint32_t side) const;
  /// One region of the map.  Domain: the same; x and y below side.
  State region(Words words, std::uint32_t side, std::uint32_t x, std::uint32_t y) const;
};

}  // namespace mmverify::bench::rivals
