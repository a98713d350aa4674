// mmverify render --cameras: a scene along a random path.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "render/scene/compare.hpp"

namespace mmverify::cli {

/// A scene that is ready for rays, and what to see of it.
struct PathRun {
  const mmverify::scene::Scene& scene;
  const mmverify::scene::Plan& plan;
  const render::SceneWorld& world;
  const render::Tracer& tracer;
  std::uint64_t cameras, seed;
  std::string json;             ///< a file, or - for stdout, or nothing
  std::function<void()> ended;  ///< told before anything is printed
};

/// Prints and writes the figures.  Returns the exit code: 1 where a pixel differs.
/// UsageError where nothing was compared; EnvironmentError where the scene cannot be baked; and as of render::along_path().
int render_path(const PathRun& run, const render::CompareOptions& options);

}  // namespace mmverify::cli
