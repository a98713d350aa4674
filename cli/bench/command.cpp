// mmverify bench: error against run time, by topic.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "cli/arguments.hpp"
#include "cli/bench/bake.hpp"
#include "cli/bench/index.hpp"
#include "cli/bench/plot.hpp"
#include "cli/bench/scene.hpp"
#include "cli/bench/subject.hpp"
#include "cli/bench/sweep.hpp"
#include "cli/bench/tree.hpp"
#include "cli/bench/vq.hpp"
#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/output_file.hpp"
#include "proofs/engine/interrupt.hpp"

namespace mmverify::cli {
namespace {

struct BenchOptions {
  std::vector<std::string> topics;
  std::string json, plot, levels, subject, scene, textures;
  bench::IndexBenchOptions index;
  std::size_t maps = 0;  ///< the topic's own number
  bool quiet = false, sweep = false;
  unsigned threads = 0;
};

/// Half a bench is none: throws Interrupted.
void stop_if_asked() {
  if (proofs::interrupted()) throw proofs::Interrupted();
}

/// One of the benches that print a table of their own and give JSON back.
template <class Bench>
int run_table(const BenchOptions& options, Bench bench) {
  if (!options.plot.empty()) throw UsageError("--plot: these figures are not drawn");
  std::optional<OutputFile> file;
  if (!options.json.empty() && options.json != "-") file.emplace(options.json);
  const std::string json = bench(options.json == "-" ? stderr : stdout);
  stop_if_asked();
  if (file) file->commit(json);
  if (options.json == "-") fmt::print("{}", json);
  return ExitCode::complete;
}

proofs::Levels levels_or(const BenchOptions& options, const proofs::Levels& otherwise,
                         proofs::Level highest = 16) {
  if (options.levels.empty()) return otherwise;
  const proofs::Levels levels = parse_levels(options.levels);
  if (levels.last > highest)
    throw UsageError(fmt::format("--levels {}: the highest level here is {}", options.levels, highest));
  return levels;
}

/// Domain: a topic with levels.
proofs::Levels levels_of(const BenchOptions& options, const std::string& topic) {
  const bench::TreeBenchOptions tree;
  const bench::BakeBenchOptions bake;
  if (topic == "bake") return levels_or(options, {bake.first, bake.last}, 12);
  return topic == "index" ? levels_or(options, {options.index.first, options.index.last})
                          : levels_or(options, {tree.first, tree.last}, tree.last);
}

/// What judging a library costs, beside calling it.
int run_subject_bench(const BenchOptions& options) {
  const proofs::Levels levels = levels_or(options, {10, 10});
  if (levels.first != levels.last) throw UsageError(fmt::format("--levels {}: one level", options.levels));
  return run_table(options,
                   [&](std::FILE* out) { return bench_subject(options.subject, levels.first, out); });
}

/// How fast the triangles of a scene are baked.
int run_scene_bench(const BenchOptions& options) {
  const bench::BakeBenchOptions bake;
  const proofs::Levels levels = levels_or(options, {bake.first, bake.last}, 12);
  return run_table(options,
                   [&](std::FILE* out) { return bench_scene(options.scene, levels, options.quiet, out); });
}

/// What a sweep costs from level to level, beside the obvious loop.
int run_sweep_bench(const BenchOptions& options) {
  const proofs::Levels levels = levels_or(options, {8, 13});
  return run_table(options, [&](std::FILE* out) { return bench_sweep(levels, options.threads, out); });
}

/// Tables, and what goes into files, of one topic.
BenchOutput bench_topic(const BenchOptions& options, const std::string& topic, std::FILE* out) {
  if (topic == "index") {
    bench::IndexBenchOptions index = options.index;
    const proofs::Levels levels = levels_of(options, topic);
    index.first = levels.first;
    index.last = levels.last;
    return bench_index(index, options.quiet, out);
  }
  if (topic == "vq")
    return bench_vq({.seed = options.index.seed,
                     .maps = options.maps == 0 ? bench::VqBenchOptions{}.maps : options.maps,
                     .textures = options.textures},
                    options.quiet, out);
  const proofs::Levels levels = levels_of(options, topic);
  if (topic == "bake")
    return bench_bake({.first = levels.first,
                       .last = levels.last,
                       .seed = options.index.seed,
                       .maps = options.maps == 0 ? bench::BakeBenchOptions{}.maps : options.maps,
                       .textures = options.textures},
                      options.quiet, out);
  return bench_tree({.first = levels.first,
                     .last = levels.last,
                     .seed = options.index.seed,
                     .lookups = options.index.samples,
                     .textures = options.textures},
                    options.quiet, out);
}

/// All topics, or those that were named.
int run_topics(const BenchOptions& options, const std::vector<std::string>& topics) {
  const auto asked = [&](const char* topic) {
    return std::find(topics.begin(), topics.end(), topic) != topics.end();
  };
  for (const std::string& topic : topics)
    if (topic != "vq") levels_of(options, topic);
  if (topics == std::vector<std::string>{"vq"} && !options.levels.empty())
    throw UsageError("--levels: blocks of topic vq have none");
  constexpr std::uint64_t most = std::uint64_t{1} << 26;  // 8 bytes each
  if (asked("tree") && options.index.samples > most)
    throw UsageError(
        fmt::format("--samples {}: bench tree does {} lookups at most", options.index.samples, most));
  if (topics.size() > 1 && !options.plot.empty()) throw UsageError("--plot: of one topic");
  std::optional<OutputFile> file, picture;
  if (!options.json.empty() && options.json != "-") file.emplace(options.json);
  if (!options.plot.empty()) picture.emplace(options.plot);
  std::FILE* const out = options.json == "-" ? stderr : stdout;
  std::string json, plot;
  for (const std::string& topic : topics) {
    const BenchOutput output = bench_topic(options, topic, out);
    json += (json.empty() ? "" : ",\n") + output.json;
    plot = output.plot;
    fmt::print(out, "{}", topic == topics.back() ? "" : "\n");
  }
  if (topics.size() > 1) json = "[\n" + json + "]\n";
  if (file) file->commit(json);
  if (options.json == "-") fmt::print("{}", json);
  if (picture) picture->commit(run_gnuplot(plot));
  return ExitCode::complete;
}

int run_bench(const BenchOptions& options) {
  const std::vector<std::string> all{"index", "tree", "vq", "bake"};
  std::vector<std::string> topics;
  for (const std::string& topic : all)
    if (options.topics.empty() ||
        std::find(options.topics.begin(), options.topics.end(), topic) != options.topics.end())
      topics.push_back(topic);
  for (const std::string& topic : options.topics)
    if (std::find(all.begin(), all.end(), topic) == all.end())
      throw UsageError(fmt::format("no topic is called '{}'; there are {}", topic, fmt::join(all, ", ")));
  const proofs::InterruptGuard guard;
  if (!options.scene.empty()) {
    if (topics != std::vector<std::string>{"bake"}) throw UsageError("--scene: for bench bake");
    return run_scene_bench(options);
  }
  if (!options.subject.empty() || options.sweep) {
    const char* const option = options.sweep ? "--sweep" : "--subject";
    if (topics.front() != "index" || options.topics.size() > 1)
      throw UsageError(fmt::format("{}: for bench index", option));
    if (!options.textures.empty()) throw UsageError("--textures: for bench tree, bench vq and bench bake");
    return options.sweep ? run_sweep_bench(options) : run_subject_bench(options);
  }
  if (!options.textures.empty() && std::find(topics.begin(), topics.end(), "index") != topics.end())
    throw UsageError("--textures: for bench tree, bench vq and bench bake");
  return run_topics(options, topics);
}

}  // namespace

Action add_bench(CLI::App& program) {
  auto* command =
      program.add_subcommand("bench", "error against run time, the fast way beside the obvious one");
  auto options = std::make_shared<BenchOptions>();
  command->add_option("topic", options->topics, "index, tree, vq or bake; all where none is given")
      ->type_name("TOPIC");
  command
      ->add_option("--levels", options->levels,
                   "levels A..B, both included; 1..16, of tree 3..12, of bake 3..9, where not given")
      ->type_name("A..B");
  command
      ->add_option("--samples", options->index.samples,
                   "points a level, of each kind of inputs; lookups a level and format")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40));
  command->add_option("--subject", options->subject, "measure what judging this library costs instead")
      ->type_name("FILE.so");
  auto* const textures = command
                             ->add_option("--textures", options->textures,
                                          "tree, vq, bake: the PNG files in this folder instead")
                             ->type_name("FOLDER");
  command
      ->add_option("--scene", options->scene, "bake: how fast this scene's own triangles are baked, instead")
      ->type_name("FILE.gltf")
      ->excludes(textures);
  command->add_option("--maps", options->maps, "vq, bake: how many generated maps or textures")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 16))
      ->excludes(textures);
  command->add_flag("--sweep", options->sweep,
                    "measure sweeps of index.equals_reference instead, level by level");
  command->add_option("--threads", options->threads, "of a sweep; as many as the machine has where not given")
      ->check(CLI::Range(1u, 1024u));
  command->add_option("--seed", options->index.seed, "of the points")->check(fits_64_bits);
  command->add_option("--json", options->json, "write the figures as JSON; - is stdout")->type_name("FILE|-");
  command->add_option("--plot", options->plot, "draw them, with gnuplot")->type_name("FILE.svg");
  command->add_flag("--quiet", options->quiet, "no progress on stderr");
  return [options] { return run_bench(*options); };
}

}  // namespace mmverify::cli
