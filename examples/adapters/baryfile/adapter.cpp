// The orders of NVIDIA's BaryFile as a subject: the places of values of micro-vertices and micro-triangles,
// and the mesh of a level.  BaryFile has the bird order and U-major.  W-minor and the rows of faces, which
// the laws need as well, are written here.
#include <bary/bary_core.h>

#include "examples/adapters/subject.hpp"

using bary::ValueFrequency;
using bary::ValueLayout;

static void vertex_index(uint32_t level, uint32_t order, const uint32_t* i, const uint32_t* j,
                         uint32_t* index, size_t count) {
  const auto layout =
      order == MMVERIFY_VERTICES_BIRD ? ValueLayout::eTriangleBirdCurve : ValueLayout::eTriangleUmajor;
  for (size_t k = 0; k < count; ++k) {
    const uint32_t row = i[k] + j[k];
    index[k] = order == MMVERIFY_VERTICES_W_MINOR
                   ? row * (row + 1) / 2 + j[k]
                   : bary::baryValueLayoutGetIndex(layout, ValueFrequency::ePerVertex, i[k], j[k], 0, level);
  }
}

static void face_index(uint32_t level, uint32_t order, const uint32_t* iu, const uint32_t* iv,
                       const uint32_t* upper, uint32_t* index, size_t count) {
  const auto layout =
      order == MMVERIFY_FACES_CURVE ? ValueLayout::eTriangleBirdCurve : ValueLayout::eTriangleUmajor;
  for (size_t k = 0; k < count; ++k) {
    const uint32_t row = iu[k] + iv[k] + upper[k];
    index[k] = order == MMVERIFY_FACES_ROWS
                   ? row * row + 2 * iv[k] + upper[k]
                   : bary::baryValueLayoutGetIndex(layout, ValueFrequency::ePerTriangle, iu[k], iv[k],
                                                   upper[k], level);
  }
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return subject("BaryFile", [](mmverify_subject_t& it) {
    it.max_level = 15;
    it.attribute_vertex_index = vertex_index;
    it.attribute_face_index = face_index;
  });
}
