// The pipeline from a scene to its micromaps in one call: plan, levels, maps, arrays, pairs and square maps.
#pragma once

#include <functional>

#include "scene/bake/any_hit.hpp"
#include "scene/bake/arrays.hpp"
#include "scene/bake/footprint.hpp"
#include "scene/bake/square_maps.hpp"
#include "scene/bake/vq_footprint.hpp"
#include "scene/plan/levels.hpp"
#include "scene/plan/pairs.hpp"
#include "scene/read/file.hpp"
#include "scene/record/bake_record.hpp"

namespace mmverify::scene {

struct PipelineOptions {
  LevelRequest levels = {};
  unsigned level_limit = finest_level;  ///< the finest level of a request that leaves levels open
  MovingTextures moving = MovingTextures::left_out;
  BakeOptions bake = {};
  /// Called once, before a texel is read.  If it returns false, or there is nothing to bake, the maps,
  /// arrays, pairs and square maps stay empty.
  std::function<bool(const Plan&, const Levels&)> planned = {};
};

/// All results of the pipeline.
struct SceneMicromaps {
  Plan plan;
  Levels levels;
  Baked baked;
  SceneArrays arrays;
  Pairs pairs;
  SquareMaps squares;
  double bake_seconds = 0;  ///< of `baked` alone
};

/// Runs the pipeline; the results are the same for any number of threads.
/// Errors: std::invalid_argument as of levels() and bake(); exceptions of `planned` and BakeOptions::done.
SceneMicromaps make_micromaps(const Scene& scene, const PipelineOptions& options = {});

/// The memory that micromaps take, and the any-hit calls that they save.
struct Sizes {
  Footprint footprint;
  AnyHitShares any_hit;
};
Sizes sizes(const Scene& scene, const Plan& plan, const Baked& baked, const SceneArrays& arrays,
            unsigned threads);

/// The sizes with every triangle at one level.
/// Source: Opacity Micromaps of a scene level by level, figure 5 of Succinct Opacity Micromaps.
Sizes sizes_at_level(const Scene& scene, const Plan& plan, unsigned level, const BakeOptions& options);

/// Bytes of the 4-state maps of all planned triangles at one level.
std::uint64_t map_bytes_at_level(const Plan& plan, unsigned level);

/// The scene of `file` as one GLB with the micromaps added, as by to_glb(); it breaks no rule of
/// validate_micromaps().  Each primitive has the record of its bake in `extras`.  `bytes`: the file's bytes, if it is not to be read.  `name`: the result's name in
/// messages.
/// Errors: as of to_glb(); std::logic_error if the GLB would break a rule.
Bytes with_micromaps(const std::string& file, std::optional<std::span<const unsigned char>> bytes,
                     const Scene& scene, const Plan& plan, const SceneArrays& arrays, const std::string& name,
                     const BakeSettings& settings = {});

}  // namespace mmverify::scene
