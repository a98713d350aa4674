// Drawn cases of long triangles: a micro-triangle spans 2^8 to 2^20 texels along an axis.
#pragma once

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

/// Sample k of a level, the same everywhere: textures of up to 32x32 texels of 8 bits, any addressing and filter, MASK.
/// The box of a micro-triangle has 2^8 to 2^20 texels along each axis, drawn apart, and up to 4 more or fewer; in a
/// quarter of the samples the same power and difference along both, so that a product of 32 bits wraps to few.
Case span_sample(std::uint64_t seed, Level n, std::uint64_t k);
const char* span_samples_text();

/// A sample that repeats along both axes, whose micro-triangles hold each a whole period of the texture: legs along
/// the axes, of two periods and more, in coordinates that whole periods can be added to.
Case whole_period_sample(std::uint64_t seed, Level n, std::uint64_t k);
const char* whole_period_samples_text();

}  // namespace mmverify::proofs::bake
