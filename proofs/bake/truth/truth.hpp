// The true states of a case by the specification, and a point that shows each.
#pragma once

#include "proofs/bake/cases/case.hpp"

namespace mmverify::proofs::bake {

using spec::Rational;
using spec::micromap::State;
using TexturePoint = spec::bake::TexturePoint<Rational>;

/// The state of micro-triangle `index` by spec/bake/state.hpp.
State true_state(const Case& one, Level n, std::uint32_t index);
/// The states of all micro-triangles of a level, in the order of the curve.
std::vector<State> true_map(const Case& one, Level n);

/// The true states of some micro-triangles, with the cutoff less the slack and with the cutoff plus the slack.  Both
/// are the same without a slack.
struct Truth {
  std::vector<State> lower, upper;
};

/// The micro-triangles at which a sample of level n is judged: all up to level 3, 99 of them above.  A texture with a
/// side above 7 texels has 24, or fewer (8 at least) if margins and mips make each slow.  Among them are the
/// triangle's three corners, some spread evenly, and some that hold points drawn from the texture and a texel around
/// it, as far as the triangle has such; these depend on the case.
std::vector<std::uint32_t> judged_at(const Case& one, Level n);

/// The true states at judged_at(), remembered for later laws.
Truth true_states(const Case& one, Level n);
/// The true states at the given micro-triangles, not remembered.
Truth true_states(const Case& one, Level n, const std::vector<std::uint32_t>& at);

/// A place with the least or the greatest alpha on a closed micro-triangle, and that alpha.
struct Extreme {
  TexturePoint at;  ///< in texels of its mip
  Rational alpha;
  std::uint32_t mip = 0;
};
struct Extremes {
  Extreme least, greatest;
};
/// The extremes over the micro-triangle dilated by the margin, in all mips.
Extremes extremes(const Case& one, Level n, std::uint32_t index);

/// The corners of a micro-triangle, in texels of mip 0.
spec::bake::Polygon<Rational> corners_of(const Case& one, Level n, std::uint32_t index);

}  // namespace mmverify::proofs::bake
