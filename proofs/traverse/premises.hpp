// What laws say of a combination before they ask a subject; of the flags alone, not by the specification's steps.
#pragma once

#include "spec/traverse/decision.hpp"

namespace mmverify::proofs::traverse {

/// T or UT: what is ignored where nothing is left unknown.
constexpr bool on_transparent_side(spec::micromap::State s) {
  return s == spec::micromap::State::T || s == spec::micromap::State::UT;
}

/// A micromap counts, and its answer leaves nothing unknown: a known state, or one that force-2-state reads.
constexpr bool certain(const spec::traverse::Combination& c) {
  return spec::traverse::consulted(c) &&
         (!spec::micromap::unknown(c.candidate.state) || spec::traverse::two_state_override(c));
}

/// The lookup ignores the candidate.
constexpr bool lookup_ignores(const spec::traverse::Combination& c) {
  return certain(c) && on_transparent_side(c.candidate.state);
}

/// Flags say that hits are opaque, the ray's before the instance's.
constexpr bool made_opaque(const spec::traverse::Combination& c) {
  return c.ray.opaque || (c.instance.force_opaque && !c.ray.no_opaque);
}
/// Flags say that they are not.
constexpr bool made_non_opaque(const spec::traverse::Combination& c) {
  return c.ray.no_opaque || (c.instance.force_no_opaque && !c.ray.opaque);
}

/// The ray drops hits by their opacity.
constexpr bool culls(const spec::traverse::Combination& c) {
  return c.ray.cull_opaque || c.ray.cull_no_opaque;
}

}  // namespace mmverify::proofs::traverse
