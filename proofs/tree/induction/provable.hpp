// tree.all_levels, its statements and its mutants.
#pragma once

#include "proofs/induction/discharge.hpp"
#include "proofs/tree/subject.hpp"

namespace mmverify::proofs::tree::induction {

using proofs::induction::Effort;
using proofs::induction::Provable;
using proofs::induction::Statement;

/// Judges a subject by the statements about it, one case each.  Where one fails, looks for a map of levels
/// 0..2 on which the subject's bytes are not the specification's or a lookup is not the map's state.
Tally discharge(const std::vector<Statement>& statements, const TreeSubject& subject, const Run& run,
                const Effort& effort = {});

/// The statements about the specification, as they ship.
std::vector<Statement> shipped_all_levels();

Law all_levels_law();

/// The algorithms with one turn wrong each: what the law must not be able to prove.
std::vector<Mutant> mutants_of_all_levels();

/// Algorithms 1, 2 and 3 by the specification's own turns, iterated as the mutants iterate theirs: equal to
/// tree-spec, or a mutant's failure would say nothing of its turn.
TreeSubjectPtr specified_by_turns();

}  // namespace mmverify::proofs::tree::induction
