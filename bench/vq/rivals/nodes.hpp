// The nodes of one level of a tree over a square map, in the order in which both hierarchies write them.
#pragma once

#include <cstdint>
#include <vector>

#include "impl/vq/vq.hpp"

namespace mmverify::bench::rivals {

/// The region of a node with the least x and y.
struct Corner {
  std::uint32_t x, y;
};
using Corners = std::vector<Corner>;

/// The roots row by row from the bottom, `root` regions apart.
inline Corners roots_of(std::uint32_t side, std::uint32_t root) {
  Corners roots;
  for (std::uint32_t y = 0; y < side; y += root)
    for (std::uint32_t x = 0; x < side; x += root) roots.push_back({x, y});
  return roots;
}

/// Four children of each node, (x, y) at x + 2 y.  `square`: regions along a node's side.
inline Corners children_of(const Corners& nodes, std::uint32_t square) {
  Corners children;
  children.reserve(4 * nodes.size());
  for (const Corner& n : nodes)
    for (std::uint32_t k = 0; k < 4; ++k)
      children.push_back({n.x + k % 2 * (square / 2), n.y + k / 2 * (square / 2)});
  return children;
}

/// Gives all regions of a node one state.
inline void fill(std::vector<impl::vq::State>& map, std::uint32_t side, const Corner& n, std::uint32_t square,
                 impl::vq::State s) {
  for (std::uint32_t y = n.y; y < n.y + square; ++y)
    for (std::uint32_t x = n.x; x < n.x + square; ++x) map[x + side * y] = s;
}

}  // namespace mmverify::bench::rivals
