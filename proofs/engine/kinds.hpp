// The names that cases are counted by.
#pragma once

#include <array>

#include "proofs/engine/result.hpp"

namespace mmverify::proofs {

/// Where a point lies on the level's grid.  What is no point, or a whole micro-triangle, counts as interior.
enum class Kind : std::uint8_t { vertex, edge, interior };
inline constexpr std::array<const char*, kinds> kind_names{"vertex", "edge", "interior"};

}  // namespace mmverify::proofs
