// Maps like those of foliage, made of a seed.
#pragma once

#include <cstdint>
#include <vector>

#include "impl/tree/stream.hpp"

namespace mmverify::bench {

/// A map of `level` on which 20 to 99 leaves lie, about as much outline as on the alpha textures of real
/// foliage: lens shapes (two circles cut) of random place, turn and size with serrated outlines, over the
/// base triangle (0,0), (1,0), (0,1).
///   two states   opaque where the centre of the micro-triangle lies on a leaf
///   four states  unknown (transparent or opaque by the centre) where the centre and the three corners do
///                not agree
/// A node of the tree that lies whole on one side of the outline, by the slope of the distance, is filled at
/// once, so that the work is that of the outline and not of 4^level points.
/// Domain: level 0..12.  The same map for the same seed at every level: only finer.
std::vector<std::uint8_t> leaf_map(impl::tree::Level level, impl::tree::Format bits, std::uint64_t seed);

}  // namespace mmverify::bench
