// What the program takes, as its own reader of arguments has it: the source of the manual page and of shells' completions.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mmverify::cli::describe {

struct Option {
  std::vector<std::string> names;  ///< "-o" and "--output"; of a positional its name alone, without dashes
  std::string value;               ///< "A..B", "FILE|-"; empty of a flag
  std::vector<std::string> words;  ///< what a value may be, where that is a list
  std::string says;
  bool takes_value = false, many = false, required = false;
};

struct Command {
  std::string name, says, more;  ///< more: what --help says last
  std::vector<Option> options, positionals;
};

struct Program {
  std::string name, says;
  std::vector<Option> options;
  std::vector<Command> commands;
};

/// All that --help shows, in its order.  Options and commands that it hides are left out.
/// Domain: a program whose commands have none of their own.
Program described(const CLI::App& program);

/// Whether a value of such a name is a path: "FILE|-", "OUT.glb", "NAME|FILE.so", "FOLDER", and not "A..B".
bool is_path(const std::string& value);

}  // namespace mmverify::cli::describe
