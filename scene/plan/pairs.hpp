// Pairs of triangles that share an edge, each for one square opacity map.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/plan/plan.hpp"

namespace mmverify::scene {

/// A pair whose square map has its axes along the pair's barycentrics (impl/vq/vq.hpp, Half).  The lower
/// triangle's corners are (0,0), (1,0), (0,1), the upper's (1,1), (0,1), (1,0); the last two of each are on
/// the common edge.  Each is a planned triangle with its vertices in that order.
struct Pair {
  TriangleUse lower, upper;
  std::uint64_t unique = 0, placed = 0;  ///< pairs that this one stands for, itself included
};

/// A triangle's place in its pair: corner k of the lower or upper half is the triangle's vertex order[k].
struct PairPlace {
  std::uint32_t pair = 0;  ///< number in Pairs::distinct
  bool upper = false;
  VertexOrder order{0, 1, 2};
};

struct Pairs {
  std::vector<Pair> distinct;
  /// The place of each triangle, by Plan::primitives, then by triangle; none without a partner.
  std::vector<std::vector<std::optional<PairPlace>>> places;
  std::uint64_t unique = 0;    ///< pairs of all planned primitives
  std::uint64_t unpaired = 0;  ///< triangles in no pair
};

/// Pairs each primitive's triangles in its order.  A triangle's partner is the first later one that has no
/// partner yet and shares an edge, by the positions and the UVs of both ends.
/// The number of pairs is not the greatest possible.  A list of quads, on which maps usually come, is paired
/// as it lies.
/// Domain: a plan of this scene.  Time: linear, but for edges that many triangles share.
Pairs pairs(const Scene& scene, const Plan& plan);

}  // namespace mmverify::scene
