// The induction's hypothesis: the relation of the recursion's state to the reference's remaining words.
#pragma once

#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::induction {

using proofs::induction::Script;
using proofs::induction::Term;

/// Both algorithms' variables at one step.
struct State {
  Term u, v, w;     ///< the recursion's barycentrics, times M
  Term mid, top;    ///< the recursion's flips
  Term iu, iv, iw;  ///< the low bits of the reference's words that are still to come
  Term above;       ///< the prefix XOR of the finished bits
};

/// The place of the point on the current triangle: three cases that exclude each other.
enum class Place { hypotenuse, upright, middle };
inline constexpr Place places[] = {Place::hypotenuse, Place::upright, Place::middle};

const char* name(Place place);

/// Writes the definitions of the hypothesis into a script, before their first use.
void define_relation(Script& script);

/// The condition that `state` at scale M is in this place and related.
Term in_place(Place place, const Term& M, const State& state);
/// The condition that `state` at scale M is related, in any place.
Term related(const Term& M, const State& state);

/// Declares the names of a state.
State declare_state(Script& script);

}  // namespace mmverify::proofs::index::induction
