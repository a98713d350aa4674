// mmverify gen and check: judges any program on a pipe.
#include "proofs/index/pipe.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/arguments/arguments.hpp"
#include "cli/attributes/check.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/junit.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/png_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/prove/short/run_text.hpp"
#include "cli/scene/check_maps.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/pipe/lines.hpp"
#include "proofs/registry/topics.hpp"
#include "proofs/traverse/rays/conformance.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

struct PipeOptions {
  std::string topic, level, cells = "all", json, levels;
  std::vector<std::string> laws;
  std::size_t errors = 1;
  std::uint64_t seed = 1, cases = 0;
  double distance = 0;  ///< for rays
  bool interiors_only() const { return cells == "interior"; }
  bool corners() const { return topic == "corners"; }
  bool rays() const { return topic == "rays"; }
};

/// The topic whose laws ask questions over the pipe; null for index and corners, whose cases are the cells.
const Topic* asking_topic(const PipeOptions& options) {
  for (const Topic& topic : topics())
    if (topic.dialogue != nullptr && options.topic == topic.name) return &topic;
  return nullptr;
}

std::vector<std::string> topics_with(std::vector<std::string> others) {
  for (const Topic& topic : topics())
    if (topic.dialogue != nullptr) others.push_back(topic.name);
  return others;
}

/// Takes --levels for --level, and the other way round, where only the other one is given.
PipeOptions with_its_levels(PipeOptions options) {
  std::string &own = asking_topic(options) != nullptr ? options.levels : options.level,
              &other = asking_topic(options) != nullptr ? options.level : options.levels;
  if (own.empty()) own.swap(other);
  return options;
}

/// The level for topics that take one. Limits: the pipe's indices have 32 bits; corners are stored, 24 bytes
/// each.
Level one_level(const PipeOptions& options) {
  if (options.level.empty()) throw UsageError("--level is required; write --level N");
  if (!options.levels.empty() || !options.laws.empty() || options.cases != 0)
    throw UsageError(fmt::format(
        "{}: the pipe judges one law at one --level; leave --levels, --law and --cases out", options.topic));
  if (options.rays() && options.interiors_only())
    throw UsageError("--cells interior: write --distance 0.25 for rays inside micro-triangles");
  if (options.corners() && options.interiors_only())
    throw UsageError("--cells interior: corners are asked by index; leave it out");
  const Level highest = options.rays() ? traverse::finest_ray_level : options.corners() ? 12 : 16;
  const Level level = parse_level(options.level);
  if (level > highest)
    throw UsageError(fmt::format("--level {}: the pipe's highest level is {}", options.level, highest));
  return level;
}

/// Whether a law can run on a pipe, which answers each question once: not if it needs a library or covers
/// many levels at once.
bool on_pipe(const Law& law) {
  return law.general && !law.long_only && !law.alternative && law.at_once.empty();
}

pipe::PipeRun asked(const PipeOptions& options, const Topic& topic) {
  if (!options.level.empty())
    throw UsageError(fmt::format("{}: --level and --levels: give one of them", topic.name));
  if (options.interiors_only())
    throw UsageError(
        fmt::format("--cells interior: {} is not about points on cells; leave it out", topic.name));
  pipe::PipeRun a{topic.name,
                  *topic.dialogue,
                  {},
                  options.laws,
                  options.levels.empty() ? Levels{0, 2} : parse_levels(options.levels)};
  a.errors = options.errors;
  a.seed = options.seed;
  a.cases = options.cases;
  for (const Law* law :
       parse_laws(options.laws.empty() ? std::vector{options.topic} : options.laws, Tier::fast)) {
    const bool fits = law->topic == topic.name && on_pipe(*law);
    if (fits) a.laws.push_back(law);
    if (!fits && !options.laws.empty())
      throw UsageError(
          fmt::format("--law {}: it cannot be asked of {} on a pipe; leave it out", law->id, topic.name));
  }
  return a;
}

