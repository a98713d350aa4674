// The fewest substitutions that any VQ2 block needs for a map, from the definition.
#pragma once

#include <cstdint>

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// min over shared entries of the sum over quadrants of min over transforms and own pairs of what 16 vectors
/// lose.  Every choice is tried, but for entries that another one replaces without loss: an entry is left out
/// of a quadrant under a transform, or of the shared ones, where another loses no more of any vector there.
/// Counted region by region on the specification's vectors; nothing of impl's sets or bounds.
/// Domain: every map; takes time with the square of the kinds of vectors, and more.
std::uint32_t least_substitutions(const Map<Vq2>& map);

}  // namespace mmverify::proofs::vq
