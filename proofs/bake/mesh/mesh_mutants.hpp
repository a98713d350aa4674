// Bakers of meshes that are wrong on purpose.
#pragma once

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

std::vector<Mutant> conservative_mesh_mutants();
std::vector<Mutant> tight_mesh_mutants();
std::vector<Mutant> shared_mesh_mutants();
std::vector<Mutant> two_state_mesh_mutants();
std::vector<Mutant> record_mesh_mutants();
std::vector<Mutant> count_mesh_mutants();

}  // namespace mmverify::proofs::bake
