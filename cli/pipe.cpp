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
#include "cli/junit.hpp"
#include "cli/output_file.hpp"
#include "cli/scene/check_maps.hpp"
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
  if (options.level.empty()) throw UsageError("--level is required; write --level N");
  constexpr Level highest = 16;
  const Level level = parse_level(options.level);
  if (level > highest)
    throw UsageError(fmt::format("--level {}: the pipe's highest level is {}", options.level, highest));
  return level;
}

void add_common(CLI::App& command, PipeOptions& options) {
  command.add_option("--level", options.level, "index: the level")->type_name("N");
  command.add_option("--cells", options.cells, "all, or interior: leave out points on grid lines")
      ->check(CLI::IsMember({"all", "interior"}));
}

int generate(const PipeOptions& options) {
  // A reader that stops early is its own business, not an error of this program.
  index::generate_cases(one_level(options), options.interiors_only(), stdout);
  return ExitCode::complete;
}

int check(const PipeOptions& options, const std::string& junit_file) {
  const Level level = one_level(options);
  std::optional<OutputFile> json, junit;
  if (!options.json.empty() && options.json != "-") json.emplace(options.json);
  if (!junit_file.empty()) junit.emplace(junit_file);
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
  if (junit) junit->commit(to_junit(report));
  return answered.result.verdict == Verdict::proved ? ExitCode::complete : ExitCode::failed;
}

/// What only finished maps have.
void add_maps(CLI::App& command, CheckMapsOptions& options) {
  command.add_option("file", options.file, "maps: the scene, whose EXT_mesh_opacity_micromap is judged")
      ->type_name("FILE.gltf|FILE.glb");
  command.add_option("--data", options.raw.data, "maps: this array's data in the place of the scene's own")
      ->type_name("FILE");
  command.add_option("--records", options.raw.records, "its records, 8 bytes each")->type_name("FILE");
  command
      .add_option("--indices", options.raw.indices, "its indices; triangle t has record t where not given")
      ->type_name("FILE");
  command.add_option("--index-type", options.raw.index_type, "of the indices")
      ->check(CLI::IsMember({"u8", "u16", "u32", "i16", "i32"}));
  command.add_option("--base-triangle", options.raw.base_triangle, "added to indices that are not special");
  command.add_option("--primitive", options.raw.primitive, "whose triangles it is of")
      ->type_name("MESH/PRIMITIVE");
  command.add_option("--states", options.states, "maps: 2 where they were forced to 2-state")
      ->check(CLI::IsMember({2, 4}));
  command.add_option("--margin", options.margin, "maps: texels by which micro-triangles were dilated")
      ->check(finite_within(0, 64));
  command.add_option("--samples", options.samples, "maps: micro-triangles that each law is checked on")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40));
  command.add_flag("--exhaustive", options.exhaustive, "maps: all micro-triangles");
  command.add_option("--seed", options.seed, "maps: of the samples")->check(fits_64_bits);
  command.add_option("--replay", options.replay, "maps: show one case of a law again")->type_name("LAW");
  command.add_option("--case", options.at, "the case of --replay")->type_name("LEVEL@CASE");
  command.add_flag("--quiet", options.quiet, "no progress");
}

}  // namespace

Action add_gen(CLI::App& program) {
  auto* command = program.add_subcommand("gen", "the cases of a level, one a line, for a program on a pipe");
  auto options = std::make_shared<PipeOptions>();
  command->add_option("topic", options->topic, "index")->required()->check(CLI::IsMember({"index"}));
  add_common(*command, *options);
  return [options] { return generate(*options); };
}

Action add_check(CLI::App& program) {
  auto* command = program.add_subcommand(
      "check", "judge the answers that a program on a pipe gave to `gen`'s cases, or finished maps");
  auto options = std::make_shared<PipeOptions>();
  auto maps = std::make_shared<CheckMapsOptions>();
  command->add_option("topic", options->topic, "index, or maps: finished ones against their textures")
      ->required()
      ->check(CLI::IsMember({"index", "maps"}));
  add_common(*command, *options);
  add_maps(*command, *maps);
  command->add_option("--errors", options->errors, "counterexamples kept")->check(CLI::Range(1, 10000));
  command->add_option("--json", options->json, "write the results as JSON; - is stdout")->type_name("FILE|-");
  command->add_option("--junit", maps->junit, "write the results as JUnit XML")->type_name("FILE");
  return [options, maps] {
    if (options->topic == "index") {
      if (!maps->file.empty())
        throw UsageError("check index: answers come on standard input; leave the file out");
      return check(*options, maps->junit);
    }
    if (!options->level.empty()) throw UsageError("check maps: maps have their levels; leave --level out");
    maps->json = options->json;
    maps->errors = options->errors;
    return check_maps(*maps);
  };
}

}  // namespace mmverify::cli
