// mmverify views: renders a view with textures and with attribute micromaps.
#pragma once

#include <string>

#include "cli/render/picture_size.hpp"
#include "display/render/scene/views.hpp"
#include "display/render/tracer.hpp"
#include "proofs/engine/law.hpp"

namespace mmverify::cli {

struct ViewArguments {
  std::string file, levels = "0..6", pictures, json;
  render::Shading shading = render::Shading::lit;
  PictureSize size;
  std::uint32_t rays = 1;       ///< along each side of a pixel
  std::uint32_t reference = 4;  ///< the same of the view that maps read by cones are compared with
  std::uint64_t camera = 0, seed = 1;
  unsigned threads = 0;
  bool no_shadows = false, quiet = false, cones = false;
};

/// Renders the views and returns the exit code. Errors: UsageError, EnvironmentError, BadScene.
int render_views(const ViewArguments& arguments);

}  // namespace mmverify::cli
