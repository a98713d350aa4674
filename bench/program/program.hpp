// Programs of others, run to their end.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mmverify::bench {

/// There is no program of that name.
struct NoProgram : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ProgramEnd {
  bool succeeded = false;   ///< exit code 0
  std::string how;          ///< "exit code 1", "signal 9"
  std::string out, errors;  ///< what it said
};

/// Runs arguments[0], found on the PATH as a shell would, with these arguments and no shell between: no word of them is
/// interpreted.  Its standard input is `input`.
/// `stop` is asked a hundred times a second, and once when it has ended; where it throws, the program is ended first.
/// Errors: NoProgram; std::runtime_error where it cannot be started, or there is no room for files or processes.
ProgramEnd run_program(const std::vector<std::string>& arguments, const std::string& input = {},
                       const std::function<void()>& stop = {});

}  // namespace mmverify::bench
