// The figures of `mmverify scene`, and their output.
#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "bench/picture.hpp"
#include "proofs/scene/laws.hpp"
#include "proofs/scene/subject_maps.hpp"
#include "scene/pipeline.hpp"

namespace mmverify::cli {

/// All figures, in the order in which they are found.
struct SceneFigures {
  const mmverify::scene::Scene& scene;
  const mmverify::scene::SceneMicromaps& made;
  mmverify::scene::Sizes sizes;
  mmverify::scene::VqFootprint vq2, vq4;
  double load_seconds = 0;
  /// The sizes with every triangle at one level (figure 5), if requested.
  struct AtLevel {
    unsigned level;
    mmverify::scene::Sizes sizes;
  };
  std::vector<AtLevel> at_levels;
};

/// Prints the plan, with the primitives that it leaves out and the reasons.
void print_plan(std::FILE* out, const mmverify::scene::Scene& scene, const mmverify::scene::Plan& plan,
                const mmverify::scene::Levels& levels);

/// Prints counts, states and sizes.
void print_figures(std::FILE* out, const SceneFigures& figures);

/// Prints the laws that have no case, with the reasons.
void print_left_out(std::FILE* out, const std::vector<proofs::scene::LeftOutLaw>& left_out);

/// The maps of another baker, by its name, with their errors and time.
struct SubjectFigures {
  std::string name;
  proofs::scene::SubjectTotals totals;

  double times_ours() const { return totals.our_ns == 0 ? 0 : totals.ns / totals.our_ns; }
};
void print_subject(std::FILE* out, const SubjectFigures& figures);

/// The member "scene" of the results.
std::string scene_json(const SceneFigures* figures, const mmverify::scene::Scene& scene,
                       const mmverify::scene::Plan& plan,
                       const std::vector<proofs::scene::LeftOutLaw>& left_out,
                       const std::optional<SubjectFigures>& subject = {});

/// Figure 5 of these sizes. Upper panel: bytes by level; lower panel: the ratio by which the tree is
/// smaller.
bench::picture::Picture sizes_picture(const SceneFigures& figures);

}  // namespace mmverify::cli