void add_common(CLI::App& command, PipeOptions& options) {
  command.add_option("--level", options.level, "index, corners, rays: the level")->type_name("N");
  command.add_option("--cells", options.cells, "all, or interior: leave out points on grid lines")
      ->check(CLI::IsMember({"all", "interior"}));
  command
      .add_option("--levels", options.levels, "tree, bake: levels A..B, both included; 0..2 where not given")
      ->type_name("A..B");
  command.add_option("--law", options.laws, "tree, bake: only the cases of this law; may be given again")
      ->type_name("LAW");
  command.add_option("--cases", options.cases, "tree, bake: draw at least so many cases of each sampled law")
      ->check(whole_within(1, std::uint64_t{1} << 40));
  command.add_option("--seed", options.seed, "tree, bake, maps: seed of the samples")->check(fits_64_bits);
}

int generate(const PipeOptions& options) {
  end_with_the_reader();
  if (const Topic* topic = asking_topic(options)) {
    pipe::generate_questions(asked(options, *topic), stdout);
    return proofs::interrupted() ? ExitCode::interrupted : ExitCode::complete;
  }
  if (options.rays())
    traverse::write_conformance_rays(one_level(options), options.distance, stdout);
  else if (options.corners())
    index::generate_indices(one_level(options), stdout);
  else
    index::generate_cases(one_level(options), options.interiors_only(), stdout);
  return ExitCode::complete;
}

/// Judges the answers to index and corners.
Report checked_level(const PipeOptions& options) {
  const Level level = one_level(options);
  const index::Answered answered =
      options.corners() ? index::check_corners(level, options.errors, std::cin)
                        : index::check_answers(level, options.interiors_only(), options.errors, std::cin);
  Report report;
  report.results.push_back(answered.result);
  if (!answered.diagnosis.empty())
    report.diagnoses.push_back({answered.result.law, answered.result.subject, answered.diagnosis});
  return report;
}

int check(const PipeOptions& options, const std::string& junit_file, bool quiet, bool details) {
  const Topic* topic = asking_topic(options);
  std::optional<pipe::PipeRun> questions;
  if (topic != nullptr) {
    questions = asked(options, *topic);
    questions->show_progress = !quiet;
  } else {
    one_level(options);
  }
  refuse_same_file({{"--json", options.json}, {"--junit", junit_file}});
  JsonOutput json(options.json);
  std::optional<OutputFile> junit;
  if (!junit_file.empty()) junit.emplace(junit_file);
  std::ios::sync_with_stdio(false);
  Report report;
  try {
    report = questions ? pipe::check_questions(*questions, std::cin) : checked_level(options);
  } catch (const pipe::BadAnswers& bad) {
    throw EnvironmentError(bad.what());
  }
  RunText text(json.text(), details, topic == nullptr);
  for (const Result& result : report.results) text.add(result);
  text.finish(report, false);
  json.write([&] { return to_json(report, options.seed); });
  if (junit) junit->commit(to_junit(report));
  if (report.interrupted) return ExitCode::interrupted;
  refuse_nothing(report);
  return exit_code(report);
}

/// Adds the options that only finished maps need.
void add_maps(CLI::App& command, CheckMapsOptions& options) {
  command
      .add_option(
          "file", options.file,
          "maps: the scene, whose EXT_mesh_opacity_micromap is judged, or a folder of scenes; attributes: "
          "a file of theirs")
      ->type_name("FILE|FOLDER");
  command.add_option("--data", options.raw.data, "maps: this array's data in the place of the scene's own")
      ->type_name("FILE");
  command.add_option("--records", options.raw.records, "its records, 8 bytes each")->type_name("FILE");
  command
      .add_option("--indices", options.raw.indices, "its indices; triangle t has record t where not given")
      ->type_name("FILE");
  command.add_option("--index-type", options.raw.index_type, "type of the indices")
      ->check(CLI::IsMember({"u8", "u16", "u32", "i16", "i32"}));
  command.add_option("--base-triangle", options.raw.base_triangle, "added to indices that are not special");
  command
      .add_option("--primitive", options.raw.primitive, "the primitive whose triangles the array belongs to")
      ->type_name("MESH/PRIMITIVE");
  command
      .add_option("--states", options.states,
                  "maps: 2 where they were forced to 2-state; else as the file's records say")
      ->check(CLI::IsMember({2, 4}));
  command.add_option("--margin", options.margin, "maps: texels by which micro-triangles were dilated")
      ->check(finite_within(0, 64));
  command
      .add_option("--picture", options.picture,
                  "maps: draw the first wrong micro-triangle and its map on the texture")
      ->check(png_name)
      ->type_name("FILE.png");
  command.add_option("--sarif", options.sarif, "maps: write what is wrong as SARIF 2.1.0; - is stdout")
      ->type_name("FILE|-");
  add_effort(command, options.effort, "maps: ");
  command.add_option("--replay", options.replay, "maps: show one case of a law again")->type_name("LAW");
  command.add_option("--case", options.at, "the case of --replay")->type_name("LEVEL@CASE");
  command.add_flag("--quiet", options.quiet, "no progress");
}

}  // namespace

