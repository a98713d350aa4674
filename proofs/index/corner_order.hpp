// In which order a subject gives corners.
#pragma once

#include <optional>
#include <string>

#include "proofs/index/cells.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The specification's corners of an index in that order; undeclared: as the specification has them.
/// Domain: index in [0, 4^n), n in 0..16.
Corners corners_in(CornerOrder order, std::uint32_t index, Level n);

/// The corners by i, then j: equal for two triples just where these are equal as sets.
Corners sorted(Corners c);

/// The micro-triangle of level n that these corners are, in any order; nothing where they are not one.
/// Domain: any numbers, n in 0..16.
std::optional<MicroTriangle> triangle_of(const Corners& c, Level n);

/// The order that the subject's corners of the first indices of a level are in, in words: "base, +u, +v", "children 0, 2,
/// 3", one of these rearranged, or that they are in none.
std::string name_corner_order(const IndexSubject& subject, Level n);

/// Why the law about a declared order does not apply: none is declared, and which one is found.
std::optional<std::string> declares_no_order(const Subject& subject, Level n);

/// What a subject that is refuted does instead.
std::vector<std::string> diagnose_corner_order(const Subject& subject, const Levels& levels);

}  // namespace mmverify::proofs::index
