// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

namespace mmverify::shaders {

struct Ran {
  bool found = false;    ///< false: there is no such program
  int exit_code = 0;     ///< 128 and more: a signal ended it
  std::string printed;   ///< on both its outputs
  bool stopped = false;  ///< a signal ended it, or it took more than it may
};

/// What a program may take: seconds of a processor; 1 GB of memory, 256 MB a file, 64 MB of words beside.
inline constexpr unsigned most_seconds = 30;

/// The first word is the program, looked for in PATH.  Throws std::runtime_error where no process can be had.
Ran run_program(const std::vector<std::string>& words);

}  // namespace mmverify::shaders
