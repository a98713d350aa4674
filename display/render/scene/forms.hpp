// A scene's micromaps in all wanted forms, level by level.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "display/render/opacity.hpp"
#include "display/render/scene/world_of.hpp"

namespace mmverify::render {

struct FormsOptions {
  unsigned first = 6, last = 6;                   ///< levels
  std::vector<Method> wanted = {};                ///< texture is ignored
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< bytes that all maps of a level may take
  unsigned threads = 0;                           ///< 0: as many as the machine has
  unsigned states = 4;                            ///< 2: maps and bitmask have no unknown states
  /// Callbacks of progress, from any thread: `begins` names a task and the number of its micro-triangles, and
  /// `done` counts them.  An exception from them ends the work.
  std::function<void(const std::string& what, std::uint64_t of)> begins = {};
  std::function<void(std::uint64_t)> done = {};
};

struct Form {
  Method method;
  std::optional<unsigned> level;  ///< none for square maps, whose sides are fixed, and for the bitmask
  std::unique_ptr<const Opacity> opacity;
};

/// The forms of the same maps: of one level, or VQ2 and VQ4, or the bitmask.
struct FormsOfMaps {
  std::vector<Form> forms;
  std::optional<double> predicted;           ///< for maps of a level: scene::AnyHitShares::known()
  std::unique_ptr<const Opacity> flat = {};  ///< for maps of a level, even if it is not wanted
};

/// The first level whose maps would take more than the memory, and the bytes that they would take.  It and
/// all finer levels are left out.
struct LeftOut {
  std::optional<unsigned> first;
  std::uint64_t bytes = 0;
};

/// Visits the square maps, the bitmask, then the maps of each level.  The argument of `visit` lives as long as the call.
/// Domain: world and plan of this scene; levels up to scene::finest_level; states 2 or 4, and no square maps of 2.
/// Errors: as of scene::bake(); exceptions of the callbacks.
LeftOut each_forms(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                   const FormsOptions& options, const std::function<void(const FormsOfMaps&)>& visit);

}  // namespace mmverify::render
