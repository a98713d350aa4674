// A scene's micromaps in all the forms that are wanted, level by level.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/opacity.hpp"
#include "render/scene/world_of.hpp"

namespace mmverify::render {

struct FormsOptions {
  unsigned first = 6, last = 6;                   ///< levels
  std::vector<Method> wanted = {};                ///< texture is no form
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< bytes that all maps of a level may take
  unsigned threads = 0;                           ///< 0: as many as the machine has
  /// Told what is being done, and how many micro-triangles are done, from any thread; what they throw ends it.
  std::function<void(const std::string& what, std::uint64_t of)> begins = {};
  std::function<void(std::uint64_t)> done = {};
};

struct Form {
  Method method;
  std::optional<unsigned> level;  ///< none of square maps, whose sides are fixed
  std::unique_ptr<const Opacity> opacity;
};

/// Forms of the same maps: those of one level, or VQ2 and VQ4.
struct FormsOfMaps {
  std::vector<Form> forms;
  std::optional<double> predicted;           ///< of a level: scene::AnyHitShares::known()
  std::unique_ptr<const Opacity> flat = {};  ///< of a level, whether it is wanted or not
};

/// The level whose maps would take more than the memory, and how much; it and all finer ones are left out.
struct LeftOut {
  std::optional<unsigned> first;
  std::uint64_t bytes = 0;
};

/// Square maps, then level by level.  What `visit` gets lives as long as its call.
/// Domain: world and plan of this scene; levels up to scene::finest_level.
/// Errors: as of scene::bake(); what the functions throw.
LeftOut each_forms(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                   const FormsOptions& options, const std::function<void(const FormsOfMaps&)>& visit);

}  // namespace mmverify::render
