// The binary32 inputs that break row order.
#pragma once

#include "proofs/index/points.hpp"

namespace mmverify::proofs::index {

/// Sample number `sample` of the pairs that are hard for row order, always the same for one seed. Of two, one
/// is a pair of hard_floats; the other is, in turn, near one of the three lines that figure 4 takes floors at,
/// of numbers that a program has to round first:
///   u+v a hair from a row's line, its parts of any two sizes: what u+v rounds to, and 1-(1-(u+v));
///   u a few ulp from i/N: what 1-u rounds to;
///   u as small as any number is, beside v a few ulp from j/N: 1-u rounds to 1, u+v to v;
///   u+v and v a few ulp from lines, and so the corner of a row.
/// Lines near the w-corner come as often as others: there floats are finest, and a difference from 1 loses
/// most. Every pair has u, v >= 0 and u+v <= 1 + 2^-23.
FloatPair hard_rows(Level n, std::uint64_t seed, std::uint64_t sample);

}  // namespace mmverify::proofs::index
