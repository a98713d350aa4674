// Pictures of square maps, for the page of Compressed Opacity Maps.
#pragma once

#include <vector>

#include "bench/papers/pictures.hpp"

namespace mmverify::bench::papers {

/// Figures 3, 5, 6, 7, 8, 9 and 10 on the textures.
std::vector<Drawn> square_map_pictures(Measured& measured);

}  // namespace mmverify::bench::papers
