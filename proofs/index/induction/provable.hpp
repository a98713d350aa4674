// The laws of topic index that a prover settles for all levels at once: how their statements are discharged.
#pragma once

#include "proofs/index/subject.hpp"
#include "proofs/induction/discharge.hpp"

namespace mmverify::proofs::index::induction {

using proofs::induction::Effort;
using proofs::induction::Provable;
using proofs::induction::Statement;

/// Judges a subject by the statements about it, one case each. Where one fails, looks for a point on which
/// the subject is not the reference, on the cells of levels 0..search: the counterexample. Where there is
/// none, throws NotProved with the statement's name and the prover's answer. `unknown` is a failure.
Tally discharge(const std::vector<Statement>& statements, const IndexSubject& subject, Level search,
                const Run& run, const Effort& effort = {});

/// The statements of each of the laws below as they ship.
std::vector<Statement> shipped_all_levels();
std::vector<Statement> shipped_wide_is_vulkan();
std::vector<Statement> shipped_impl_wide();

/// index.all_levels, index.wide_is_vulkan and index.impl_wide_is_wide.
std::vector<Law> laws();

std::vector<Mutant> mutants_of_all_levels(Level search);
std::vector<Mutant> mutants_of_wide_is_vulkan(Level search);
std::vector<Mutant> mutants_of_impl_wide(Level search);

}  // namespace mmverify::proofs::index::induction
