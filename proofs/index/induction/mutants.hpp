// The bit formula with one thing wrong each: what the two laws must not be able to prove.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::index::induction {

std::vector<Mutant> mutants_of_all_levels(Level search);
std::vector<Mutant> mutants_of_wide_is_vulkan(Level search);
std::vector<Mutant> mutants_of_impl_wide(Level search);

}  // namespace mmverify::proofs::index::induction
