// Prints proofs/statements.lock: the provers' statements, their SHA-256 and the steps that z3 takes.  ./run statements calls it.
#include <fmt/format.h>

#include "proofs/induction/prover.hpp"
#include "proofs/registry/registry.hpp"
#include "subjects/shaders/compile/sha256.hpp"

int main() {
  using namespace mmverify;
  fmt::print("# statement  SHA-256 of its text  steps of {}\n", proofs::induction::prover_name());
  for (const auto& [path, statement] : proofs::shipped_statements())
    fmt::print("{} {} {}\n", path, shaders::sha256(statement.text),
               proofs::induction::ask_z3(statement).steps);
  return 0;
}
