// Describes the command line as its parser has it, for the manual page and shells' completions.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mmverify::cli::describe {

struct Option {
  std::vector<std::string> names;  ///< "-o" and "--output"; a positional has one name without dashes
  std::string value;               ///< "A..B", "FILE|-"; empty for a flag
  std::vector<std::string> words;  ///< the possible values, if they are a list
  std::string says;
  bool takes_value = false, many = false, required = false;
};

struct Command {
  std::string name, says, more;  ///< more: the last part of --help
  std::vector<Option> options, positionals;
};

struct Program {
  std::string name, says;
  std::vector<Option> options;
  std::vector<Command> commands;
};

/// The commands and options in the order of --help, without hidden ones.
/// Domain: a program whose commands have no subcommands.
Program described(const CLI::App& program);

/// Whether the name of a value stands for a path: "FILE|-", "OUT.glb", "NAME|FILE.so", "FOLDER", but not
/// "A..B".
bool is_path(const std::string& value);

}  // namespace mmverify::cli::describe
