// The states that a law denies, and the words for one of them.
#pragma once

#include <optional>
#include <string>

#include "proofs/bake/truth/offender.hpp"
#include "proofs/engine/cases.hpp"

namespace mmverify::proofs::bake {

/// Whether a law denies a state, given the true states at the cutoff less the slack and at the cutoff plus the slack.
/// Both are the same without a slack.
using Denies = bool (*)(State got, State lower, State upper);

inline bool not_conservative(State got, State lower, State upper) {
  return (got == State::O && lower != State::O) || (got == State::T && upper != State::T);
}
inline bool not_tight(State got, State lower, State upper) {
  return spec::micromap::unknown(got) && (upper == State::O || lower == State::T);
}
inline bool wrong_side(State got, State lower, State upper) {
  using spec::micromap::force2;
  return spec::micromap::unknown(got) && force2(got) != force2(lower) && force2(got) != force2(upper);
}

/// The denied state with the simplest map: states that the law does not deny are replaced by right ones.
std::optional<Offender> offender_of(const Case& one, Level n, std::vector<State> got,
                                    const std::vector<std::uint32_t>& at, const Truth& truth, Denies denies);

/// "micro-triangle 0 T, alpha 32/255 at texel (0, 0)", and by how much, or that it is a tie; got is the wrong state.
Words words_of(const Case& one, Level n, const Offender& offender);

}  // namespace mmverify::proofs::bake
