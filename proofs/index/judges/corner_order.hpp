// In which order a subject gives corners.
#pragma once

#include <optional>
#include <string>

#include "proofs/index/subject.hpp"
#include "proofs/points/cells.hpp"

namespace mmverify::proofs::index {

/// The specification's corners of an index in that order; undeclared: as the specification has them.
/// Domain: index in [0, 4^n), n in 0..16.
Corners corners_in(CornerOrder order, std::uint32_t index, Level n);

/// The corners by i, then j: equal for two triples just where these are equal as sets.
Corners sorted(Corners c);

/// The micro-triangle of level n that these corners are, in any order; nothing where they are not one.
/// Domain: any numbers, n in 0..16.
std::optional<MicroTriangle> triangle_of(const Corners& c, Level n);

}  // namespace mmverify::proofs::index
