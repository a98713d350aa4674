// Programs of others, run to their end.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mmverify::program {

/// There is no program of that name.
struct NoProgram : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a program may take.  A file that somebody hands it may keep it busy for ever.
struct Bounds {
  std::chrono::seconds time{1800};
  std::uint64_t memory = std::uint64_t{8} << 30;    ///< bytes of addresses
  std::uint64_t a_file = std::uint64_t{512} << 20;  ///< bytes of a file that it writes, or of what it says
};

struct ProgramEnd {
  bool succeeded = false;   ///< exit code 0
  bool by_itself = false;   ///< with an exit code, not by a signal nor for a bound
  std::string how;          ///< "exit code 1", "signal 9", "stopped after 30 s"
  std::string out, errors;  ///< what it said
};

/// Runs arguments[0], found on the PATH as a shell would, with these arguments and no shell between: no word of them is
/// interpreted.  Its standard input is `input`.
/// It ends where it takes more than it may.  `stop` is asked a hundred times a second, and once when it has ended; where it throws, the program is ended first.
/// Errors: NoProgram; std::runtime_error where it cannot be started, or there is no room for files or processes.
ProgramEnd run_program(const std::vector<std::string>& arguments, const std::string& input = {},
                       const std::function<void()>& stop = {}, const Bounds& bounds = {});

/// A program's complaints in one line, for a message.
std::string one_line(std::string text);

}  // namespace mmverify::program
