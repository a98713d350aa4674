// index.floats, index.row_floats and index.published_differs_where: what is proved of every pair of binary32 numbers.
#pragma once

#include "proofs/index/subject.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::binary32 {

/// The statements as they ship.
std::vector<proofs::induction::Statement> shipped();
std::vector<proofs::induction::Statement> shipped_published();
std::vector<proofs::induction::Statement> shipped_rows();

/// impl's index is that of the exact reference.
Law law();
/// And its index in row order that of figure 4.
Law row_law();
/// Where the published code's index is not exact.
Law published_law();

/// For the first: codes with one step wrong, each in an arithmetic that looks right.
std::vector<Mutant> mutants();

}  // namespace mmverify::proofs::index::binary32
