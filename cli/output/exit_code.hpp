// The program's exit codes, part of the command line's contract.
#pragma once

#include <stdexcept>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

enum ExitCode : int {
  complete = 0,     ///< nothing refuted or broken
  failed = 1,       ///< refuted, broken, a surviving mutant, or a gate's regression
  usage = 2,        ///< also: no law, no case, or no law that applies
  interrupted = 3,  ///< incomplete: interrupted, or a prover settled a statement neither way
  environment = 4,  ///< a file or machine is not as it must be
};

/// The exit code of a run with this report.
ExitCode exit_code(const proofs::Report& report);

/// Ends a command with exit code 2; what() is the line printed.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UsageError, which gives the reason, if no case was judged: such a run is never a success.
void refuse_nothing(const proofs::Report& report);

/// Ends a command with exit code 4; what() is the line printed.
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace mmverify::cli
