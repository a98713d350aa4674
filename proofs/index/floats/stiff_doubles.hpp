// The binary64 inputs that break index functions.
#pragma once

#include <cstdint>

#include "proofs/engine/result.hpp"
#include "proofs/index/points.hpp"

namespace mmverify::proofs::index {

struct DoublePair {
  double u, v;
};

/// Sample number `sample` of the stiff doubles of a level, always the same for one seed. In turn:
///   both coordinates a few ulp from grid lines, so that binary32 would put them on the lines;
///   u+v a few ulp from a diagonal line; uf+vf a hair on either side of 1 with parts of very different size;
///   u+v a few ulp from 1; subnormals, -0, the corners and their neighbours; uniform points of 53 bits.
/// Every pair has u, v >= -0 and u+v <= 1 + 2^-52.
DoublePair stiff_doubles(Level n, std::uint64_t seed, std::uint64_t sample);

/// Sample number `sample` of the pairs that are stiff for row order, always the same for one seed. Of two, one
/// is a pair of stiff_floats; the other is, in turn, near one of the three lines that figure 4 takes floors at,
/// of numbers that a program has to round first:
///   u+v a hair from a row's line, its parts of any two sizes: what u+v rounds to, and 1-(1-(u+v));
///   u a few ulp from i/N: what 1-u rounds to;
///   u as small as any number is, beside v a few ulp from j/N: 1-u rounds to 1, u+v to v;
///   u+v and v a few ulp from lines, and so the corner of a row.
/// Lines near the w-corner come as often as others: there floats are finest, and a difference from 1 loses
/// most. Every pair has u, v >= 0 and u+v <= 1 + 2^-23.
FloatPair stiff_rows(Level n, std::uint64_t seed, std::uint64_t sample);

}  // namespace mmverify::proofs::index
