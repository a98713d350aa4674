// The induction's hypothesis: how the recursion's state and the reference's remaining words belong together.
#pragma once

#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::induction {

using proofs::induction::Script;
using proofs::induction::Term;

/// Everything that the hypothesis speaks of, in one place.
struct State {
  Term u, v, w;     ///< the recursion's barycentrics, times M
  Term mid, top;    ///< its flips
  Term iu, iv, iw;  ///< the reference's words, their low bits that are still to come
  Term above;       ///< the prefix XOR of the bits that are done
};

/// Where the point lies on the current triangle: three cases that exclude each other.
enum class Place { hypotenuse, upright, middle };
inline constexpr Place places[] = {Place::hypotenuse, Place::upright, Place::middle};

const char* name(Place place);

/// Writes the definitions of the hypothesis into a script; before its use.
void define_relation(Script& script);

/// `state` at scale M is in this place and related.
Term in_place(Place place, const Term& M, const State& state);
/// `state` at scale M is related, in whichever place.
Term related(const Term& M, const State& state);

/// Declares a state's names.
State declare_state(Script& script);

}  // namespace mmverify::proofs::index::induction
