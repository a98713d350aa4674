// The maps and blocks that encoders are tried on.
#pragma once

#include "proofs/engine/random.hpp"
#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// The vector (vector % 8, vector / 8) of a map.
template <class Format>
Vector<Format::side> vector_of(const Map<Format>& map, std::uint32_t vector);
template <class Format>
void put(Map<Format>& map, std::uint32_t vector, const Vector<Format::side>& v);

/// Sample k of a seed, the same everywhere: shapes with a wide outline, with O beside T, two at once, a
/// quadrant repeated and turned; in each 32, a uniform map, two with one odd region, two of a few vectors
/// repeated and turned, two of one vector or of two in turn, four that are a block's but for up to three regions, and
/// noise, which takes encoders longest.
template <class Format>
Map<Format> sample_map(std::uint64_t seed, std::uint64_t k);

/// Block k of a seed: its transforms are triple k mod 512.  In turn, 512 of each: its indices are a few of each
/// quadrant's own, or in one of 4 blocks any; of VQ4 any, of VQ2 some or all entries of a quadrant, two quadrants with
/// an entry in common; then of VQ2 twice all entries, each another.  One in four of the
/// first kind of VQ2 uses one to three entries in all.
template <class Format>
Format sample_block(std::uint64_t seed, std::uint64_t k);

/// min over shared entries of the sum over quadrants of min over transforms and own pairs of what 16 vectors
/// lose.  Every choice is tried, but for entries that another one replaces without loss: an entry is left out
/// of a quadrant under a transform, or of the shared ones, where another loses no more of any vector there.
/// Counted region by region on the specification's vectors; nothing of impl's sets or bounds.
/// Domain: every map; takes time with the square of the kinds of vectors, and more.
std::uint32_t least_substitutions(const Map<Vq2>& map);

}  // namespace mmverify::proofs::vq
