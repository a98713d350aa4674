#include "cli/describe/description.hpp"

#include <CLI/CLI.hpp>
#include <cctype>

namespace mmverify::cli::describe {
namespace {

/// The words in a type's name: "TEXT:{fast,long}" has fast and long; "FLOAT:{sampler->0.005}" has sampler,
/// and takes numbers too.
std::vector<std::string> listed(const std::string& type) {
  const std::size_t open = type.find(":{"), close = type.find('}', open == std::string::npos ? 0 : open);
  std::vector<std::string> words;
  if (open == std::string::npos || close == std::string::npos) return words;
  std::string list = type.substr(open + 2, close - open - 2);
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t to = std::min(list.find(',', from), list.size());
    const std::string word = list.substr(from, to - from);
    words.push_back(word.substr(0, word.find("->")));
    from = to + 1;
  }
  return words;
}

Option described_option(const CLI::Option& option) {
  Option o;
  if (option.get_positional()) o.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) o.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) o.names.push_back("--" + name);
  o.says = option.get_description();
  o.takes_value = option.get_items_expected_max() > 0;
  if (o.takes_value) {
    const std::string type = option.get_type_name();
    o.value = type.substr(0, type.find(':'));
    o.words = listed(type);
  }
  o.many = option.get_items_expected_max() > 1;
  o.required = option.get_required();
  return o;
}

std::vector<Option> described_options(const CLI::App& app, bool positional) {
  std::vector<Option> all;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty() && option->get_positional() == positional)
      all.push_back(described_option(*option));
  return all;
}

}  // namespace

Program described(const CLI::App& program) {
  Program p{program.get_name(), program.get_description(), described_options(program, false), {}};
  for (const CLI::App* command : program.get_subcommands({}))
    if (!command->get_group().empty())
      p.commands.push_back({command->get_name(), command->get_description(), command->get_footer(),
                            described_options(*command, false), described_options(*command, true)});
  return p;
}

bool is_path(const std::string& value) {
  if (value.find("FILE") != std::string::npos || value.find("FOLDER") != std::string::npos) return true;
  for (std::size_t at = value.find('.'); at != std::string::npos; at = value.find('.', at + 1))
    if (at + 1 < value.size() && std::islower(static_cast<unsigned char>(value[at + 1])) != 0) return true;
  return false;
}

}  // namespace mmverify::cli::describe
