// A wrong subject that brings the statements about its own code.
#pragma once

#include "proofs/index/subject.hpp"
#include "proofs/induction/discharge.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::index::binary32 {

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
