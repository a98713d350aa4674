// The curve of the nvpro sample mm_opacity as a subject: micro2bary gives the places of micro-triangles.
#include <glm/glm.hpp>

#include "bird_curve_helper.hpp"
#include "examples/adapters/subject.hpp"

static void corners(uint32_t level, const uint32_t* index, uint32_t* out, size_t count) {
  const float steps = static_cast<float>(1U << level);
  for (size_t k = 0; k < count; ++k) {
    glm::vec3 at[3];
    BirdCurveHelper::micro2bary(index[k], level, at[0], at[1], at[2]);
    for (const glm::vec3& it : at) {
      *out++ = static_cast<uint32_t>(it.y * steps);
      *out++ = static_cast<uint32_t>(it.z * steps);
    }
  }
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return subject("the curve of nvpro's mm_opacity", [](mmverify_subject_t& it) {
    it.max_level = 15;
    it.flags = MMVERIFY_CORNERS_BASE_U_V;
    it.corners = corners;
  });
}
