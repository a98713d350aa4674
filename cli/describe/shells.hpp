// Completions for shells, written from what the program takes.
#pragma once

#include <string>

#include "cli/describe/description.hpp"

namespace mmverify::cli::describe {

/// A script that completes the program's command line: commands, options, the words a value may be, and paths where it
/// names a file.  Bash 4 or later, without the package bash-completion; zsh 5; fish 3.
std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);
std::string fish_completion(const Program& program);

}  // namespace mmverify::cli::describe
