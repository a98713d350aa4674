// The oracle on many points at once.
#pragma once

#include <span>

#include "proofs/index/cells.hpp"

namespace mmverify::proofs::index {

/// out[t] = spec::index::reference(points[t], n), the specification's own text, compiled for several vector
/// widths. Domain: points of Fixed64; n in 0..16; out as long as points.
void reference_batch(Level n, std::span<const GridPoint> points, std::span<std::uint32_t> out);

}  // namespace mmverify::proofs::index
