// Factors and cutoffs of stratified samples: where alpha meets the cutoff exactly, by a hair, or only in rounded
// arithmetic.
#pragma once

#include <cstdint>

#include "proofs/bake/cases/case.hpp"
#include "proofs/engine/random.hpp"

namespace mmverify::proofs::bake {

/// 0 and the greatest that is stored; of binary32 -2 and 3.
std::uint32_t lowest(Texel texel);
std::uint32_t highest(Texel texel);
/// The stored number so many steps on, no further than the two.  Domain: a number within them; of binary32 not -0.
std::uint32_t stepped(Texel texel, std::uint32_t stored, int steps);
/// Of binary32 in (0, 1].
std::uint32_t any_texel(Texel texel, Random& random);
/// For choices; rounded.
double value_of(Texel texel, std::uint32_t stored);

/// Factors by their kinds (`factor_of`, `vertex_of`).
void set_factors(Case& one, std::uint8_t factor, std::uint8_t vertex, Random& random);

inline constexpr std::uint8_t cutoff_kinds = 11;
/// Cutoff or BLEND, by the kind: 1/2; a texel's value; a texel's alpha exactly; between a texel's alpha and
/// what it is in binary32, or in binary64; 0; 1; above 1; the alpha over a denominator near 2^32; a hair
/// beside a texel's value, as binary32 cannot say it; 1/3; BLEND.  Where a kind has no answer in 32-bit
/// words, the texel's value. Returns the texel that stands at the cutoff, by its bits: the least whose
/// alpha is at it or above, or near that. Domain: the texel's type and the factors are set.
std::uint32_t set_cutoff(Case& one, std::uint8_t kind, Random& random);

}  // namespace mmverify::proofs::bake
