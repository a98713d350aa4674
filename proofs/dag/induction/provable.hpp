// dag.all_levels, its statements and its mutants.
#pragma once

#include "proofs/dag/subject.hpp"
#include "proofs/induction/discharge.hpp"

namespace mmverify::proofs::dag::induction {

using proofs::induction::Effort;
using proofs::induction::Provable;
using proofs::induction::Statement;

/// Judges a subject by the statements about it, one case each.  Where one fails, looks for a small scene of levels 3 and 4,
/// or a map of levels 5 to 7 whose root has 16 or 4 different children, of which the subject's container is not the
/// specification's or a lookup is not the map's state.
Tally discharge(const std::vector<Statement>& statements, const DagSubject& subject, const Run& run,
                const Effort& effort = {});

/// The statements about the specification, as they ship.
std::vector<Statement> shipped_all_levels();

Law all_levels_law();

/// The specification with one decision wrong each: what the law must not be able to prove.
std::vector<Mutant> mutants_of_all_levels();

/// Graphs built and looked up by the specification's own decisions, in the way in which the mutants are: equal to dag-spec, or
/// a mutant's failure would say nothing of its decision.
DagSubjectPtr specified_by_rules();

}  // namespace mmverify::proofs::dag::induction
