// A generated alpha texture, from a seed.
#pragma once

#include <cstdint>

#include "bench/textures/alpha_textures.hpp"

namespace mmverify::bench {

/// A picture of overlapping leaves, size x size texels, outlines fading over 1 to 4.  Named by its seed.
/// Domain: size in 16..16384.
AlphaTexture leaf_texture(std::uint64_t seed, int size = 256);

}  // namespace mmverify::bench
