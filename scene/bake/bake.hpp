// A baker of the micromaps of a plan's triangles.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "impl/bake/triangles.hpp"
#include "impl/micromap/array.hpp"
#include "scene/bake/map_bytes.hpp"
#include "scene/plan/plan.hpp"

namespace mmverify::scene {

struct BakedTriangle {
  unsigned level = 0;
  impl::micromap::Format format = impl::micromap::Format::four_state;
  impl::micromap::StateCounts states{};          ///< micro-triangles by 4-state code
  std::optional<impl::micromap::State> uniform;  ///< the state of all micro-triangles; then there is no map
  MapBytes map;                                  ///< packed
  /// Whether vertex alpha varies over it: states are those of bounds, and unknown ones may be needless.
  bool by_bounds = false;
};

struct Baked {
  std::vector<BakedTriangle> triangles;  ///< by Plan::triangles
  impl::bake::BakeCounts counts;
};

/// A margin for samplers in hardware, the sum of two errors.  Coordinates cut to 8 bits of fraction, like
/// filter weights, are off by at most 1/256 of a texel.  Texture coordinates off by 2^-20, a few roundings of
/// interpolation in binary32, are off by 1/1024 of a texel in a texture of 1024 texels.
/// Source: Vulkan, limits subTexelPrecisionBits (8 where more than the 4 that it asks for); the rest is a
/// choice.
inline constexpr float sampler_margin = 0x1.4p-8f;

struct BakeOptions {
  unsigned threads = 0;    ///< 0: as many as the machine has
  bool two_state = false;  ///< force-2-state of every map
  float margin = 0;        ///< in texels; see impl::bake::Sampling
  /// Receives the number of finished micro-triangles, from any thread; an exception from it ends the baking.
  std::function<void(std::uint64_t)> done = {};
};

/// Bakes each distinct triangle once; a map without unknown states is 2-state.  The result is the same for
/// any number of threads.
/// Domain: a plan of this scene; a level for each of its triangles, at most impl::bake::max_bake_level.
/// Errors: std::invalid_argument that names the image, if a triangle cannot be baked: see
/// impl::bake::TriangleBaker; exceptions of `done`.
Baked bake(const Scene& scene, const Plan& plan, std::span<const unsigned> levels,
           const BakeOptions& options = {});

}  // namespace mmverify::scene
