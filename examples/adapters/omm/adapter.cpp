// NVIDIA's Opacity Micro-Map SDK as a subject: ommCpuBake is judged as a baker of a triangle, and of whole meshes.
// Opaque is alpha > cutoff, and mixed micro-triangles are UO.  States count as right within 8 bits of a texel's fraction.
#include "examples/adapters/omm/input.hpp"

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  const uint32_t corners[] = {0, 1, 2};
  const Baked baked(input_of(*c, c->uv, corners, 3));
  if (!baked) return 0;
  const int32_t index = *static_cast<const int32_t*>(baked->indexBuffer);
  if (index < 0)
    uniform(*c, -1 - index, map);
  else
    std::memcpy(map, static_cast<const char*>(baked->arrayData) + baked->descArray[index].offset,
                bytes_of(*c));
  return 1;
}

static UsageCounts counts_of(const ommCpuOpacityMicromapUsageCount* counts, uint32_t count) {
  UsageCounts all;
  for (uint32_t k = 0; k < count; ++k)
    all.push_back({counts[k].count, counts[k].subdivisionLevel, counts[k].format});
  return all;
}

static size_t bake_mesh(const mmverify_mesh_case_t* c, uint8_t* answer, size_t capacity) {
  ommCpuBakeInputDesc in = input_of(*c->surface, c->uvs, c->indices, 3 * c->triangles);
  std::vector<uint8_t> levels;
  if (c->levels != nullptr) levels.assign(c->levels, c->levels + c->triangles);
  if (c->levels != nullptr) in.subdivisionLevels = levels.data();
  const Baked baked(in);
  if (!baked) return 0;
  MadeMesh made;
  for (uint32_t k = 0; k < baked->descArrayCount; ++k) {
    made.offsets.push_back(baked->descArray[k].offset);
    made.levels.push_back(baked->descArray[k].subdivisionLevel);
  }
  const auto* indices = static_cast<const int32_t*>(baked->indexBuffer);
  const auto* data = static_cast<const uint8_t*>(baked->arrayData);
  made.indices.assign(indices, indices + baked->indexCount);
  made.data.assign(data, data + baked->arrayDataSize);
  made.of_records = counts_of(baked->descArrayHistogram, baked->descArrayHistogramCount);
  made.of_references = counts_of(baked->indexHistogram, baked->indexHistogramCount);
  return mesh_answer(*c, made, answer, capacity);
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  if (!has_baker()) return nullptr;
  return mesh_subject("Opacity Micro-Map SDK", bake, bake_mesh, [](mmverify_bake_support_t& it) {
    it.texels = 1U << MMVERIFY_UNORM8, it.filters = 1U << MMVERIFY_BILINEAR,
    it.alpha_modes = 1U << MMVERIFY_MASK;
    it.wraps = ADAPTER_WRAPS;  // border addressing is a subject of its own
    it.restrictions = MMVERIFY_BAKE_SAME_WRAPS | MMVERIFY_BAKE_NO_FACTORS | MMVERIFY_BAKE_NO_MARGIN |
                      MMVERIFY_BAKE_FLOAT_CUTOFFS;
    it.opaque = MMVERIFY_OPAQUE_ABOVE_CUTOFF, it.unknown = MMVERIFY_UNKNOWN_OPAQUE;
    it.uv_min = -16, it.uv_max = 16, it.weight_bits = 8, it.coordinate_bits = 8;
  });
}
