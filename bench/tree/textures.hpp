// A maker of maps from the alpha textures of real scenes.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/textures/alpha_textures.hpp"
#include "impl/tree/stream.hpp"

namespace mmverify::bench {

/// The two half-square triangles of each texture, (0,0) (1,0) (0,1) and (1,1) (0,1) (1,0), one map each.
///   opaque if the texel under the centre of the micro-triangle has alpha >= 128; with four states unknown
///   (transparent or opaque by the centre) if the centre and the three corners do not agree
/// A sample, not the exact baker.  Domain: level 0..12.
std::vector<std::vector<std::uint8_t>> texture_maps(const std::vector<AlphaTexture>& textures,
                                                    impl::tree::Level level, impl::tree::Format bits);

}  // namespace mmverify::bench
