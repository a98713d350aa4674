// The pruning of a tree over a square map: if the bits do not suffice for all nodes, some nodes become C.
// Both hierarchies of Compressed Opacity Maps, 3, are such trees, and differ in the cost of a node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "impl/vq/vq.hpp"

namespace mmverify::bench::rivals {

using impl::vq::State;
using States = std::span<const State>;  ///< of a square map, region (x, y) at x + side y

/// The cost of a tree's nodes in bits.  A node is split if its regions differ, down to 2x2 regions.
struct TreeCost {
  std::uint32_t root;   ///< of each root, above its cost as a node
  std::uint32_t node;   ///< of each node
  std::uint32_t inner;  ///< of a split node of 4x4 or more, above the cost of its four children
  std::uint32_t last;   ///< of a split node of 2x2
};

/// The weight of the loss of one region, by its state.
struct Weights {
  std::uint32_t t = 1, o = 1;
  constexpr std::uint32_t of(State s) const { return s == State::T ? t : s == State::O ? o : 0; }
};

/// The number of regions along a side.  Errors: std::invalid_argument if it is no power of two from 2 to 64,
/// or if `root`, the regions along a root's side, is none from 2 to that.
std::uint32_t checked_side(States map, std::uint32_t root);

/// Whether all regions of the square from (x, y) on are equal.
bool uniform(States map, std::uint32_t side, std::uint32_t x, std::uint32_t y, std::uint32_t square);

/// The map without O beside T in any 2x2 of regions from an even (x, y) on: the state that weighs less
/// becomes C (T, if both weigh the same).  A map of continuous alpha stays as it is (COM 2).
std::vector<State> without_o_beside_t(States map, Weights weights = {});

/// The bits of the whole tree of a map.
std::uint32_t tree_bits(States map, std::uint32_t root, const TreeCost& cost);

/// The map with some squares of the tree made C, so that the tree costs at most `budget`:
///   minimal weighted number of O and T that become C, over all choices of squares
/// Exact: the least loss of each node for each number of bits, from the leaves up.
/// Errors: as checked_side, and std::invalid_argument if the budget has no room for the roots.
std::vector<State> pruned(States map, std::uint32_t root, const TreeCost& cost, std::uint32_t budget,
                          Weights weights = {});

}  // namespace mmverify::bench::rivals
