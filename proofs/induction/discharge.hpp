// The discharge of statements, for laws that a prover settles for all levels at once.
#pragma once

#include "proofs/engine/law.hpp"
#include "proofs/induction/prover.hpp"

namespace mmverify::proofs::induction {

/// A subject with statements about itself, for the one law that it is a mutant of.
class Provable {
 public:
  virtual ~Provable() = default;
  virtual std::vector<Statement> statements() const = 0;
};

/// The search for a counterexample after a failed statement.
struct Search {
  std::function<std::vector<Counterexample>()> run;  ///< the counterexamples of the lowest level that has any
  std::string where;                                 ///< "the cells of levels 0..6"
};

/// Judges a subject by the statements about it, one case each, and searches for a counterexample: valid statements
/// prove nothing about a subject that differs from their formulas.  If a statement fails and there is no
/// counterexample, throws NotProved with the statement's name and the prover's answer.  `unknown` is a failure.
Tally discharge(const std::vector<Statement>& statements, const Search& search, const Run& run,
                const Effort& effort = {});

/// A built-in subject, and the statements about it.
struct About {
  std::string subject;
  std::vector<Statement> (*statements)();
};
/// Judges a subject by statements.
using Settle = std::function<Tally(const std::vector<Statement>&, const Subject&, const Run&)>;

/// The law with a case for each statement: a subject's own where it brings some, else those about it in `known`.  It
/// fits no subject without.  A mutant is searched first, and proved nothing of if the search refutes it.  Domain: lists in `known` of one length, which is each subject's own list's, too.
Law on_statements(Law law, std::vector<About> known, Settle settle);

}  // namespace mmverify::proofs::induction
