// The lemmas of index.row_floats: from the parts of two binary32 numbers on, to row order.
#pragma once

#include "proofs/index/binary32/steps.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::binary32 {

using proofs::induction::Statement;

/// The statements that index.floats has not: `more`, `rows`, and that their hypotheses can be fulfilled.
std::vector<Statement> own_row_statements(const Steps& scalar, const Steps& lanes);

/// All that index.row_floats rests on: those, and the statements of index.floats about the first steps.
std::vector<Statement> row_statements_of(const Steps& scalar, const Steps& lanes);

}  // namespace mmverify::proofs::index::binary32
