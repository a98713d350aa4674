// The lemmas of index.floats: from every pair of binary32 numbers to the index of the exact reference, step by step.
#pragma once

#include "proofs/index/binary32/steps.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::binary32 {

using proofs::induction::Statement;

/// The statements of a code's first steps, each for every input: `scale`, `parts`, `carry`, `flush`.
std::vector<Statement> first_statements_about(const Steps& steps);
/// The statements of a code's other steps, up to the index on the curve: `square`, `curve`.
std::vector<Statement> statements_about(const Steps& steps);

/// The statements that all codes share: the side as a float, the reference's whole parts, and for each hypothesis an
/// input that fulfils it.
std::vector<Statement> common_statements();

/// The common statements of the first steps: the side as a float, and an input for their hypotheses.
std::vector<Statement> first_common_statements();

/// All statements of index.floats for a code that runs single values by `scalar` and vectors by `lanes`, 64-bit words
/// included.
std::vector<Statement> statements_of(const Steps& scalar, const Steps& lanes);

using proofs::induction::Statement;

/// The statements that index.floats has not: `more`, `rows`, and that their hypotheses can be fulfilled.
std::vector<Statement> own_row_statements(const Steps& scalar, const Steps& lanes);

/// All that index.row_floats rests on: those, and the statements of index.floats about the first steps.
std::vector<Statement> row_statements_of(const Steps& scalar, const Steps& lanes);

}  // namespace mmverify::proofs::index::binary32
