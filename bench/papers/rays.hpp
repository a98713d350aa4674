// Rays through a scene, for the papers' pages.
#pragma once

#include <vector>

#include "bench/papers/pictures.hpp"

namespace mmverify::bench::papers {

/// Heat maps of any-hit calls by the texture, VQ2, VQ4 and flat maps of level 6.
/// Source: Compressed Opacity Maps, figures 1 and 12.  Domain: a build with Embree.
render::Picture heat_maps(Measured& measured, std::size_t scene);

/// The any-hit calls of each pixel's primary ray by the texture, and the bits of 2-state trees that the ray reads in the
/// place of these calls, at levels 4 and 9: a picture each.
/// Source: Succinct Opacity Micromaps, figure 9.  Domain: as above.
std::vector<Drawn> bits_of_rays(Measured& measured, std::size_t scene);

/// Hits that blend by max.  Source: Color and Attribute Micromaps, figure 6.  Domain: as above.
render::Picture blended_by_max(Measured& measured, std::size_t scene);

/// The picture by the texture, by its bitmask of 1 bit, and by 2-state maps of levels 1 to 6.
/// Source: Succinct Opacity Micromaps, figure 6.  Domain: as above.
render::Picture two_state_pictures(Measured& measured, std::size_t scene);

/// The view by textures, by attribute maps of the levels, and FLIP's map, from left to right; then maps of the last level
/// read by ray cones.  The scene is the first that shows at most 10,000 textured triangles.  If none does, pictures are
/// smaller.
/// Source: Color and Attribute Micromaps, figures 1 and 8 and table 3.  Domain: as above; a level at least.
std::vector<Drawn> views(Measured& measured, const std::vector<unsigned>& levels);

}  // namespace mmverify::bench::papers
