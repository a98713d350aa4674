// What `mmverify scene` makes of a file, and how it is told.
#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "impl/scene/any_hit.hpp"
#include "impl/scene/footprint.hpp"
#include "impl/scene/levels.hpp"
#include "impl/scene/square_maps.hpp"
#include "impl/scene/vq_footprint.hpp"
#include "proofs/scene.hpp"

namespace mmverify::cli {

/// Everything that was found, in the order in which it was.
struct SceneFigures {
  const impl::scene::Scene& scene;
  const impl::scene::Plan& plan;
  const impl::scene::Levels& levels;
  const impl::scene::Baked& baked;
  const impl::scene::SceneArrays& arrays;
  const impl::scene::Pairs& pairs;
  impl::scene::Footprint footprint;
  impl::scene::AnyHitShares any_hit;
  impl::scene::VqFootprint vq2, vq4;
  double load_seconds = 0, bake_seconds = 0;
  /// Footprints with every triangle at one level (figure 5), where they were asked for.
  struct AtLevel {
    unsigned level;
    impl::scene::Footprint footprint;
    impl::scene::AnyHitShares any_hit;
  };
  std::vector<AtLevel> sizes;
};

/// The plan, with what it leaves out and why.
void print_plan(std::FILE* out, const impl::scene::Scene& scene, const impl::scene::Plan& plan,
                const impl::scene::Levels& levels);

/// Counts, states and sizes.
void print_figures(std::FILE* out, const SceneFigures& figures);

/// What the laws have nothing for.
void print_left_out(std::FILE* out, const std::vector<proofs::scene::LeftOutLaw>& left_out);

/// The member "scene" of the results.
std::string scene_json(const SceneFigures* figures, const impl::scene::Scene& scene,
                       const impl::scene::Plan& plan, const std::vector<proofs::scene::LeftOutLaw>& left_out);

/// The gnuplot script of figure 5: above, bytes by level; below, how often smaller the tree is.
std::string sizes_plot_script(const SceneFigures& figures);

}  // namespace mmverify::cli
