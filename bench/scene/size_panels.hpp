// The memory of a scene's forms by level, drawn.
#pragma once

#include <vector>

#include "bench/picture.hpp"
#include "scene/bake/footprint.hpp"

namespace mmverify::bench {

/// The sizes with every triangle at one level.
struct SizesOfLevel {
  unsigned level = 0;
  scene::Footprint footprint;
};

/// Two panels: the bytes of each form by level, and the ratio by which the tree is smaller than the maps.
/// Source: Succinct Opacity Micromaps, figure 5.
std::vector<picture::Panel> size_panels(const std::vector<SizesOfLevel>& sizes);

}  // namespace mmverify::bench
