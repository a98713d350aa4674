// mmverify list: every law there is.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "proofs/registry.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

std::string levels_text(const Law& law, const Levels& levels) {
  return law.at_once.empty() ? fmt::format("{}..{}", levels.first, levels.last) : law.at_once;
}

nlohmann::ordered_json as_json(const Law& law) {
  const SubjectPtr first = find_subject(law.subjects.front());
  nlohmann::ordered_json mutants = nlohmann::ordered_json::array();
  for (const Mutant& mutant : law.mutants) mutants.push_back(mutant.name);
  return {{"law", law.id},
          {"topic", law.topic},
          {"statement", law.says},
          {"source", law.source},
          {"domain", law.domain(*first, law.fast.last)},
          {"method", to_string(law.method)},
          {"subjects", law.subjects},
          {"companion",
           law.companion.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(law.companion)},
          {"tiers",
           {{"fast", law.long_only ? nlohmann::ordered_json(nullptr)
                                   : nlohmann::ordered_json{{"levels", levels_text(law, law.fast)},
                                                            {"expected_seconds", law.fast_seconds}}},
            {"long", {{"levels", levels_text(law, law.long_run)}}}}},
          {"mutants", mutants}};
}

void print_law(const Law& law) {
  const SubjectPtr first = find_subject(law.subjects.front());
  fmt::print("{}\n  {}\n", law.id, law.says);
  fmt::print("  source: {}\n", law.source);
  fmt::print("  domain: {}\n", law.domain(*first, law.fast.last));
  const char* levels = law.at_once.empty() ? "levels " : "";
  const std::string fast =
      law.long_only ? "not in it"
                    : fmt::format("{}{}, about {} s", levels, levels_text(law, law.fast), law.fast_seconds);
  fmt::print("  method: {}; fast tier: {}; long tier: {}{}\n", to_string(law.method), fast, levels,
             levels_text(law, law.long_run));
  if (!law.companion.empty()) fmt::print("  beside it, on subjects of floats: {}\n", law.companion);
  fmt::print("  subjects: {}\n\n", fmt::join(law.subjects, ", "));
}

}  // namespace

Action add_list(CLI::App& program) {
  auto* command =
      program.add_subcommand("list", "every law: id, statement, source, domain, method, and the subjects");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "as JSON");
  return [json] {
    if (*json) {
      nlohmann::ordered_json all{{"schema", "mmverify.list/1"},
                                 {"laws", nlohmann::ordered_json::array()},
                                 {"subjects", nlohmann::ordered_json::array()}};
      for (const Law& law : laws()) all["laws"].push_back(as_json(law));
      for (const SubjectPtr& s : subjects())
        all["subjects"].push_back({{"subject", s->name()}, {"about", s->about()}});
      fmt::print("{}\n", all.dump(1));
      return ExitCode::complete;
    }
    for (const Law& law : laws()) print_law(law);
    fmt::print("subjects:\n");
    for (const SubjectPtr& s : subjects()) fmt::print("  {:<22} {}\n", s->name(), s->about());
    return ExitCode::complete;
  };
}

}  // namespace mmverify::cli
