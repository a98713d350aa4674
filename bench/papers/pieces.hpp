// The parts of an alpha texture, each as a texture of its own.
#pragma once

#include <vector>

#include "bench/textures/alpha_textures.hpp"

namespace mmverify::bench::papers {

/// The connected parts of the texels with alpha >= 1/2, by eight neighbours, in the order of their first texels.  Each
/// has the texture's size; opaque texels of the other parts are 0.  Parts with less than the share `least` of all
/// opaque texels are left out.
/// Source: Compressed Opacity Maps, 4.3: atlases "were first manually subdivided into smaller images".
/// Domain: least in [0, 1].
std::vector<AlphaTexture> pieces(const AlphaTexture& texture, double least);

}  // namespace mmverify::bench::papers
