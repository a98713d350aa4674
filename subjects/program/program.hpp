// Runs other programs to their end.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mmverify::program {

/// No program has that name.
struct NoProgram : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Bounds on a program: a hostile file may keep it busy for ever.
struct Bounds {
  std::chrono::seconds time{1800};
  std::uint64_t memory = std::uint64_t{8} << 30;    ///< bytes of address space
  std::uint64_t a_file = std::uint64_t{512} << 20;  ///< bytes of a file that it writes, its output included
};

struct ProgramEnd {
  bool succeeded = false;   ///< exit code 0
  bool by_itself = false;   ///< it exited by itself: no signal, no bound ended it
  std::string how;          ///< "exit code 1", "signal 9", "stopped after 30 s"
  std::string out, errors;  ///< standard output and standard error
};

/// Runs arguments[0], found on the PATH, with these arguments and without a shell: no word is interpreted.
/// Its standard input is `input`.
/// It is ended when it exceeds `bounds`. `stop` is called every 10 ms, and once after the end; if it throws,
/// the program is ended first. `heard` is called with each part of the standard output as it comes.
/// Errors: NoProgram; std::runtime_error if it cannot be started, or there is no room for files or processes.
ProgramEnd run_program(const std::vector<std::string>& arguments, const std::string& input = {},
                       const std::function<void()>& stop = {}, const Bounds& bounds = {},
                       const std::function<void(const std::string&)>& heard = {});

/// The text in one line, for a message.
std::string one_line(std::string text);

}  // namespace mmverify::program
