// The micromaps of a plan's triangles.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "impl/bake_triangles.hpp"
#include "impl/micromap_array.hpp"
#include "impl/scene/plan.hpp"

namespace mmverify::impl::scene {

struct BakedTriangle {
  unsigned level = 0;
  micromap::Format format = micromap::Format::four_state;
  micromap::StateCounts states{};          ///< micro-triangles by 4-state code
  std::optional<micromap::State> uniform;  ///< of all of them; then there is no map
  micromap::Bytes map;                     ///< packed
};

struct Baked {
  std::vector<BakedTriangle> triangles;  ///< by Plan::triangles
  bake::BakeCounts counts;
};

struct BakeOptions {
  unsigned threads = 0;    ///< 0: as many as the machine has
  bool two_state = false;  ///< force-2-state of every map
  float margin = 0;        ///< in texels; see bake::Sampling
  /// Told of micro-triangles done, from any thread; what it throws ends the baking.
  std::function<void(std::uint64_t)> done = {};
};

/// Bakes each distinct triangle once; a map that has no unknown state is 2-state.  The same for any number of
/// threads.
/// Domain: a plan of this scene; a level for each of its triangles, at most bake::max_bake_level.
/// Errors: std::invalid_argument, naming the image, for what cannot be baked: see bake::TriangleBaker; what
/// `done` throws.
Baked bake(const Scene& scene, const Plan& plan, std::span<const unsigned> levels,
           const BakeOptions& options = {});

}  // namespace mmverify::impl::scene
