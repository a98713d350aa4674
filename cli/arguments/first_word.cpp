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

bool is_gltf(const std::string& word) { return word.ends_with(".gltf") || word.ends_with(".glb"); }

[[noreturn]] void refuse_command(const std::vector<std::string>& arguments,
                                 const std::vector<std::string>& commands) {
  const std::string& word = arguments.front();
  std::string meant;
  if (word == "bake" && arguments.size() > 1 && is_gltf(arguments[1]))
    meant = "mmverify scene " + arguments[1];
  else if (!proofs::laws_named(word).empty())
    meant = "mmverify prove " + word;
  else if (is_library_or_shader(word))
    meant = "mmverify prove --subject " + as_path(word);
  else if (is_gltf(word))
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
  if (!arguments.empty() &&
      (arguments.front() == "version" || arguments.front() == "-V" || arguments.front() == "-v"))
    return {"--version"};
  if (arguments.empty() || arguments.front().starts_with("-")) return arguments;
  const std::vector<std::string> commands = names_of_commands(program);
  if (std::find(commands.begin(), commands.end(), arguments.front()) == commands.end())
    refuse_command(arguments, commands);
  if (arguments.size() > 1 && arguments.front() == "check" && is_gltf(arguments[1]))
    throw UsageError(
        fmt::format("check: a topic comes first; did you mean `mmverify check maps {}`?", arguments[1]));
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

std::string meant_member(const std::string& complaint) {
  constexpr std::string_view between = " not in {";
  const std::size_t at = complaint.find(between), end = complaint.rfind('}');
  if (at == std::string::npos || end == std::string::npos) return {};
  std::vector<std::string> known;
  std::size_t from = at + between.size();
  for (std::size_t to = from; from < end; from = to + 1) {
    to = std::min(complaint.find(',', from), end);
    known.push_back(complaint.substr(from, to - from));
  }
  const std::size_t colon = complaint.rfind(": ", at), begin = colon == std::string::npos ? 0 : colon + 2;
  return did_you_mean(complaint.substr(begin, at - begin), known);
}

std::string see_help(CLI::App& program) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  return fmt::format("; see `mmverify {}--help`", chosen.empty() ? "" : chosen.front()->get_name() + " ");
}

}  // namespace mmverify::cli
