// mmverify render --attributes: renders a view with textures and with micromaps.
#pragma once

#include <string>

#include "display/render/scene/views.hpp"
#include "display/render/tracer.hpp"
#include "proofs/engine/law.hpp"

namespace mmverify::cli {

struct ViewArguments {
  std::string file, levels, pictures, json, shading;
  std::uint32_t width = 640, height = 480, rays = 1;
  std::uint64_t camera = 0, seed = 1;
  unsigned threads = 0;
  bool shadows = true, quiet = false;
};

/// Renders the views and returns the exit code. Errors: UsageError, EnvironmentError, BadScene.
int render_views(const ViewArguments& arguments);

}  // namespace mmverify::cli
