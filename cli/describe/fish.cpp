#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/describe/shells.hpp"

namespace mmverify::cli::describe {
namespace {

std::string fish_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

/// fish's flags for a value: -x for words only, -F for paths as well.
std::string fish_value(const Option& option) {
  std::string value = is_path(option.value) ? " -r -F" : " -x";
  if (!option.words.empty()) value += fmt::format(" -a '{}'", fmt::join(option.words, " "));
  return value;
}

std::string fish_option(const Option& option) {
  std::string line;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return fmt::format("{}{} -d '{}'\n", line, option.takes_value ? fish_value(option) : "",
                     fish_text(option.says));
}

}  // namespace

std::string fish_completion(const Program& program) {
  std::string text = fmt::format(
      "# Completion of {0} for fish, written by `{0} completion fish`.  Found in "
      "~/.config/fish/completions.\n"
      "complete -c {0} -f\n",
      program.name);
  for (const Option& option : program.options)
    text += fmt::format("complete -c {} -n __fish_use_subcommand{}", program.name, fish_option(option));
  for (const Command& command : program.commands) {
    text += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d '{}'\n", program.name, command.name,
                        fish_text(command.says));
    const std::string in_it =
        fmt::format("complete -c {} -n '__fish_seen_subcommand_from {}'", program.name, command.name);
    for (const Option& option : command.options) text += in_it + fish_option(option);
    for (const Option& positional : command.positionals) {
      if (is_path(positional.value)) text += in_it + " -F\n";
      if (!positional.words.empty())
        text += fmt::format("{} -a '{}' -d '{}'\n", in_it, fmt::join(positional.words, " "),
                            fish_text(positional.value));
    }
  }
  return text;
}

}  // namespace mmverify::cli::describe
