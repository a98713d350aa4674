// What the specification says of a case: the state of each micro-triangle, and a point that shows it.
#pragma once

#include <optional>
#include <vector>

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

using spec::Rational;
using spec::micromap::State;
using Place = spec::bake::Place<Rational>;

/// The state of micro-triangle `index` by spec/bake/state.hpp.
State true_state(const Case& one, Level n, std::uint32_t index);

/// The true states of some micro-triangles, twice where the case has a slack: with the cutoff less that, and with
/// the cutoff and that.  Without a slack the two are the same.
struct Truth {
  std::vector<State> lower, upper;
};

/// The micro-triangles that a sample of level n is judged at: all up to level 3, above 96 of them.  Of
/// textures of more than 7 texels a side 24 and fewer (8 at least) where margins and mips make each one
/// long work, or all that there are.  Among them the three corners of the triangle, some spread evenly, and
/// some, other ones for another case, that hold points drawn from the texture and a texel around it, as far
/// as the triangle has such.
std::vector<std::uint32_t> judged_at(const Case& one, Level n);

/// Those states, remembered for the next law that asks.
Truth true_states(const Case& one, Level n);
/// The states there, not remembered.
Truth true_states(const Case& one, Level n, const std::vector<std::uint32_t>& at);

/// Where alpha is least or greatest on a closed micro-triangle, and what it is there.
struct Extreme {
  Place at;  ///< in texels of its mip
  Rational alpha;
  std::uint32_t mip = 0;
};
struct Extremes {
  Extreme least, greatest;
};
/// Over the micro-triangle dilated by the margin, in all mips.
Extremes extremes(const Case& one, Level n, std::uint32_t index);

/// The corners of a micro-triangle, in texels of mip 0.
spec::bake::Polygon<Rational> corners_of(const Case& one, Level n, std::uint32_t index);

}  // namespace mmverify::proofs::bake
