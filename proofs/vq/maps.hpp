// The maps and blocks that encoders are tried on.
#pragma once

#include <cstdint>

#include "proofs/engine/random.hpp"
#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// The vector (vector % 8, vector / 8) of a map.
template <class Format>
Vector<Format::side> vector_of(const Map<Format>& map, std::uint32_t vector);
template <class Format>
void put(Map<Format>& map, std::uint32_t vector, const Vector<Format::side>& v);

/// Sample k of a seed, the same everywhere: by k mod 8 a shape with a wide outline, one with O beside T, two
/// shapes, noise, a few vectors repeated and turned, a quadrant repeated and turned, a uniform map, one odd
/// region.
template <class Format>
Map<Format> sample_map(std::uint64_t seed, std::uint64_t k);

/// A map of few kinds of vectors, for whom every one costs time.
Map<Vq2> map_of_few_vectors(std::uint64_t seed, std::uint64_t k);

/// Block k of a seed: its transforms are triple k mod 512; by k / 512, a codebook of any words or of a few.
template <class Format>
Format sample_block(std::uint64_t seed, std::uint64_t k);

}  // namespace mmverify::proofs::vq
