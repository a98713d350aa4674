// mmverify gen and check: any program on a pipe as the subject.
#include "proofs/index/pipe.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/json.hpp"
#include "cli/output_file.hpp"
#include "cli/text.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

struct PipeOptions {
  std::string topic, level, cells = "all", json;
  std::size_t errors = 1;
  bool interiors_only() const { return cells == "interior"; }
};

/// The pipe's indices have 32 bits.
Level one_level(const PipeOptions& options) {
  constexpr Level highest = 16;
  const Level level = parse_level(options.level);
  if (level > highest)
    throw UsageError(fmt::format("--level {}: the pipe's highest level is {}", options.level, highest));
  return level;
}

void add_common(CLI::App& command, PipeOptions& options) {
  command.add_option("topic", options.topic, "index")->required()->check(CLI::IsMember({"index"}));
  command.add_option("--level", options.level, "the level")->type_name("N")->required();
  command.add_option("--cells", options.cells, "all, or interior: leave out points on grid lines")
      ->check(CLI::IsMember({"all", "interior"}));
}

int generate(const PipeOptions& options) {
  // A reader that stops early is its own business, not an error of this program.
  index::generate_cases(one_level(options), options.interiors_only(), stdout);
  return ExitCode::complete;
}

int check(const PipeOptions& options) {
  const Level level = one_level(options);
  std::optional<OutputFile> json;
  if (!options.json.empty() && options.json != "-") json.emplace(options.json);
  std::ios::sync_with_stdio(false);
  index::Answered answered;
  try {
    answered = index::check_answers(level, options.interiors_only(), options.errors, std::cin);
  } catch (const index::BadAnswers& bad) {
    throw EnvironmentError(bad.what());
  }
  Report report;
  report.results.push_back(answered.result);
  if (!answered.diagnosis.empty())
    report.diagnoses.push_back({answered.result.law, answered.result.subject, answered.diagnosis});
  TextReport text(options.json == "-" ? stderr : stdout, true);
  text.add(answered.result);
  text.finish(report, false);
  if (json) json->commit(to_json(report, 1));
  if (options.json == "-") fmt::print("{}", to_json(report, 1));
  return answered.result.verdict == Verdict::proved ? ExitCode::complete : ExitCode::failed;
}

}  // namespace

Action add_gen(CLI::App& program) {
  auto* command = program.add_subcommand("gen", "the cases of a level, one a line, for a program on a pipe");
  auto options = std::make_shared<PipeOptions>();
  add_common(*command, *options);
  return [options] { return generate(*options); };
}

Action add_check(CLI::App& program) {
  auto* command =
      program.add_subcommand("check", "judge the answers that a program on a pipe gave to `gen`'s cases");
  auto options = std::make_shared<PipeOptions>();
  add_common(*command, *options);
  command->add_option("--errors", options->errors, "counterexamples kept")->check(CLI::Range(1, 10000));
  command->add_option("--json", options->json, "write the result as JSON; - is stdout")->type_name("FILE|-");
  return [options] { return check(*options); };
}

}  // namespace mmverify::cli
