// Other programs that make or read shaders.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "subjects/program/program.hpp"

namespace mmverify::shaders {

/// Runs a program to its end; nothing if there is no such program. The memory bound is for hostile files: a
/// compiler takes some megabytes, but a file that includes itself would keep it for ever.
std::optional<program::ProgramEnd> ended(const std::vector<std::string>& words,
                                         std::uint64_t bytes_of_memory = std::uint64_t{1} << 30);

/// Errors: std::runtime_error, which names the file.
std::string contents_of(const std::string& file);
void write_file(const std::string& file, const std::string& text);

}  // namespace mmverify::shaders
