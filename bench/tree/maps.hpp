// Generated maps like those of foliage, from a seed.
#pragma once

#include <cstdint>
#include <vector>

#include "impl/tree/stream.hpp"

namespace mmverify::bench {

/// A map of `level` with 20 to 99 leaves, about as much outline as on the alpha textures of real foliage:
/// lens shapes (two circles cut) of random place, turn and size with serrated outlines, over the base
/// triangle (0,0), (1,0), (0,1).
///   two states   opaque if the centre of the micro-triangle lies on a leaf
///   four states  unknown (transparent or opaque by the centre) if the centre and the three corners do not agree
/// A node of the tree that lies on one side of the outline, by the slope of the distance, is filled at once.
/// So the work grows with the outline, not with 4^level points.
/// Domain: level 0..12.  The same map for the same seed at every level: only finer.
std::vector<std::uint8_t> leaf_map(impl::tree::Level level, impl::tree::Format bits, std::uint64_t seed);

}  // namespace mmverify::bench
