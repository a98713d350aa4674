// The provers' statements that ship: every one that a law on all levels or on every float leaves to a prover.
#pragma once

#include <map>
#include <string>

#include "proofs/induction/statement.hpp"

namespace mmverify::proofs {

/// Statements by FOLDER/NAME, a folder a law: "index/floats/index".  proofs/statements.lock has the SHA-256 of each text and
/// the steps that z3 takes to settle it; `mmverify list --statements DIR` writes the texts.
std::map<std::string, induction::Statement> shipped_statements();

}  // namespace mmverify::proofs
