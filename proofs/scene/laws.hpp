// The laws of all topics on one scene's own data.
#pragma once

#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"
#include "proofs/scene/law_groups.hpp"

namespace mmverify::proofs::scene {

/// What of a law's levels the scene has nothing for.
struct LeftOutLaw {
  std::string what, why;
};

/// The laws of a scene, and a job for each level that occurs.  Moving it leaves the laws where they are.
struct SceneLaws {
  std::vector<Law> laws;
  std::vector<Job> jobs;
  std::vector<LeftOutLaw> left_out;
};

/// `command`: what shows a counterexample again, but for --replay LAW and --case LEVEL@CASE.
/// Domain: data that outlives the laws.
SceneLaws scene_laws(const Data& data, const BakeSample& sample, const std::string& command);

/// The laws of baking alone, on maps that somebody else has made; `name`: of their file.
SceneLaws map_laws(const Data& data, const BakeSample& sample, const std::string& name,
                   const std::string& command);

}  // namespace mmverify::proofs::scene
