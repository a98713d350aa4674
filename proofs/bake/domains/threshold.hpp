// Factors and cutoffs of stratified samples: alpha meets the cutoff exactly, differs by a hair, or meets it only in
// rounded arithmetic.
#pragma once

#include "proofs/bake/cases/case.hpp"
#include "proofs/engine/random.hpp"

namespace mmverify::proofs::bake {

/// The least and greatest stored numbers: 0 and the greatest code; of binary32 -2 and 3.
std::uint32_t lowest(Texel texel);
std::uint32_t highest(Texel texel);
/// The stored number `steps` further, between lowest() and highest().  Domain: a number within them; of binary32 not
/// -0.
std::uint32_t stepped(Texel texel, std::uint32_t stored, int steps);
/// The bits of any texel; of binary32 in (0, 1].
std::uint32_t any_texel(Texel texel, Random& random);
/// The value of a stored number, rounded; for choices only.
double value_of(Texel texel, std::uint32_t stored);

/// Sets the factors by their kinds (`factor_of`, `vertex_of`).
void set_factors(Case& one, std::uint8_t factor, std::uint8_t vertex, Random& random);

inline constexpr std::uint8_t cutoff_kinds = 11;
/// Sets the cutoff or BLEND by the kind: 1/2; a texel's value; a texel's alpha exactly; between a texel's alpha and
/// its rounded value in binary32, or in binary64; 0; 1; above 1; the alpha over a denominator near 2^32; a hair
/// beside a texel's value, which binary32 cannot hold; 1/3; BLEND.  A kind without a solution in 32-bit words becomes
/// the texel's value.
/// Returns the bits of the least texel whose alpha is at the cutoff or above, or near that.
/// Domain: the texel's type and the factors are set.
std::uint32_t set_cutoff(Case& one, std::uint8_t kind, Random& random);

}  // namespace mmverify::proofs::bake
