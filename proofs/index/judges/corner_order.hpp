// The order in which a subject gives corners.
#pragma once

#include <optional>
#include <string>

#include "proofs/index/points.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The specification's corners of an index in that order; for `undeclared` in the specification's own order.
/// Domain: index in [0, 4^n), n in 0..16.
Corners corners_in(CornerOrder order, std::uint32_t index, Level n);

/// The corners sorted by i, then j, so that two triples are equal if and only if they are equal as sets.
Corners sorted(Corners c);

/// The micro-triangle of level n with these corners, in any order; nothing if they do not form one.
/// Domain: any numbers, n in 0..16.
std::optional<MicroTriangle> triangle_of(const Corners& c, Level n);

}  // namespace mmverify::proofs::index
