// The hits of a picture's rays, and counts of the work that they took.
#pragma once

#include <cstdint>
#include <vector>

#include "display/render/barycentrics.hpp"

namespace mmverify::render {

/// The hit that ended a ray.  Equal values mean the same triangle of the same instance, at the same t.
struct Met {
  static constexpr std::uint32_t nothing = 0xffffffff;
  float t = 0;
  std::uint32_t instance = nothing, geometry = nothing, triangle = nothing;
  bool hit() const { return triangle != nothing; }
  bool operator==(const Met&) const = default;
};

/// The filter calls and any-hit calls of one ray.
struct ShaderCalls {
  std::uint32_t candidates = 0;  ///< filter calls: hits on triangles that have a surface
  std::uint32_t shader = 0;      ///< candidates that an any-hit shader decided by the texture
};

struct Pixel {
  Met primary;
  Barycentrics at{0, 0};   ///< the primary hit on its triangle
  bool lit = false;        ///< the shadow ray met nothing
  float shade = 0;         ///< cosine of normal and light
  std::uint64_t open = 0;  ///< bit k: ray k of ambient occlusion met nothing
  ShaderCalls by_primary, by_shadow, by_ambient;
  std::uint32_t calls() const { return by_primary.shader + by_shadow.shader + by_ambient.shader; }
};

struct Counts {
  std::uint64_t rays = 0, shadow_rays = 0, ambient_rays = 0;
  std::uint64_t candidates = 0, ignored = 0, opaque = 0, shader = 0;
  std::uint64_t planned = 0;  ///< candidates on geometries that get micromaps
  std::uint64_t met = 0;      ///< of a frame: rays of all kinds with such a candidate
  std::uint64_t fetches = 0;  ///< texels read
  Counts& operator+=(const Counts& other);
  bool operator==(const Counts&) const = default;
  std::uint64_t all_rays() const { return rays + shadow_rays + ambient_rays; }
  /// The share of candidates on geometries with micromaps that called no shader; 0 if there is none.
  double known() const {
    return planned == 0 ? 0 : static_cast<double>(ignored + opaque) / static_cast<double>(planned);
  }
};

/// Any-hit calls over rays of all kinds; 0 without a ray.
inline double calls_a_ray(const Counts& counts) {
  return counts.all_rays() == 0 ? 0
                                : static_cast<double>(counts.shader) / static_cast<double>(counts.all_rays());
}

struct Frame {
  std::uint32_t width = 0, height = 0;
  std::vector<Pixel> pixels;  ///< rows from the top
  Counts counts;
  double seconds = 0, cpu_seconds = 0;  ///< cpu_seconds: the sum over the threads that traced it
  unsigned ambient = 0;                 ///< rays of ambient occlusion from each hit
};

/// Whether the rays of both pixels met the same triangle of the same instance at the same t, are lit alike, and
/// the same rays of ambient occlusion met something.
bool same(const Pixel& a, const Pixel& b);

/// The number of pixels that are not same().
/// Domain: frames of one size, else std::invalid_argument.
std::uint64_t differing(const Frame& a, const Frame& b);

/// A hash of all hits: FNV-1a over the pixels in their order.  It does not depend on the number of threads.
std::uint64_t digest(const Frame& frame);

}  // namespace mmverify::render
