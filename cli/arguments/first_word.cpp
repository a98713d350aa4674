#include "cli/arguments/first_word.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/arguments/nearest_word.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/prove/subject_advice.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {
namespace {

std::vector<std::string> names_of_commands(CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

[[noreturn]] void refuse_command(const std::string& word, const std::vector<std::string>& commands) {
  std::string meant;
  if (!proofs::laws_named(word).empty())
    meant = "mmverify prove " + word;
  else if (is_library_or_shader(word))
    meant = "mmverify prove --subject " + as_path(word);
  else if (word.ends_with(".gltf") || word.ends_with(".glb"))
    meant = "mmverify validate " + word;
  else if (const std::string nearest = nearest_word(word, commands); !nearest.empty())
    meant = "mmverify " + nearest;
  throw UsageError(
      meant.empty() ? fmt::format("no command is called '{}'; there are {}", word, fmt::join(commands, ", "))
                    : fmt::format("no command is called '{}'; did you mean `{}`?", word, meant));
}

/// Renames --level or --levels to the one that the command has.
void rename_levels(CLI::App& command, std::vector<std::string>& arguments) {
  const std::string one = "--level", many = "--levels";
  const bool has_one = command.get_option_no_throw(one) != nullptr;
  if (has_one == (command.get_option_no_throw(many) != nullptr)) return;
  const std::string &from = has_one ? many : one, &to = has_one ? one : many;
  for (auto at = arguments.begin(); at != std::find(arguments.begin(), arguments.end(), "--"); ++at)
    if (*at == from || at->starts_with(from + "=")) at->replace(0, from.size(), to);
}

}  // namespace

std::vector<std::string> with_known_command(CLI::App& program, std::vector<std::string> arguments) {
  if (!arguments.empty() && arguments.front() == "help") {
    if (arguments.size() == 1) return {"--help"};
    arguments = {arguments[1], "--help"};
  }
  if (arguments.empty() || arguments.front().starts_with("-")) return arguments;
  const std::vector<std::string> commands = names_of_commands(program);
  if (std::find(commands.begin(), commands.end(), arguments.front()) == commands.end())
    refuse_command(arguments.front(), commands);
  rename_levels(*program.get_subcommand(arguments.front()), arguments);
  return arguments;
}

std::string meant_option(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands())
    for (const std::string& word : command->remaining()) {
      if (!word.starts_with("--")) continue;
      std::vector<std::string> known;
      for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
      return did_you_mean(word.substr(0, word.find('=')), known);
    }
  return {};
}

}  // namespace mmverify::cli
