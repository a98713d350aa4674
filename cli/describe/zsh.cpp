#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/describe/shells.hpp"

namespace mmverify::cli::describe {
namespace {

/// Escapes a text for single quotes and for _arguments, which gives brackets and colons a meaning.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      out += fmt::format("\\{}", c);
    else if (c == '\n')
      out += ' ';
    else
      out += c;
  }
  return out;
}

/// The "MESSAGE:ACTION" part for a value.
std::string zsh_value(const Option& option) {
  std::string action = " ";
  const bool path = is_path(option.value);
  const std::string words = fmt::format("{}", fmt::join(option.words, " "));
  if (path && !words.empty())
    action = fmt::format("{{ compadd -- {}; _files }}", words);
  else if (path)
    action = "_files";
  else if (!words.empty())
    action = fmt::format("({})", words);
  return fmt::format("{}:{}", zsh_text(option.value), action);
}

std::string zsh_option(const Option& option) {
  std::string lines;
  for (const std::string& name : option.names)
    lines += fmt::format(" \\\n        '{}{}[{}]{}'", option.many ? "*" : "", name, zsh_text(option.says),
                         option.takes_value ? ":" + zsh_value(option) : "");
  return lines;
}

}  // namespace

std::string zsh_completion(const Program& program) {
  std::string names, commands, options;
  for (const Option& option : program.options) options += zsh_option(option);
  for (const Command& command : program.commands) {
    names += fmt::format("        '{}:{}'\n", command.name, zsh_text(command.says));
    commands += fmt::format("    {})\n      _arguments -s", command.name);
    for (const Option& option : command.options) commands += zsh_option(option);
    for (const Option& positional : command.positionals)
      commands += fmt::format(" \\\n        '{}:{}'", positional.many ? "*" : "", zsh_value(positional));
    commands += "\n      ;;\n";
  }
  return fmt::format(R"(#compdef {0}
# Completion of {0} for zsh, written by `{0} completion zsh`.  Found where it lies in a folder of $fpath, as _{0}.
_{0}() {{
  local state line
  local -a commands
  _arguments -C{1} \
        '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      commands=(
{2}      )
      _describe -t commands command commands
      return
      ;;
  esac
  case $line[1] in
{3}  esac
}}
if [ "$funcstack[1]" = _{0} ]; then _{0} "$@"; else compdef _{0} {0}; fi
)",
                     program.name, options, names, commands);
}

}  // namespace mmverify::cli::describe
