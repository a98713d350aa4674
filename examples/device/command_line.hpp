// The command line of device_rays.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include "job.hpp"

namespace rays {

extern const char* const help;

struct Options {
  std::string vectors;
  std::optional<std::uint32_t> device;
  std::uint32_t first = 0, last = most_level;
  double error = 0x1p-20;
  bool validate = false;
};

/// The command line is wrong; what() names the word.
struct Usage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Nothing where the words ask for help.  Throws Usage.
std::optional<Options> options_of(int count, char** words);

}  // namespace rays
