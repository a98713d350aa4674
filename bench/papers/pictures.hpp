// The pictures of the papers' pages.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "bench/papers/item.hpp"
#include "bench/picture.hpp"
#include "display/render/picture.hpp"

namespace mmverify::bench::papers {

/// A picture of an item, in pixels or to be plotted.
struct Drawn {
  std::string item, name, caption;  ///< name: of a file, without its ending
  std::variant<render::Picture, picture::Picture> picture;
};

/// The pictures of a paper, from the first scene that has triangles to bake.  Those of rays are missing without Embree.
std::vector<Drawn> pictures(const Paper& paper, Measured& measured);

/// The rays of the first such scene by each method: frame times at levels 0 to 6, over the texture's.  No rows without
/// Embree.
Grid frame_times(Measured& measured);

/// The same scene's pictures by 2-state maps and a bitmask of 1 bit, beside the texture's.
Grid two_state_figures(Measured& measured);
/// Times of frames by bitmasks of 1 and 2 bits a texel.
Grid bitmask_times(Measured& measured);
/// Any-hit calls and times of level 6 over four cameras of a path, with four rays of ambient occlusion from each hit.
/// Source: Succinct Opacity Micromaps, 5.2.
Grid viewpoint_means(Measured& measured);

}  // namespace mmverify::bench::papers
