// The curve of Khronos' Vulkan-Tutorial as a subject: the micro-triangle around each centroid of
// generateCentroids().
#include <array>
#include <cassert>
#include <glm/glm.hpp>
#include <vector>

#include "curve.inc"
#include "examples/adapters/subject.hpp"

static void corners(uint32_t level, const uint32_t* index, uint32_t* out, size_t count) {
  static thread_local std::vector<std::array<float, 2>> centroids;
  const float steps = static_cast<float>(1U << level);
  if (centroids.size() != microTriCount(level)) centroids = generateCentroids(level);
  for (size_t k = 0; k < count; ++k) {
    const float u = centroids[index[k]][0] * steps, v = centroids[index[k]][1] * steps;
    const uint32_t i = static_cast<uint32_t>(u), j = static_cast<uint32_t>(v);
    const uint32_t upper = u - static_cast<float>(i) + v - static_cast<float>(j) > 1 ? 1 : 0;
    for (const uint32_t it : {i + upper, j + upper, i + 1, j, i, j + 1}) *out++ = it;
  }
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return subject("the curve of Vulkan-Tutorial", [](mmverify_subject_t& it) {
    it.max_level = 8;
    it.corners = corners;
  });
}
