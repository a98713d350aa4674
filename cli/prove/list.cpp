// mmverify list: lists the laws.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/arguments/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json_text.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/streams.hpp"
#include "proofs/planning/plan.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

std::string levels_text(const Law& law, const Levels& levels) {
  return law.at_once.empty() ? fmt::format("{}..{}", levels.first, levels.last) : law.at_once;
}

/// The fast tier's levels, and the levels of subjects that differ from them.
nlohmann::ordered_json fast_json(const Law& law) {
  if (law.long_only) return nullptr;
  nlohmann::ordered_json fast{{"levels", levels_text(law, law.tiers.fast)},
                              {"expected_seconds", law.tiers.seconds}};
  for (const auto& [subject, levels] : fast_levels_apart(law))
    fast["levels_of"][subject] = levels_text(law, levels);
  return fast;
}

nlohmann::ordered_json as_json(const Law& law) {
  const SubjectPtr first = find_subject(law.subjects.front());
  nlohmann::ordered_json mutants = nlohmann::ordered_json::array();
  for (const Mutant& mutant : law.mutants) mutants.push_back(mutant.name);
  return {{"law", law.id},
          {"topic", law.topic},
          {"statement", law.says},
          {"source", law.source},
          {"domain", law.domain(*first, law.tiers.fast.last)},
          {"method", to_string(law.method)},
          {"subjects", law.subjects},
          {"companion",
           law.companion.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(law.companion)},
          {"tiers", {{"fast", fast_json(law)}, {"long", {{"levels", levels_text(law, law.tiers.long_run)}}}}},
          {"mutants", mutants}};
}

void print_law(const Law& law) {
  const SubjectPtr first = find_subject(law.subjects.front());
  say(stdout, "{}\n  {}\n", law.id, law.says);
  say(stdout, "  source: {}\n", law.source);
  say(stdout, "  domain: {}\n", law.domain(*first, law.tiers.fast.last));
  const char* levels = law.at_once.empty() ? "levels " : "";
  std::string fast = law.long_only ? "not in it" : levels + levels_text(law, law.tiers.fast);
  for (const auto& [subject, of_subject] : fast_levels_apart(law))
    fast += fmt::format(", of {} {}", subject, levels_text(law, of_subject));
  if (!law.long_only) fast += fmt::format(", about {} s", law.tiers.seconds);
  const std::string by_id = law.by_id_only ? "not in it, runs by its id alone: " : "";
  say(stdout, "  method: {}; fast tier: {}; long tier: {}{}{}\n", to_string(law.method), fast, by_id, levels,
      levels_text(law, law.tiers.long_run));
  if (!law.companion.empty())
    say(stdout, "  runs as well, on subjects that take floats: {}\n", law.companion);
  if (law.id == "index.floats")
    say(stdout,
        "  of a function in C, C++, GLSL, HLSL, LLVM's bitcode or SPIR-V, levels 0..16: prove index.floats "
        "--source FILE --function NAME\n");
  say(stdout, "  subjects: {}\n\n", fmt::join(law.subjects, ", "));
}

/// The laws of these names, or all of them.
std::vector<const Law*> laws_called(const std::vector<std::string>& names) {
  std::vector<const Law*> all;
  if (names.empty())
    for (const Law& law : laws()) all.push_back(&law);
  else
    parse_laws(names, Tier::long_run);  // refuses unknown ones
  // A topic's list has the laws that run by their id alone, too.
  for (const std::string& name : names)
    for (const Law* law : laws_named(name))
      if (std::find(all.begin(), all.end(), law) == all.end()) all.push_back(law);
  return all;
}

std::vector<SubjectPtr> subjects_of_topics(const std::vector<const Law*>& chosen) {
  std::vector<SubjectPtr> found;
  for (const SubjectPtr& s : subjects())
    if (std::any_of(chosen.begin(), chosen.end(), [&](const Law* law) { return law->topic == s->topic(); }))
      found.push_back(s);
  return found;
}

/// Writes FOLDER/NAME.smt2 for each statement; NAME begins with the law's folder.
ExitCode write_statements(const std::string& folder) {
  const auto all = shipped_statements();
  for (const auto& [name, statement] : all) {
    const std::filesystem::path file = std::filesystem::path(folder) / (name + ".smt2");
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) throw EnvironmentError(fmt::format("{}: {}", file.parent_path().string(), error.message()));
    OutputFile(file.string()).commit(statement.text);
  }
  say(stdout, "{}: {} statements, each a file of SMT-LIB 2\n", folder, all.size());
  return ExitCode::complete;
}

}  // namespace

Action add_list(CLI::App& program) {
  auto* command =
      program.add_subcommand("list", "every law: id, statement, source, domain, method, and the subjects");
  auto names = std::make_shared<std::vector<std::string>>();
  command->add_option("law", *names, "only these laws or topics, with the topics' subjects")
      ->type_name("LAW|TOPIC");
  auto json = std::make_shared<bool>(false);
  auto statements = std::make_shared<std::string>();
  CLI::Option* as_json_option = command->add_flag("--json", *json, "as JSON");
  command
      ->add_option("--statements", *statements,
                   "write the statements that laws leave to z3 into this folder, as SMT-LIB files")
      ->type_name("DIR")
      ->excludes(as_json_option);
  return [names, json, statements] {
    end_with_the_reader();
    if (!statements->empty()) return write_statements(*statements);
    const std::vector<const Law*> chosen = laws_called(*names);
    if (*json) {
      nlohmann::ordered_json all{{"schema", "mmverify.list/1"},
                                 {"laws", nlohmann::ordered_json::array()},
                                 {"subjects", nlohmann::ordered_json::array()}};
      for (const Law* law : chosen) all["laws"].push_back(as_json(*law));
      for (const SubjectPtr& s : subjects_of_topics(chosen))
        all["subjects"].push_back({{"subject", s->name()}, {"about", s->about()}});
      say_text(stdout, json_text(all));
      return ExitCode::complete;
    }
    for (const Law* law : chosen) print_law(*law);
    say(stdout, "subjects:\n");
    for (const SubjectPtr& s : subjects_of_topics(chosen))
      say(stdout, "  {:<22} {}\n", s->name(), s->about());
    return ExitCode::complete;
  };
}

}  // namespace mmverify::cli
