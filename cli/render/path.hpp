// mmverify render --cameras: renders a scene along a random path.
#pragma once

#include <cstdint>
#include <functional>

#include "cli/output/json_output.hpp"
#include "display/render/scene/compare.hpp"

namespace mmverify::cli {

/// A scene ready for rays, and the cameras to render.
struct PathRun {
  const mmverify::scene::Scene& scene;
  const mmverify::scene::Plan& plan;
  const render::SceneWorld& world;
  const render::Tracer& tracer;
  std::uint64_t cameras, seed;
  JsonOutput& json;
  std::function<void()> ended;  ///< called before anything is printed
};

/// Prints and writes the figures. Returns the exit code: 1 if a pixel differs.
/// UsageError if nothing was compared; EnvironmentError if the scene cannot be baked; and whatever
/// render::along_path() throws.
int render_path(const PathRun& run, const render::CompareOptions& options);

}  // namespace mmverify::cli
