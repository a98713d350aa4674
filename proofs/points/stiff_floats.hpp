// The binary32 inputs that break index functions.
#pragma once

#include <cstdint>

#include "proofs/engine/result.hpp"

namespace mmverify::proofs::points {

struct FloatPair {
  float u, v;
};

/// Sample number `sample` of the stiff floats of a level, always the same for one seed. In turn:
///   both coordinates a few ulp from grid lines, of this level or another; u+v a few ulp from a diagonal
///   line; uf+vf a hair on either side of 1 with parts of very different size; u+v a few ulp from 1;
///   subnormals, -0, the corners and their neighbours; a coordinate of any size beside one at a line, or, as a
///   control, uniform points.
/// Every pair has u, v >= -0 and u+v <= 1 + 2^-23: hits on the hypotenuse do come one ulp over.
FloatPair stiff_floats(Level n, std::uint64_t seed, std::uint64_t sample);

}  // namespace mmverify::proofs::points
