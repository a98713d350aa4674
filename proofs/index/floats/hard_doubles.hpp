// The binary64 inputs that break index functions.
#pragma once

#include <cstdint>

#include "proofs/engine/result.hpp"

namespace mmverify::proofs::index {

struct DoublePair {
  double u, v;
};

/// Sample number `sample` of the hard doubles of a level, always the same for one seed. In turn:
///   both coordinates a few ulp from grid lines, so that binary32 would put them on the lines;
///   u+v a few ulp from a diagonal line; uf+vf a hair on either side of 1 with parts of very different size;
///   u+v a few ulp from 1; subnormals, -0, the corners and their neighbours; uniform points of 53 bits.
/// Every pair has u, v >= -0 and u+v <= 1 + 2^-52.
DoublePair hard_doubles(Level n, std::uint64_t seed, std::uint64_t sample);

}  // namespace mmverify::proofs::index
