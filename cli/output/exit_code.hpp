// The program's exit codes, part of the command line's contract.
#pragma once

#include <array>
#include <stdexcept>
#include <string_view>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

enum ExitCode : int { complete = 0, failed = 1, usage = 2, interrupted = 3, environment = 4 };

/// The meaning of each code, in the words of the manual page and of docs/EXIT_CODES.md.
inline constexpr std::array<std::string_view, 5> exit_meanings{
    "done; nothing is refuted, broken or wrong",
    "what was judged is wrong: a law is refuted, a subject is broken, a mutant survived, a file has an "
    "error, or a "
    "baseline differs",
    "wrong usage: an unknown word or option, or a source or a shader that does not compile; or nothing was "
    "judged",
    "incomplete: interrupted, or a statement was neither proved nor refuted",
    "the environment: a file is missing, truncated, of another kind or not writable, or the machine lacks "
    "something",
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
