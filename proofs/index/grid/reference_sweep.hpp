// The oracle on many points, compiled for several vector widths.
#pragma once

#include <span>

#include "proofs/engine/sweep.hpp"
#include "proofs/index/points.hpp"

namespace mmverify::proofs::index {

/// out[t] = spec::index::reference(points[t], n), the specification's own text.
/// Domain: points of Fixed64; n in 0..16; out as long as points.
void reference_batch(Level n, std::span<const GridPoint> points, std::span<std::uint32_t> out);

/// The same on the representatives of rows of `grid`, one row after the other, in 32-bit words where these
/// hold every sum (docs/SOUNDNESS.md, "No sum overflows").
/// Domain: n, grid in 0..16; out as long as the rows together.  Law: index.sweep_is_spec.
void reference_rows(Level n, Level grid, std::span<const Row> rows, std::span<std::uint32_t> out);

/// spec::index::reference_wide on the representatives of a row of level n.
/// Domain: n in 0..28; out as long as the row.
void reference_wide_row(Level n, const Row& row, std::span<std::uint64_t> out);

/// out[t] = spec::index::step<printed>(p[t], n) for points p equally spaced from first to last on a line of
/// constant v.
/// Each branch of next_step is taken on a convex set and maps it affinely, so two ends of a segment that take
/// the same branches carry every point between them along, evenly spaced (docs/SOUNDNESS.md, "Rows"). Ends
/// that part split the segment. The last few levels are read from a table that next_step filled in.
/// Domain: points k/(4 2^g) of the triangle, g <= n+1; n in 0..16; out not empty.  Law: index.sweep_is_spec.
void step_row(Level n, const GridPoint& first, const GridPoint& last, std::span<std::uint32_t> out);

/// Every cell of the level by itself: its point, Algorithm 4 on it, the reference on it, compared. In 64-bit
/// fixed point, on all threads of the run. The same counts and digest as the law's.
/// Domain: n in 0..16.
Tally plain_sweep(Level n, const Run& run);

}  // namespace mmverify::proofs::index
