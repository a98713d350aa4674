// The oracle on many points, compiled for several vector widths.
#pragma once

#include <span>

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

}  // namespace mmverify::proofs::index
