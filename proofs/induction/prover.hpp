// The interface to the prover z3.
#pragma once

#include <cstdint>

#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::induction {

/// Whether this build has z3, and a message for a build without it.
bool has_prover();
std::string no_prover_text();

/// The effort that the prover may spend on one statement.  z3 counts steps, and a statement takes the same number of
/// them on every machine, so a slow or a busy one settles the same statements.  Four million steps take about a
/// second; the longest of our statements takes sixteen million.
struct Effort {
  unsigned milliseconds = 300'000;  ///< wall clock; ends work that takes time without steps
  unsigned steps = 250'000'000;     ///< 0: no limit
};

struct ProverAnswer {
  Answer answer = Answer::unknown;
  std::string detail = {};  ///< sat: the model's constants on one line; unknown: the prover's reason
  std::uint64_t steps = 0;  ///< the steps that z3 took
};

/// z3's answer to the file's assertions.  A statement that z3 rejects or gives up on is `unknown`.
ProverAnswer ask_z3(const Statement& statement, const Effort& effort = {});

/// An answer, and for sat the model's words of up to 64 bits by their names.
struct Solved {
  Answer answer = Answer::unknown;
  std::string reason = {};  ///< unknown: the prover's reason
  std::map<std::string, std::uint64_t> values = {};
};

/// z3's answer to a statement of words, for runs of thousands of them: uses z3's solver for such words, and sets up
/// less for each.
Solved ask_words(const Statement& statement, const Effort& effort = {});

/// The prover's name, such as "z3 4.8.12".
std::string prover_name();

}  // namespace mmverify::proofs::induction
