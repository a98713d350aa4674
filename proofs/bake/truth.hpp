// What the specification says of a case: the state of each micro-triangle, and a point that shows it.
#pragma once

#include <optional>
#include <vector>

#include "proofs/bake/case.hpp"

namespace mmverify::proofs::bake {

using spec::Rational;
using spec::micromap::State;
using Place = spec::bake::Place<Rational>;

/// The state of micro-triangle `index` by spec/bake_state.hpp.
State true_state(const Case& one, Level n, std::uint32_t index);

/// The micro-triangles of level n that samples are judged at: all up to level 3, then 64 of them.
const std::vector<std::uint32_t>& judged_at(Level n);

/// Those states, remembered for the next law that asks.
std::vector<State> true_states(const Case& one, Level n);

/// Where alpha is least or greatest on a closed micro-triangle, and what it is there.
struct Extreme {
  Place at;  ///< in texels of mip 0
  Rational alpha;
};
struct Extremes {
  Extreme least, greatest;
};
/// Of mip 0, over the micro-triangle dilated by the margin.
Extremes extremes(const Case& one, Level n, std::uint32_t index);

/// The corners of a micro-triangle, in texels of mip 0.
spec::bake::Polygon<Rational> corners_of(const Case& one, Level n, std::uint32_t index);

}  // namespace mmverify::proofs::bake
