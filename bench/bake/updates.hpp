// The time of bringing a map up to date where texels changed, beside baking it afresh.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/textures/alpha_textures.hpp"

namespace mmverify::bench {

/// Changes of squares of texels, level 8.
struct BakeUpdate {
  std::uint32_t texels = 0;     ///< the side of the changed square
  double baked_again = 0;       ///< a share of the micro-triangles
  double ns = 0, ns_whole = 0;  ///< a map, textures ready
};

/// Squares of 1, 8 and 64 texels, no larger than the textures, at places drawn with a seed; their texels are inverted.
/// Errors: std::runtime_error if an updated map is not the one that a whole bake gives.
std::vector<BakeUpdate> bake_updates(const std::vector<AlphaTexture>& textures, std::uint64_t seed,
                                     std::size_t rounds);

}  // namespace mmverify::bench
