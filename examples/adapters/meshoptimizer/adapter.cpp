// meshoptimizer's opacity maps as a subject: meshopt_opacityMapRasterize is asked as a baker.
//
// It compares with 1/2, and rounds coordinates to 1/256 of a texel.  Coordinates outside of [0, 1] it takes into it
// without filtering across the border, which is none of Vulkan's addressing modes: inside it clamps.  Scenes are baked
// with it all the same, so ADAPTER_SCENE has it asked for repeated textures, too.
#include <meshoptimizer.h>

#include "examples/adapters/subject.hpp"

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  const int level = static_cast<int>(c->level), states = c->format == MMVERIFY_2_STATE ? 2 : 4;
  meshopt_opacityMapRasterize(map, level, states, c->uv, c->uv + 2, c->uv + 4,
                              static_cast<const unsigned char*>(c->texels), 1, c->width, c->width, c->height);
  return 1;
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return baker_subject("meshoptimizer", bake, [](mmverify_bake_support_t& support) {
    support.texels = 1U << MMVERIFY_UNORM8;
    support.filters = 1U << MMVERIFY_BILINEAR;
    support.alpha_modes = 1U << MMVERIFY_MASK;
    support.max_mips = 1;
    support.restrictions = MMVERIFY_BAKE_NO_FACTORS | MMVERIFY_BAKE_NO_MARGIN;
    support.fixed_cutoff = 0.5F;
    support.unknown = MMVERIFY_UNKNOWN_BY_COVERAGE;
#ifndef ADAPTER_SCENE
    support.wraps = 1U << MMVERIFY_CLAMP_TO_EDGE;
    support.uv_max = 1;
#endif
    support.coordinate_bits = 8;
  });
}
