// The bytes of the encoded square maps of a scene's pairs.
#pragma once

#include <cstdint>
#include <functional>

#include "scene/bake/square_maps.hpp"

namespace mmverify::scene {

/// The footprint as shipped: a map of one state takes no block.
struct VqFootprint {
  std::uint64_t maps = 0, uniform = 0;                        ///< distinct pairs; maps of one state
  std::uint64_t bytes = 0;                                    ///< of the other maps' blocks
  std::uint64_t regions = 0, unknown = 0, substitutions = 0;  ///< C before encoding; and O or T that became C
};

/// VQ2 by its optimal encoder, VQ4 by the balanced one.  `stop` is called before each map and may throw.
/// Source: Compressed Opacity Maps, sections 4 and 5.
VqFootprint vq2_footprint(const SquareMaps& maps, const std::function<void()>& stop = {});
VqFootprint vq4_footprint(const SquareMaps& maps, const std::function<void()>& stop = {});

}  // namespace mmverify::scene
