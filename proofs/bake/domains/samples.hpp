// Drawn cases, many of them stiff.
#pragma once

#include "proofs/bake/cases/case.hpp"
#include "proofs/engine/random.hpp"

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

/// The samples with all features on triangles that move: by 0, by 2^-9 to 1 repeat, or by 3, along each axis on its own.
Case moving_sample(std::uint64_t seed, std::uint64_t k);
const char* moving_samples_text();

/// The samples with all features, every second one a larger texture, of which a box of each mip, drawn on its own, had other texels; every second mip or so
/// had the same.  Every third sample moves.
Case changed_sample(std::uint64_t seed, std::uint64_t k);
const char* changed_samples_text();

/// Samples with larger textures, of up to 24x24 texels, discs and noise, on triangles within [-1, 1]^2.
Case large_sample(std::uint64_t seed, std::uint64_t k);
const char* large_samples_text();

/// Stripes a texel wide, 0 and 1, and the cutoff 1/2: bilinear and nearest alpha meet it at the lines between stripes.
/// Within a stripe lies a small triangle, whose first corner alone crosses such a line, by one step of binary32; at the
/// line through 0, where steps are smaller than any other number's, by 2^-20 to 2^-149.  Whoever adds a period to a
/// coordinate, or multiplies it by a size in floats, loses the step.
void cross_a_line_by_a_step(Random& random, Case& one);

/// The same stripes and triangle, but the first corner lies a margin away from the line, and 2^-9 to 2^-18 of a texel more
/// or less.  The margin has 24 bits, 2^-7 to 1/4 texel.  Whoever rounds margins to coarser steps errs.
void reach_a_line_by_the_margin(Random& random, Case& one);

/// A saddle of four texels and a triangle without area on its diagonal, where alpha rises to a crest, or falls to a
/// valley, in the middle of an edge; the cutoff is 2^-3 to 2^-20 of a step of 8 bits below the crest, or above the valley.
/// Whoever looks at an edge's ends, or takes a small bulge for none, errs.
void cross_the_cutoff_within_an_edge(Random& random, Case& one);

/// The sides 1 to 128, the primes up to 521, and 2^k - 1 and 2^k + 1 up to 16383.
std::uint64_t side_count();

/// Sample k of a level: a texture of side number k / distances along one axis and one texel along the other, of one alpha
/// but for its first or its last texel; a triangle within the texel, or the cell, where the texture begins again: one
/// repeat away, one to eight on the other side, up to 1,024, and as many as a coordinate in binary32 can tell.
/// One case of 4 is mirrored; half are sampled nearest.
inline constexpr std::uint64_t distances = 4;
Case side_sample(std::uint64_t seed, std::uint32_t level, std::uint64_t k);
const char* side_samples_text();

}  // namespace mmverify::proofs::bake
