// VQ2 and VQ4 of a scene's pairs: their bytes beside those of the maps that they stand for, and a lookup.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/plan/pairs.hpp"

namespace mmverify::bench {

/// Of VQ2, at level 4, or of VQ4, at level 5.
struct SquareFigures {
  std::string form;  ///< "vq2", "vq4"
  std::uint32_t level = 0;
  std::uint64_t maps = 0, uniform = 0;  ///< distinct pairs; those whose square has one state, and no block
  std::uint64_t bytes = 0;              ///< of the others' blocks, with 8 a map for where it is
  std::uint64_t flat_bytes = 0;         ///< of the same pairs' 4-state maps, two a pair, with 8 for each
  std::uint64_t regions = 0;            ///< of the maps that have a block
  std::uint64_t substitutions = 0;      ///< of these, O or T that became unknown: what is lost
  double ns = 0;                        ///< a lookup, of independent random ones over all blocks
  double build_rate = 0;                ///< millions of regions a second
};

/// VQ2 by its optimal encoder, VQ4 by the balanced one; one thread.  Those of levels first..last that have a pair of more
/// than one state.  `stop` is asked before each map and may throw.
/// Domain: a plan of this scene.  Errors: as of scene::square_maps().
std::vector<SquareFigures> square_figures(const scene::Scene& scene, const scene::Plan& plan,
                                          std::uint32_t first, std::uint32_t last, std::uint64_t lookups,
                                          std::uint64_t seed, const std::function<void()>& stop = {});

}  // namespace mmverify::bench
