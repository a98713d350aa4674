// The laws of baking on the maps that somebody else's baker makes of a scene.
#pragma once

#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"
#include "proofs/scene/subject_maps.hpp"

namespace mmverify::proofs::scene {

struct SubjectLaws {
  std::vector<Law> laws;
  std::vector<Job> jobs;
};

/// bake.conservative and bake.tight, a case a triangle of the scene, a job for each level that occurs.
/// `command`: what shows a counterexample again, but for --replay LAW and --case LEVEL@CASE.
/// Domain: maps that outlive the laws.
SubjectLaws subject_laws(const SubjectMaps& maps, const std::string& command);

}  // namespace mmverify::proofs::scene
