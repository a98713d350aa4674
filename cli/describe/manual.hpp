// Writes the manual page from the description of the command line.
#pragma once

#include <string>

#include "cli/describe/description.hpp"

namespace mmverify::cli::describe {

/// The page in the macros of man(7), section 1. version: "0.2.0". date: "2025-03-01", or empty.
std::string manual(const Program& program, const std::string& version, const std::string& date);

}  // namespace mmverify::cli::describe
