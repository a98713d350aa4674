// Bakers that take a question for the last one, which had one thing otherwise: the mutants of bake.asked_in_turn.
#pragma once

#include <vector>

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

/// One for each thing that a question has besides its texels.
std::vector<Mutant> forgetful_mutants();

}  // namespace mmverify::proofs::bake
