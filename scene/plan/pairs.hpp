// Pairs of triangles that share an edge: what square opacity maps are for.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/plan/plan.hpp"

namespace mmverify::scene {

/// A pair's square map has its axes along the pair's barycentrics (impl/vq/vq.hpp, Half): the lower triangle's
/// corners are (0,0), (1,0), (0,1), the upper's (1,1), (0,1), (1,0), the last two of either on the edge that
/// they share.  Each is a planned triangle with its vertices in that order.
struct Pair {
  TriangleUse lower, upper;
  std::uint64_t unique = 0, placed = 0;  ///< pairs that this one stands for, itself included
};

/// Where a triangle is in its pair: corner k of the lower, or the upper, is its vertex order[k].
struct PairPlace {
  std::uint32_t pair = 0;  ///< of Pairs::distinct
  bool upper = false;
  VertexOrder order{0, 1, 2};
};

struct Pairs {
  std::vector<Pair> distinct;
  /// By Plan::primitives, then by triangle; none of a triangle without a partner.
  std::vector<std::vector<std::optional<PairPlace>>> places;
  std::uint64_t unique = 0;    ///< pairs of all planned primitives
  std::uint64_t unpaired = 0;  ///< triangles in no pair
};

/// Each primitive's triangles, in its order, each with the first later one that shares an edge of it, by the
/// positions and the UVs of both ends, and has no partner yet.
/// Not the most pairs that there can be: a list of quads, which is what maps come on, is paired as it lies.
/// Domain: a plan of this scene.  Time: linear, but for edges that many triangles share.
Pairs pairs(const Scene& scene, const Plan& plan);

}  // namespace mmverify::scene
