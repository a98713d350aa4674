// The laws of all topics on one scene's own data.
#pragma once

#include <memory>

#include "proofs/engine/runner.hpp"
#include "proofs/scene/bake_sample.hpp"
#include "proofs/scene/subject_maps.hpp"

namespace mmverify::proofs::scene {

class ExactSurfaces;
using ExactSurfacesPtr = std::shared_ptr<const ExactSurfaces>;

// `data` outlives the laws; `exact` is of its plan.
std::vector<Law> bake_laws(const Data& data, const ExactSurfacesPtr& exact, const BakeSample& sample);
std::vector<Law> array_laws(const Data& data);
std::vector<Law> tree_laws(const Data& data);
std::vector<Law> vq_laws(const Data& data, const ExactSurfacesPtr& exact);

struct SubjectLaws {
  std::vector<Law> laws;
  std::vector<Job> jobs;
};

/// bake.conservative and bake.tight, a case a triangle of the scene, a job for each level that occurs.
/// `command`: what shows a counterexample again, but for --replay LAW and --case LEVEL@CASE.
/// Domain: maps that outlive the laws.
SubjectLaws subject_laws(const SubjectMaps& maps, const std::string& command);

/// A law, levels of a law, or a format without cases in the scene, and the reason.
struct LeftOutLaw {
  std::string what, why;
};

/// The laws of a scene, and a job for each level that occurs.  A move keeps the laws in place.
struct SceneLaws {
  std::vector<Law> laws;
  std::vector<Job> jobs;
  std::vector<LeftOutLaw> left_out;
  ExactSurfacesPtr exact = {};  ///< what the laws find exact states with
};

/// `command`: the command that shows a counterexample again, without --replay LAW and --case LEVEL@CASE.
/// Domain: data that outlives the laws.
SceneLaws scene_laws(const Data& data, const BakeSample& sample, const std::string& command);

/// The number of states so far that took rationals, as a sentence; none where none did.
std::optional<std::string> rationals_text(const SceneLaws& laws);

/// The laws of baking only, on maps that another program has made; `name`: their file's.
SceneLaws map_laws(const Data& data, const BakeSample& sample, const std::string& name,
                   const std::string& command);

}  // namespace mmverify::proofs::scene
