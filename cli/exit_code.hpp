// How the program ends: part of the command line's contract.
#pragma once

#include <stdexcept>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

enum ExitCode : int {
  complete = 0,     ///< nothing refuted or broken
  failed = 1,       ///< refuted, broken, a surviving mutant, or a gate's regression
  usage = 2,        ///< also: no law, no case, nothing that applies
  interrupted = 3,  ///< incomplete
  environment = 4,  ///< a file or machine that is not as it must be
};

/// How a run with this report ends.
ExitCode exit_code(const proofs::Report& report);

/// Ends a command with exit code 2; what() is the line printed.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A run in which no case was judged is usage, never success: throws UsageError, which says why there was none.
void refuse_nothing(const proofs::Report& report);

/// Ends a command with exit code 4; what() is the line printed.
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::cli
