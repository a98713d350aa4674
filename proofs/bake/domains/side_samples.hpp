// Textures of every side, seen where they begin again.
#pragma once

#include <cstdint>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// The sides 1 to 128, the primes up to 521, and 2^k - 1 and 2^k + 1 up to 16383.
std::uint64_t side_count();

/// Sample k of a level: a texture of side number k / distances along one axis and one texel along the other, of one alpha
/// but for its first or its last texel; a triangle within the texel, or the cell, where the texture begins again: one
/// repeat away, one to eight on the other side, up to 1,024, and as many as a coordinate in binary32 can tell.
/// Of each 4 cases one is mirrored; half are sampled nearest.
inline constexpr std::uint64_t distances = 4;
Case side_sample(std::uint64_t seed, std::uint32_t level, std::uint64_t k);
const char* side_samples_text();

}  // namespace mmverify::proofs::bake
