// Writes completions for shells from the description of the command line.
#pragma once

#include <string>

#include "cli/describe/description.hpp"

namespace mmverify::cli::describe {

/// A script that completes the command line: commands, options, the words that a value may be, and paths if
/// it names a file. Bash 4 or later, without the package bash-completion; zsh 5; fish 3.
std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);
std::string fish_completion(const Program& program);

}  // namespace mmverify::cli::describe