Action add_gen(CLI::App& program) {
  auto* command = program.add_subcommand("gen", "the cases of a level, one a line, for a program on a pipe");
  auto options = std::make_shared<PipeOptions>();
  command
      ->add_option("topic", options->topic,
                   "index: points; corners: indices; rays: rays with the state that they meet; tree: maps "
                   "and codes; bake: textures")
      ->required()
      ->check(CLI::IsMember(topics_with({"index", "corners", "rays"})));
  add_common(*command, *options);
  command
      ->add_option("--distance", options->distance,
                   "rays: one inside each micro-triangle, whose N u, N v and N w are at least so far from "
                   "whole numbers; 0: on edges and vertices, too")
      ->check(finite_within(0, traverse::most_distance));
  return [options, command] {
    if (!options->rays() && options->distance != 0) throw UsageError("--distance: only for gen rays");
    if (asking_topic(*options) == nullptr && command->count("--seed") != 0)
      throw UsageError(fmt::format("gen {}: it writes all cells of a level and draws none; leave --seed out",
                                   options->topic));
    return generate(with_its_levels(*options));
  };
}

Action add_check(CLI::App& program) {
  auto* command = program.add_subcommand(
      "check", "judge the answers that a program on a pipe gave to `gen`'s cases, or finished maps");
  auto options = std::make_shared<PipeOptions>();
  auto maps = std::make_shared<CheckMapsOptions>();
  auto details = std::make_shared<bool>(false);
  command
      ->add_option("topic", options->topic,
                   "index, corners, tree or bake; maps: finished ones against their textures; attributes: "
                   "whether a file of attribute micromaps is one")
      ->required()
      ->check(CLI::IsMember(topics_with({"index", "corners", "maps", "attributes"})));
  add_common(*command, *options);
  add_maps(*command, *maps);
  command->add_option("--errors", options->errors, "counterexamples kept")->check(whole_within(1, 10'000));
  command->add_option("--json", options->json, "write the results as JSON; - is stdout")->type_name("FILE|-");
  command->add_option("--junit", maps->junit, "write the results as JUnit XML")->type_name("FILE");
  add_details(*command, *details);
  return [options, maps, details, command] {
    if (options->topic == "attributes") {
      for (const CLI::Option* given : command->get_options())
        if (given->count() != 0 && given->get_name() != "topic" && given->get_name() != "file")
          throw UsageError(fmt::format("check attributes: it reads a file; leave {} out", given->get_name()));
      return check_attributes(maps->file);
    }
    if (options->topic != "maps") {
      if (!maps->sarif.empty()) throw UsageError("--sarif: only check maps takes it");
      if (!maps->file.empty())
        throw UsageError(
            fmt::format("check {}: answers come on standard input; leave the file out", options->topic));
      return check(with_its_levels(*options), maps->junit, maps->quiet, *details);
    }
    if (!options->level.empty()) throw UsageError("check maps: maps have their levels; leave --level out");
    if (!options->levels.empty() || !options->laws.empty() || options->cases != 0)
      throw UsageError("check maps: --levels, --law and --cases are of answers on a pipe; leave them out");
    maps->json = options->json;
    maps->seed = options->seed;
    maps->errors = options->errors;
    return check_maps(*maps);
  };
}

}  // namespace mmverify::cli
