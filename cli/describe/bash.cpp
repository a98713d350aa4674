#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/describe/shells.hpp"

namespace mmverify::cli::describe {
namespace {

/// Bash code that sets the completions of an option's value, or of a positional.
std::string bash_value(const Option& option) {
  std::string does;
  if (!option.words.empty()) does += fmt::format(" words='{}'", fmt::join(option.words, " "));
  if (is_path(option.value)) does += " paths=1";
  return does.empty() ? " :" : does;
}

std::string bash_patterns(const std::string& command, const Option& option) {
  std::vector<std::string> patterns;
  for (const std::string& name : option.names) patterns.push_back(command + ":" + name);
  return fmt::format("{}", fmt::join(patterns, " | "));
}

std::string bash_names(const std::vector<Option>& options) {
  std::vector<std::string> names;
  for (const Option& option : options) names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

/// The script with places for the program's name, its commands and options, and the cases of three switches.
constexpr char script[] = R"(# Completion of {0} for bash, written by `{0} completion bash`.
# bash 4 or later.  Where it lies in share/bash-completion/completions it is found; elsewhere: source FILE.
_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command='' words='' paths='' options=''
  local place=-1 value=0 i name
  COMPREPLY=()
  # --option=VALUE comes as three words.
  if [[ $word == '=' ]]; then word=''; elif [[ $before == '=' ]]; then before=${{COMP_WORDS[COMP_CWORD - 2]}}; fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    name=${{COMP_WORDS[i]}}
    if [[ -z $command && $name != -* ]]; then
      command=$name
    elif [[ $name == -* ]]; then
      _{0}_takes_value "$command:$name" && value=1
      continue
    elif [[ $name == '=' ]]; then
      value=1
      continue
    elif ((value == 0)); then
      ((++place))
    fi
    value=0
  done
  ((++place))
  words='' paths=''
  if [[ -z $command ]]; then
    words='{1}' options='{2}'
  elif _{0}_takes_value "$command:$before"; then
    :
  elif [[ $word != -* ]]; then
    _{0}_place "$command" "$place"
  fi
  [[ $word != -* ]] || case $command in
{3}  esac
  [[ $word == -* ]] && words=$options
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  if [[ -n $paths ]]; then
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -- "$word")
  fi
}}
# Whether that option of a command has a value; says what, in words and paths.
_{0}_takes_value() {{
  case $1 in
{4}    *) return 1 ;;
  esac
}}
# What stands at a place that no option takes.
_{0}_place() {{
  local place=$2
  case $1 in
{5}  esac
}}
complete -F _{0} {0}
)";

}  // namespace

std::string bash_completion(const Program& program) {
  std::string values, options, positionals;
  std::vector<std::string> commands;
  for (const Command& command : program.commands) {
    commands.push_back(command.name);
    for (const Option& option : command.options)
      if (option.takes_value)
        values += fmt::format("    {}){} ;;\n", bash_patterns(command.name, option), bash_value(option));
    options += fmt::format("    {}) options='{}' ;;\n", command.name, bash_names(command.options));
    std::string each;
    for (std::size_t k = 0; k < command.positionals.size(); ++k)
      each += fmt::format("        {}){} ;;\n", command.positionals[k].many ? "*" : std::to_string(k),
                          bash_value(command.positionals[k]));
    if (!each.empty())
      positionals +=
          fmt::format("    {})\n      case $place in\n{}      esac\n      ;;\n", command.name, each);
  }
  return fmt::format(script, program.name, fmt::join(commands, " "), bash_names(program.options), options,
                     values, positionals);
}

}  // namespace mmverify::cli::describe
