// index.floats: impl's index of every pair of binary32 numbers is that of the exact reference.
#pragma once

#include "proofs/index/subject.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::binary32 {

/// The statements as they ship.
std::vector<proofs::induction::Statement> shipped();

Law law();

/// Codes with one step wrong, each in an arithmetic that looks right.
std::vector<Mutant> mutants();

}  // namespace mmverify::proofs::index::binary32
