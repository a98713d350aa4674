// The distance of a point from a micro-triangle that it lies outside of.
#pragma once

#include "bench/index/inputs.hpp"
#include "bench/number_type.hpp"
#include "spec/index/index.hpp"

namespace mmverify::bench {

/// Whether three corners are those of a micro-triangle of the level's grid.
bool on_grid(const spec::index::Corners& corners, spec::Level n);

struct Distance {
  double heights;  ///< 1 is the height of a micro-triangle, whatever the base triangle's shape
  double ulp;      ///< of the number type, at the line that was crossed the furthest
};

/// The distance of the point beyond its worst side; zero in the closed micro-triangle.
///   heights = N max(0, a-u, b-v, u+v-c) for the upright one u >= a, v >= b, u+v <= c, and with all signs
///   turned for the inverted one;  ulp = heights / N / ulp(a), or b or c for that side
/// The line is never 0, since a point of the triangle cannot cross 0, so the ulp are never subnormal.
/// Computed exactly and rounded once for print.
/// Domain: a point of the closed triangle; on_grid(corners, n); n in 0..16.
Distance distance(const InputPoint& p, const spec::index::Corners& corners, spec::Level n,
                  const NumberType& numbers);

}  // namespace mmverify::bench
