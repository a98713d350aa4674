// The bytes of VQ2 and VQ4 of a scene's pairs, beside those of the maps that they replace, and the time of a
// lookup.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/plan/pairs.hpp"

namespace mmverify::bench {

/// The figures of VQ2, at level 4, or of VQ4, at level 5.
struct SquareFigures {
  std::string form;  ///< "vq2", "vq4"
  std::uint32_t level = 0;
  std::uint64_t maps = 0, uniform = 0;  ///< distinct pairs; those whose square has one state, and no block
  std::uint64_t bytes = 0;              ///< of the other pairs' blocks, with 8 bytes a map for its place
  std::uint64_t flat_bytes = 0;     ///< of the same pairs' 4-state maps, two a pair, with 8 bytes for each
  std::uint64_t regions = 0;        ///< of the maps that have a block
  std::uint64_t substitutions = 0;  ///< O or T among these that became unknown
  double ns = 0;                    ///< a lookup, over independent random ones on all blocks
  double build_rate = 0;            ///< millions of regions a second
};

/// The figures of VQ2 by its optimal encoder and of VQ4 by the balanced one, on one thread, if their levels
/// are in first..last and a pair has more than one state.  `stop` is called before each map and may throw.
/// Domain: a plan of this scene.  Errors: as of scene::square_maps().
std::vector<SquareFigures> square_figures(const scene::Scene& scene, const scene::Plan& plan,
                                          std::uint32_t first, std::uint32_t last, std::uint64_t lookups,
                                          std::uint64_t seed, const std::function<void()>& stop = {});

}  // namespace mmverify::bench
