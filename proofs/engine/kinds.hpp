// The kinds that cases are counted by.
#pragma once

#include "proofs/engine/result.hpp"

namespace mmverify::proofs {

/// The kind of a point by its place on the level's grid.  A whole micro-triangle, or a case that is no point, counts
/// as interior.
enum class Kind : std::uint8_t { vertex, edge, interior };
inline constexpr std::array<const char*, kinds> kind_names{"vertex", "edge", "interior"};

}  // namespace mmverify::proofs
