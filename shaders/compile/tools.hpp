// Programs of others that make or read shaders.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace mmverify::shaders {

/// None where there is no such program.  A compiler takes a second; a file that includes itself would keep it for ever.
std::optional<program::ProgramEnd> ended(const std::vector<std::string>& words);

/// Errors: std::runtime_error that names the file.
std::string contents_of(const std::string& file);
void write_file(const std::string& file, const std::string& text);

}  // namespace mmverify::shaders
