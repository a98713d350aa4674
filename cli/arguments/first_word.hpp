// The command of a command line: `help`, misspelt commands and words, --level for --levels.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mmverify::cli {

/// The arguments, without the program's name, with a command that the program has: `help` is --help, `help COMMAND` is
/// COMMAND --help, and `version`, -V and -v are --version. If the command has only one of --level and --levels, the
/// other one stands for it.
/// Throws UsageError for an unknown command, with the command that was probably meant.
std::vector<std::string> with_known_command(CLI::App& program, std::vector<std::string> arguments);

/// "; did you mean '--subject'?" about the first option that the chosen command does not have; empty if none of
/// its options is near. Domain: after program.parse().
std::string meant_option(CLI::App& program);

/// "; did you mean 'tree'?" about CLI11's complaint that a word is "not in {index,tree}"; empty for others.
std::string meant_member(const std::string& complaint);

/// "; see `mmverify repair --help`", of the chosen command, or of the program.  Domain: after program.parse().
std::string see_help(CLI::App& program);

}  // namespace mmverify::cli
