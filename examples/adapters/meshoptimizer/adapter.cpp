// meshoptimizer's opacity maps as a subject: meshopt_opacityMapRasterize is judged as a baker.
#include <meshoptimizer.h>

#include "examples/adapters/meshoptimizer/support.hpp"

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  const int level = static_cast<int>(c->level), states = c->format == MMVERIFY_2_STATE ? 2 : 4;
  meshopt_opacityMapRasterize(map, level, states, c->uv, c->uv + 2, c->uv + 4,
                              static_cast<const unsigned char*>(c->texels), 1, c->width, c->width, c->height);
  return 1;
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return baker_subject("meshoptimizer", bake, rasterizer_supports);
}
