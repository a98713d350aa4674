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
#include "scene/bake/material_figures.hpp"
#include "scene/pipeline.hpp"

namespace mmverify::cli {

/// All figures, in the order in which they are found.
struct SceneFigures {
  const mmverify::scene::Scene& scene;
  const mmverify::scene::SceneMicromaps& made;
  mmverify::scene::Sizes sizes;
  mmverify::scene::VqFootprint vq2, vq4;
  double load_seconds = 0;
  bool two_state = false;  ///< maps are forced to 2-state
  bool one_level = false;  ///< all maps were asked for at one level
  std::vector<mmverify::scene::MaterialFigures> materials;
  /// The sizes with every triangle at one level (figure 5), if requested.
  struct AtLevel {
    unsigned level;
    mmverify::scene::Sizes sizes;
  };
  std::vector<AtLevel> at_levels;
};

/// "624 B", "21.3 kB", "12.1 MB".
std::string bytes_text(std::uint64_t bytes);

/// Prints the plan, with the primitives that it leaves out and the reasons.
void print_plan(std::FILE* out, const mmverify::scene::Scene& scene, const mmverify::scene::Plan& plan,
                const mmverify::scene::Levels& levels);

/// Prints counts, states and sizes.
void print_figures(std::FILE* out, const SceneFigures& figures);

/// The options that a next command repeats.
struct AskedOf {
  bool moving = false;
  std::string options;  ///< "--moving --margin 0.5 ", or nothing
  std::string levels;   ///< "--level 4 ", "--level-limit 7 ", "--memory 51200 ", or nothing
  std::string written;  ///< the file of -o, or nothing
};

/// Prints six lines: triangles and maps, any-hit calls, memory, coarser levels, laws, the next command; and one more where
/// an animation moves triangles that have no maps.
///   asks: the share of the area that shaders may be asked for, in [0, 1]; then the fourth line names the level for it
void print_summary(std::FILE* out, const SceneFigures& figures, const proofs::Report& report,
                   const std::optional<double>& asks, const std::string& file, const AskedOf& asked);

/// Prints a table with a row for each material: triangles, maps, levels, bytes, the share of the area that asks shaders,
/// and with `asks` the coarsest level that leaves at most that share.
void print_materials(std::FILE* out, const SceneFigures& figures, const std::optional<double>& asks);

/// Prints the sizes with every triangle at one level, one level a line; nothing if none were asked for.
void print_levels(std::FILE* out, const SceneFigures& figures);

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

/// The share of the area that calls shaders against bytes, of the scene and of its largest materials.  With the sizes by
/// level, figure 5 above it: bytes by level, and the ratio by which the tree is smaller.
bench::picture::Picture sizes_picture(const SceneFigures& figures);

}  // namespace mmverify::cli
