// Asks z3.
#pragma once

#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::induction {

/// What the prover may spend on one statement.
struct Effort {
  unsigned milliseconds = 60'000;
  unsigned steps = 0;  ///< z3's own count, the same on every machine; 0: no limit
};

struct Found {
  Answer answer = Answer::unknown;
  std::string detail;  ///< sat: the model's constants on one line; unknown: the prover's reason
};

/// z3's answer to the file's assertions. What z3 rejects, gives up or does not understand is `unknown`.
Found ask_z3(const Statement& statement, const Effort& effort = {});

/// "z3 4.8.12".
std::string prover_name();

}  // namespace mmverify::proofs::induction
