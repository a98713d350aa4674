// Premises of the laws on combinations, from the flags only, not by the specification's steps.
#pragma once

#include "spec/traverse/decision.hpp"

namespace mmverify::proofs::traverse {

/// T or UT: the states that are ignored if no state is left unknown.
constexpr bool on_transparent_side(spec::micromap::State s) {
  return s == spec::micromap::State::T || s == spec::micromap::State::UT;
}

/// Whether a micromap counts and leaves nothing unknown: a known state, or one that force-2-state reads.
constexpr bool certain(const spec::traverse::Combination& c) {
  return spec::traverse::consulted(c) &&
         (!spec::micromap::unknown(c.candidate.state) || spec::traverse::two_state_override(c));
}

/// Whether the lookup ignores the candidate.
constexpr bool lookup_ignores(const spec::traverse::Combination& c) {
  return certain(c) && on_transparent_side(c.candidate.state);
}

/// Whether flags make hits opaque, the ray's before the instance's.
constexpr bool made_opaque(const spec::traverse::Combination& c) {
  return c.ray.opaque || (c.instance.force_opaque && !c.ray.no_opaque);
}
/// Whether flags make hits non-opaque.
constexpr bool made_non_opaque(const spec::traverse::Combination& c) {
  return c.ray.no_opaque || (c.instance.force_no_opaque && !c.ray.opaque);
}

/// Whether the ray drops hits by their opacity.
constexpr bool culls(const spec::traverse::Combination& c) {
  return c.ray.cull_opaque || c.ray.cull_no_opaque;
}

}  // namespace mmverify::proofs::traverse
