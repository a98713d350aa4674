// Laws index.floats, index.row_floats and index.published_differs_where, proved for every pair of binary32 numbers.
#pragma once

#include "proofs/index/subject.hpp"
#include "proofs/induction/discharge.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::binary32 {

/// The statements as shipped.
std::vector<proofs::induction::Statement> shipped();
std::vector<proofs::induction::Statement> shipped_published();
std::vector<proofs::induction::Statement> shipped_rows();

/// The law that impl's index is that of the exact reference.
Law law();
/// The law that impl's index in row order is that of figure 4.
Law row_law();
/// The law of the pairs on which the published code's index is not exact.
Law published_law();

/// Mutants of law(): codes with one wrong step, each plausible in some arithmetic.
std::vector<Mutant> mutants();

class WithStatements : public IndexSubject, public proofs::induction::Provable {
 public:
  using Statements = std::vector<proofs::induction::Statement> (*)();
  WithStatements(const char* name, Functions functions, Statements statements)
      : IndexSubject(name, "broken on purpose", std::move(functions)), statements_(statements) {}
  std::vector<proofs::induction::Statement> statements() const override { return statements_(); }

 private:
  Statements statements_;
};

}  // namespace mmverify::proofs::index::binary32
