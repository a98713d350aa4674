// The command of a command line: `help`, misspelt commands, --level for --levels.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mmverify::cli {

/// The arguments, without the program's name, with a command that the program has: `help` is --help, and `help
/// COMMAND` is COMMAND --help. If the command has only one of --level and --levels, the other one stands for it.
/// Throws UsageError for an unknown command, with the command that was probably meant.
std::vector<std::string> with_known_command(CLI::App& program, std::vector<std::string> arguments);

/// "; did you mean '--subject'?" about the first option that the chosen command does not have; empty if none of
/// its options is near. Domain: after program.parse().
std::string meant_option(CLI::App& program);

}  // namespace mmverify::cli
