// The opacity micromap builder of Khronos' Vulkan-Tutorial as a subject: its classification as a baker, its
// curve as corners.  The recipe extracts these functions from the checkout's file, since the rest needs its
// engine and a device.  It samples the nearest texel at four places, and leaves states to the shader from
// 0.05 up and below 0.95.
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <future>
#include <glm/glm.hpp>

#include "config.inc"
#include "examples/adapters/subject.hpp"

struct Vertex {
  glm::vec2 texCoord;
};

struct Renderer {
  Renderer* GetThreadPool() { return nullptr; }
  void KickWatchdog(const char*) {}
  template <typename F>
  std::future<void> enqueue(F f, uint32_t from, uint32_t to) {
    return std::async(std::launch::deferred, f, from, to);
  }
};

struct OpacityMicromapBuilder {
  Renderer* m_renderer = nullptr;
  float sampleAlpha(const uint8_t*, uint32_t, uint32_t, uint32_t, float, float) const;
  void classify(const std::vector<Vertex>&, const std::vector<uint32_t>&, const uint8_t*, uint32_t, uint32_t,
                uint32_t, const OmmConfig&, std::vector<uint8_t>&, OmmMeshInfo&) const;
};
#include "builder.inc"

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  const float* uv = c->uv;
  std::vector<uint8_t> states;
  OmmConfig config;
  OmmMeshInfo info;
  config.subdivisionLevel = c->level;
  OpacityMicromapBuilder().classify({{{uv[0], uv[1]}}, {{uv[2], uv[3]}}, {{uv[4], uv[5]}}}, {0, 1, 2},
                                    static_cast<const uint8_t*>(c->texels), c->width, c->height, 1, config,
                                    states, info);
  std::memcpy(map, packStates(states, 1, c->level).data(), bytes_of(*c));
  return 1;
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return baker_subject("Vulkan-Tutorial", bake, [](mmverify_bake_support_t& it) {
    it.max_level = 4, it.formats = 1U << MMVERIFY_4_STATE, it.texels = 1U << MMVERIFY_UNORM8, it.max_mips = 1;
    it.alpha_modes = 1U << MMVERIFY_MASK;
#ifndef ADAPTER_SCENE  // under it, scenes are baked as they are, filtered
    it.filters = 1U << MMVERIFY_NEAREST, it.wraps = 1U << MMVERIFY_REPEAT;
#endif
    it.restrictions = MMVERIFY_BAKE_NO_FACTORS | MMVERIFY_BAKE_NO_MARGIN, it.fixed_cutoff = 0.5F;
    it.contact = MMVERIFY_OPEN_MICRO_TRIANGLES, it.unknown = MMVERIFY_UNKNOWN_OPAQUE;
  });
}
