// meshoptimizer's opacity maps as a subject: meshopt_opacityMapRasterize is judged as a baker, and with
// meshopt_opacityMapMeasure and meshopt_opacityMapCompact around it as a baker of meshes.
#include <meshoptimizer.h>

#include "examples/adapters/mesh.hpp"
#include "examples/adapters/meshoptimizer/support.hpp"

static void rasterize(const mmverify_bake_case_t& c, int level, const float* uv0, const float* uv1,
                      const float* uv2, uint8_t* map) {
  meshopt_opacityMapRasterize(map, level, c.format == MMVERIFY_2_STATE ? 2 : 4, uv0, uv1, uv2,
                              static_cast<const unsigned char*>(c.texels), 1, c.width, c.width, c.height);
}

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  rasterize(*c, static_cast<int>(c->level), c->uv, c->uv + 2, c->uv + 4, map);
  return 1;
}

/// It has one level for all triangles, or levels of its own choice.
static size_t bake_mesh(const mmverify_mesh_case_t* c, uint8_t* answer, size_t capacity) {
  if (c->levels != nullptr) return 0;
  const mmverify_bake_case_t& surface = *c->surface;
  const int level = static_cast<int>(surface.level), states = surface.format == MMVERIFY_2_STATE ? 2 : 4;
  std::vector<unsigned char> levels(c->triangles);
  std::vector<unsigned> sources(c->triangles);
  MadeMesh made;
  made.indices.resize(c->triangles);
  size_t count = meshopt_opacityMapMeasure(levels.data(), sources.data(), made.indices.data(), c->indices,
                                           size_t{3} * c->triangles, c->uvs, c->vertices, 2 * sizeof(float),
                                           surface.width, surface.height, level, 0);
  const size_t bytes = meshopt_opacityMapEntrySize(level, states);
  made.offsets.resize(count);
  made.data.resize(count * bytes);
  for (size_t k = 0; k < count; ++k) {
    made.offsets[k] = uint32_t(k * bytes);
    const uint32_t t = sources[k];
    rasterize(surface, levels[k], corner(*c, t, 0), corner(*c, t, 1), corner(*c, t, 2),
              &made.data[k * bytes]);
  }
  count = meshopt_opacityMapCompact(made.data.data(), made.data.size(), levels.data(), made.offsets.data(),
                                    count, made.indices.data(), c->triangles, states);
  made.offsets.resize(count);
  made.levels.assign(levels.begin(), levels.begin() + std::ptrdiff_t(count));
  made.data.resize(count * bytes);
  count_usage(*c, made);
  return mesh_answer(*c, made, answer, capacity);
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return mesh_subject("meshoptimizer", bake, bake_mesh, rasterizer_supports);
}
