// What `mmverify scene` makes of a file, and how it is told.
#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "proofs/scene/laws.hpp"
#include "proofs/scene/subject_maps.hpp"
#include "scene/pipeline.hpp"

namespace mmverify::cli {

/// Everything that was found, in the order in which it was.
struct SceneFigures {
  const mmverify::scene::Scene& scene;
  const mmverify::scene::SceneMicromaps& made;
  mmverify::scene::Sizes sizes;
  mmverify::scene::VqFootprint vq2, vq4;
  double load_seconds = 0;
  /// With every triangle at one level (figure 5), where they were asked for.
  struct AtLevel {
    unsigned level;
    mmverify::scene::Sizes sizes;
  };
  std::vector<AtLevel> at_levels;
};

/// The plan, with what it leaves out and why.
void print_plan(std::FILE* out, const mmverify::scene::Scene& scene, const mmverify::scene::Plan& plan,
                const mmverify::scene::Levels& levels);

/// Counts, states and sizes.
void print_figures(std::FILE* out, const SceneFigures& figures);

/// What the laws have nothing for.
void print_left_out(std::FILE* out, const std::vector<proofs::scene::LeftOutLaw>& left_out);

/// Somebody else's maps, by name, and what is wrong of them.
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

/// The gnuplot script of figure 5: above, bytes by level; below, how often smaller the tree is.
std::string sizes_plot_script(const SceneFigures& figures);

}  // namespace mmverify::cli
