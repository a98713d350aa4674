// Asks z3.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "proofs/induction/statement.hpp"

namespace mmverify::proofs::induction {

/// Whether this build has z3; why not, for a message.
bool has_prover();
std::string no_prover_text();

/// What the prover may spend on one statement.  z3 counts steps.  A statement takes the same number of them on every
/// machine, so a slow or a busy one settles the same statements.  Four million take about a second; the longest of our
/// statements takes sixteen million.
struct Effort {
  unsigned milliseconds = 300'000;  ///< wall clock: ends what takes time without steps
  unsigned steps = 250'000'000;     ///< 0: no limit
};

struct Found {
  Answer answer = Answer::unknown;
  std::string detail = {};  ///< sat: the model's constants on one line; unknown: the prover's reason
  std::uint64_t steps = 0;  ///< that z3 took
};

/// z3's answer to the file's assertions. What z3 rejects, gives up or does not understand is `unknown`.
Found ask_z3(const Statement& statement, const Effort& effort = {});

/// An answer, and where it is sat the model's words of up to 64 bits by their names.
struct Solved {
  Answer answer = Answer::unknown;
  std::string reason = {};  ///< unknown: the prover's
  std::map<std::string, std::uint64_t> values = {};
};

/// The same of a statement of words alone, for runs of thousands of them: z3's solver for such words, and less is made
/// anew for each.
Solved ask_words(const Statement& statement, const Effort& effort = {});

/// "z3 4.8.12".
std::string prover_name();

}  // namespace mmverify::proofs::induction
