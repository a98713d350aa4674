// Laws that a prover settles for all levels at once: how their statements are discharged.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"
#include "proofs/induction/prover.hpp"

namespace mmverify::proofs::induction {

/// A subject that brings the statements about it along: those of the one law that it is a mutant of.
class Provable {
 public:
  virtual ~Provable() = default;
  virtual std::vector<Statement> statements() const = 0;
};

/// Where to look for what a failed statement may be due to.
struct Search {
  std::function<std::vector<Counterexample>()> run;  ///< those of the lowest level that has any
  std::string where;                                 ///< "the cells of levels 0..6"
};

/// Judges a subject by the statements about it, one case each, and searches for a counterexample: statements
/// that hold prove nothing of a subject that is not what they are about.  Where a statement fails and there is
/// no counterexample, throws NotProved with the statement's name and the prover's answer.  `unknown` is a
/// failure.
Tally discharge(const std::vector<Statement>& statements, const Search& search, const Run& run,
                const Effort& effort = {});

}  // namespace mmverify::proofs::induction
