// The decisions of building a graph and of lookups, so that a mutant can have one of them wrong: as the specification has
// them, here.
#pragma once

#include "proofs/dag/subject.hpp"

namespace mmverify::proofs::dag::induction {

struct Specified : spec::dag::Rules {
  template <class Store, class Part, class NextDigit>
  static bool lookup_turn(const Store& store, Part& at, const NextDigit& next_digit) {
    return spec::dag::lookup_turn(store, at, next_digit);
  }
};

}  // namespace mmverify::proofs::dag::induction
