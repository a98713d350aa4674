// The time to bake the triangles of a scene, at their own texture coordinates.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace mmverify::bench {

struct SceneBakeOptions {
  std::string file;                                       ///< glTF or GLB
  std::uint32_t first = 3, last = 9;                      ///< levels
  std::size_t rounds = 3, most_rounds = 1000;             ///< of a level, at least and at most
  double seconds = 3;                                     ///< between these, rounds until ours took this long
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
  std::function<void()> stop = {};                        ///< called before each triangle; may throw
};

/// The figures of all planned triangles of the scene at one level, one after the other.
struct SceneBakeLevel {
  std::uint32_t level = 0;
  std::uint64_t micro_triangles = 0;
  std::size_t rounds = 0;
  double ns = 0;  ///< ours, a micro-triangle of base area, the median round; textures are prepared before
  double fastest_ns = 0;  ///< the fastest round, which other load on the machine disturbs least
  /// The fastest round of one sample at each centre, as if every texture repeated.  Its rounds take as long
  /// in all as ours.
  double ns_of_centres = 0;
};

struct SceneBakeFigures {
  std::string file;
  std::size_t triangles = 0;  ///< distinct by their texture coordinates; 0: nothing to bake, and no levels
  double ready_ms = 0;        ///< the preparation of all textures, once a bake of the scene: the median
  std::vector<SceneBakeLevel> levels;
  std::uint64_t varying = 0;  ///< triangles that are left out because their vertex alpha varies
};

/// The figures of a scene's bakes.  Times are of one thread.
/// Throws std::invalid_argument unless 0 < rounds <= most_rounds and first <= last <= 12; scene::BadScene.
SceneBakeFigures scene_bake_figures(const SceneBakeOptions& options);

}  // namespace mmverify::bench
