// The place of a micro-triangle once the vertices of its triangle are named in another order.
#pragma once

#include "proofs/engine/result.hpp"
#include "scene/plan/uv_duplicates.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::scene {

/// The index at level n, in the order of the planned triangle, of micro-triangle `index` of a use whose vertex k is
/// the planned one's vertex order[k].  Goes through the specification's corners.
/// Domain: index < 4^n; n in 0..16.
inline std::uint32_t in_planned_order(std::uint32_t index, Level n,
                                      const mmverify::scene::VertexOrder& order) {
  // The centroid's barycentrics, in thirds of 1/N.
  std::array<std::uint32_t, 3> mine{};
  for (const auto& corner : spec::index::corners(index, n)) {
    mine[1] += corner.i;
    mine[2] += corner.j;
  }
  mine[0] = 3 * spec::side(n) - mine[1] - mine[2];
  std::array<std::uint32_t, 3> planned{};
  for (std::size_t k = 0; k < 3; ++k) planned[order[k]] = mine[k];
  // The whole parts name the square, since a centroid lies strictly inside; it is in the upper half if both thirds
  // are 2.
  return spec::index::curve(spec::index::grid_square<std::uint32_t>(planned[1] / 3, planned[2] / 3,
                                                                    planned[1] % 3 == 2, spec::side(n)),
                            spec::side(n) - 1);
}

}  // namespace mmverify::proofs::scene
