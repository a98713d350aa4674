// The features that meshopt_opacityMapRasterize supports, for all of its callers.
//
// It compares with 1/2, and rounds coordinates to 1/256 of a texel.  It brings coordinates outside of [0, 1]
// inside without filtering across the border, which is none of Vulkan's addressing modes; inside it clamps.
// Scenes are baked with it all the same, so under ADAPTER_SCENE the adapter also supports repeated textures.
#pragma once

#include "examples/adapters/subject.hpp"

#ifdef ADAPTER_SCENE
inline constexpr bool bakes_scenes = true;
#else
inline constexpr bool bakes_scenes = false;
#endif

inline void rasterizer_supports(mmverify_bake_support_t& support) {
  support.texels = 1U << MMVERIFY_UNORM8;
  support.filters = 1U << MMVERIFY_BILINEAR;
  support.alpha_modes = 1U << MMVERIFY_MASK;
  support.max_mips = 1;
  support.restrictions = MMVERIFY_BAKE_NO_FACTORS | MMVERIFY_BAKE_NO_MARGIN;
  support.fixed_cutoff = 0.5F;
  support.unknown = MMVERIFY_UNKNOWN_BY_COVERAGE;
  if (!bakes_scenes) support.wraps = 1U << MMVERIFY_CLAMP_TO_EDGE, support.uv_max = 1;
  support.coordinate_bits = 8;
}
