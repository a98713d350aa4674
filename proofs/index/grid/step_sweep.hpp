// Algorithm 4 on a whole row of points at once, by the specification's own next_step.
#pragma once

#include <span>

#include "proofs/index/points.hpp"

namespace mmverify::proofs::index {

/// out[t] = spec::index::step<printed>(p[t], n) for points p equally spaced from first to last on a line of
/// constant v.
/// Each branch of next_step is taken on a convex set and maps it affinely, so two ends of a segment that take
/// the same branches carry every point between them along, evenly spaced (docs/SOUNDNESS.md, "Rows"). Ends
/// that part split the segment. The last few levels are read from a table that next_step filled in.
/// Domain: points k/(4 2^g) of the triangle, g <= n+1; n in 0..16; out not empty.  Law: index.sweep_is_spec.
void step_row(Level n, const GridPoint& first, const GridPoint& last, std::span<std::uint32_t> out);

}  // namespace mmverify::proofs::index
