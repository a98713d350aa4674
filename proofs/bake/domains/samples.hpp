// Drawn cases, many of them hostile.
#pragma once

#include <cstdint>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// Sample k of a seed, the same everywhere: textures of up to 7x7 texels of 8 bits, any addressing, bilinear, MASK.
/// Each 104 samples have 64 of the kinds k % 8: any; a sliver of 10^6 to 1; corners an ulp off texel lines; 10^6
/// repeats away; one alpha throughout, exactly at the cutoff or a step beside it; a line or a point; far below 0 or
/// turned over; many repeats, with few values of alpha.  16 have micro-vertices a hair beside lines, and every second
/// of these repeats the case before with other texels below its first row.  24 have one corner a step over a line, or
/// cross the cutoff within an edge.
Case sample(std::uint64_t seed, std::uint64_t k);

/// The samples' text in the domain of a law.
const char* samples_text();

/// The samples with all features: bilinear or nearest, MASK or BLEND, of 8 or 16 bits or binary32 (below 0 and above
/// 1, too), with factors, margins and a second mip.
Case featured_sample(std::uint64_t seed, std::uint64_t k);
const char* featured_samples_text();

/// Samples with larger textures, of up to 24x24 texels, discs and noise, on triangles within [-1, 1]^2.
Case large_sample(std::uint64_t seed, std::uint64_t k);
const char* large_samples_text();

}  // namespace mmverify::proofs::bake
