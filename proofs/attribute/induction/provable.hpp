// The laws of orders that a prover settles for all levels at once.
#pragma once

#include "proofs/attribute/subject.hpp"
#include "proofs/induction/discharge.hpp"

namespace mmverify::proofs::attribute::induction {

using proofs::induction::Effort;
using proofs::induction::Provable;
using proofs::induction::Statement;

/// The statements of each law as they ship.
std::vector<Statement> shipped_w_minor();
std::vector<Statement> shipped_u_major();
std::vector<Statement> shipped_bird();
std::vector<Statement> shipped_faces();

/// attribute.w_minor_all_levels, u_major_all_levels, bird_all_levels and faces_all_levels.
std::vector<Law> laws();

/// The formulas with one thing wrong each: what the laws must not be able to prove.
std::vector<Mutant> mutants_of_w_minor();
std::vector<Mutant> mutants_of_u_major();
std::vector<Mutant> mutants_of_bird();
std::vector<Mutant> mutants_of_faces();

/// Every order by the specification's own parts, iterated as the mutants iterate theirs: equal to attribute-spec, or a
/// mutant's failure would say nothing of its part.
AttributeSubjectPtr specified_by_parts();

}  // namespace mmverify::proofs::attribute::induction
