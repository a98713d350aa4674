// The curve of NVIDIA's Opacity Micro-Map SDK as a subject: bird.h, index to micro-triangle and barycentrics to index.
#include <omm.h>

#include "defines.h"
#include "examples/adapters/subject.hpp"
#include "util/bird.h"

static void index(uint32_t level, const float* u, const float* v, uint32_t* out, size_t count) {
  bool upright = false;
  for (size_t k = 0; k < count; ++k) out[k] = omm::bird::bary2index({u[k], v[k]}, level, upright);
}

static void corners(uint32_t level, const uint32_t* index, uint32_t* out, size_t count) {
  const float steps = static_cast<float>(1U << level);
  for (size_t k = 0; k < count; ++k, out += 6) {
    float2 at[3];
    omm::bird::index2bary(index[k], level, at[0], at[1], at[2]);
    for (int c = 0; c < 3; ++c) {
      out[2 * c] = static_cast<uint32_t>(at[c].x * steps);
      out[2 * c + 1] = static_cast<uint32_t>(at[c].y * steps);
    }
  }
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return subject("bird.h of the Opacity Micro-Map SDK", [](mmverify_subject_t& it) {
    it.max_level = 12;
    it.flags = MMVERIFY_CORNERS_BASE_U_V;
    it.index_f32 = index;
    it.corners = corners;
  });
}
