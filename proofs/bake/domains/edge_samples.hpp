// Samples whose states stand or fall with the last bits of a coordinate or of a margin.
#pragma once

#include "proofs/bake/cases/case.hpp"
#include "proofs/engine/random.hpp"

namespace mmverify::proofs::bake {

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

}  // namespace mmverify::proofs::bake
