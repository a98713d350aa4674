// The sizes of a scene's maps in each form, and the times of lookups in them, level by level.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/dag/csm_figures.hpp"
#include "bench/growth.hpp"
#include "bench/scene/dag_maps.hpp"
#include "bench/scene/square_times.hpp"

namespace mmverify::bench {

struct SceneDagOptions {
  std::string file;                                 ///< glTF or GLB
  std::uint32_t first = 3, last = 12;               ///< levels
  std::uint64_t seed = 1;                           ///< of the lookups
  std::uint64_t lookups = 1'000'000;                ///< a level and format
  std::uint64_t memory = std::uint64_t{128} << 20;  ///< bytes of a level's 4-state maps; beyond it, a sample
  std::function<void(const std::string&)> progress =
      {};                           ///< receives the name of each step that begins; may throw
  std::function<void()> stop = {};  ///< called before each map; may throw
};

/// The forms, in this order everywhere.
///   flat    a packed map for each triangle of the scene's meshes, as in an array without removal of duplicates
///   once    equal maps once; the forms below start from these
///   paper   each map's two bit sequences (impl/tree/stream.hpp)
///   ranked  each map's tree for random access (impl/tree/tree.hpp)
///   dag     one graph of all maps (impl/dag/dag.hpp)
///   lz4, zstd  all maps, one after the other, compressed as one (bench/scene/compressors.hpp): no lookups
enum class SceneForm : std::uint8_t { flat, once, paper, ranked, dag, lz4, zstd };
inline constexpr std::size_t scene_forms = 7;
const char* to_string(SceneForm form);

struct SceneFormFigures {
  std::uint64_t bytes = 0;   ///< with 8 bytes a map for its place, except lz4 and zstd
  std::optional<double> ns;  ///< a lookup, over independent random ones on all maps, if the form has lookups
  std::optional<double> ns_to_once;  ///< the median of the rounds' ratios
  std::optional<double> build_rate;  ///< millions of micro-triangles a second, from flat maps, one thread
};

/// The figures of one level and format.
struct SceneDagFigures {
  std::uint32_t level = 0, bits = 0;
  std::uint64_t all = 0;       ///< distinct pairs of a triangle and an order of its vertices in the scene
  std::uint64_t taken = 0;     ///< maps of these that were baked here
  std::uint64_t uniform = 0;   ///< baked maps of one state: they are special indices, and in no form
  std::uint64_t maps = 0;      ///< the other baked maps
  std::uint64_t distinct = 0;  ///< of these, distinct by their bytes
  std::array<SceneFormFigures, scene_forms> forms{};
  double order_0_bytes = 0;             ///< StateEntropy of the distinct maps
  std::optional<double> context_bytes;  ///< StateEntropy of the distinct maps
  CsmFigures csm;

  const SceneFormFigures& form(SceneForm f) const { return forms[static_cast<std::size_t>(f)]; }
};

/// The growth of a form's bytes a map from level to level, over the last levels.
struct SceneGrowth {
  std::uint32_t bits = 0;
  SceneForm form = SceneForm::flat;
  Growth growth;
};

/// "4^n, the area", "2^n, the outline", "flat", "x2.70 each level" or "too few to fit", by the exponential
/// law alone, since the area and the outline are both exponential.  Their exponents are met to within 0.15.
std::string area_or_outline(const Growth& growth);

struct SceneDagScene {
  std::string file;
  std::uint64_t triangles = 0;  ///< of meshes, with a map
  std::uint64_t distinct = 0;   ///< by their texture coordinates
  std::uint64_t maps = 0;       ///< distinct triangles and orders of vertices
  std::vector<SceneDagFigures>
      rows;            ///< levels and formats with a map of more than one state; by bits, then by level
  MergedBytes merged;  ///< the maps of all rows
  std::vector<SquareFigures> squares;
  std::vector<SceneGrowth> growth;
  std::uint64_t varying = 0;  ///< triangles that are left out because their vertex alpha varies
};

/// The figures of one level's maps in one format.  Times are of one thread.
/// Domain: in.maps not empty.  Throws std::runtime_error if two forms disagree: the graph, LZ4 and zstd are
/// decoded again, and lookups in all forms must give the same states.
SceneDagFigures scene_dag_figures(const MapsAtLevel& in, const SceneDagOptions& options);

/// The growth of all forms, each over the five finest levels of a format.
std::vector<SceneGrowth> scene_growth(const std::vector<SceneDagFigures>& rows);

/// The figures of the whole scene.  Throws std::invalid_argument unless first <= last <= 12 and there is a
/// lookup; scene::BadScene.
SceneDagScene scene_dag(const SceneDagOptions& options);

}  // namespace mmverify::bench
