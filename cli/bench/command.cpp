// mmverify bench: error against run time, by topic.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "bench/scene/dag_tables.hpp"
#include "bench/scene/tables.hpp"
#include "cli/arguments/arguments.hpp"
#include "cli/arguments/nearest_word.hpp"
#include "cli/bench/baker.hpp"
#include "cli/bench/codec/codec.hpp"
#include "cli/bench/csv.hpp"
#include "cli/bench/shaders.hpp"
#include "cli/bench/subject.hpp"
#include "cli/bench/sweep.hpp"
#include "cli/bench/tables.hpp"
#include "cli/bench/topics.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/plot_file.hpp"
#include "cli/output/streams.hpp"
#include "proofs/engine/interrupt.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read/bad_scene.hpp"
#include "subjects/shaders/speed/speed.hpp"

namespace mmverify::cli {
namespace {

std::vector<std::string> known_topics() {
  std::vector<std::string> names{"shaders"};
  for (const BenchTopic& topic : bench_topics()) names.emplace_back(topic.name);
  return names;
}

/// The outputs of a bench: stdout, and files for JSON, CSV and the picture, opened before the work.
class Outputs {
 public:
  explicit Outputs(const BenchOptions& options) : json_(options.json), csv_(options.csv) {
    refuse_same_file({{"--json", options.json}, {"--csv", options.csv}, {"--plot", options.plot}});
    if (options.json == "-" && options.csv == "-")
      throw UsageError("--json and --csv: only one of them can be stdout");
    if (!options.plot.empty()) picture_.emplace(options.plot);
  }

  /// Prints one bench's result; called once for each.
  void print(const bench::Result& result) {
    std::FILE* const text = csv_.text() == stderr ? stderr : json_.text();
    if (!results_.empty()) say(text, "\n");
    print_result(text, result);
    values_ += (values_.empty() ? "" : "\n") + result_csv(result);
    results_ += (results_.empty() ? "" : ",\n") + result_json(result);
    drawn_ = result.drawn;
  }

  int commit(bool several) {
    json_.write([&] { return several ? "[\n" + results_ + "]\n" : results_; });
    csv_.write([&] { return values_; });
    if (picture_) picture_->commit(*drawn_);
    return ExitCode::complete;
  }

 private:
  JsonOutput json_;
  JsonOutput csv_;
  std::optional<PlotFile> picture_;
  std::optional<bench::picture::Picture> drawn_;
  std::string results_, values_;
};

/// Refuses --plot before the work for figures that have no picture.
void refuse_plot(const BenchOptions& options, const std::string& bench) {
  if (!options.plot.empty())
    throw UsageError(fmt::format("--plot: the figures of {} have no drawing; leave it out", bench));
}

/// Runs a bench that belongs to no topic; its figures have no picture.
template <class Bench>
int run_table(const BenchOptions& options, Bench bench) {
  refuse_plot(options, "this bench");
  Outputs outputs(options);
  const bench::Result result = bench();
  stop_if_asked();
  outputs.print(result);
  return outputs.commit(false);
}

proofs::Levels levels_or(const BenchOptions& options, const proofs::Levels& otherwise,
                         proofs::Level highest = 16) {
  if (options.levels.empty()) return otherwise;
  const proofs::Levels levels = parse_levels(options.levels, "--levels");
  if (levels.last > highest)
    throw UsageError(fmt::format("--levels {}: the highest level here is {}", options.levels, highest));
  return levels;
}

/// Measures the cost of judging a library, and that of calling it.
int run_subject_bench(const BenchOptions& options) {
  const proofs::Levels levels = levels_or(options, {10, 10});
  if (levels.first != levels.last)
    throw UsageError(fmt::format("--levels {}: --subject measures one level; write N", options.levels));
  return run_table(options,
                   [&] { return bench::subject_tables(subject_figures(options.subject, levels.first)); });
}

/// Says how many triangles a bench leaves out because their vertex alpha varies.
void say_varying(const std::string& file, std::uint64_t triangles) {
  if (triangles != 0)
    say(stderr, "bench: {}: {} triangles are left out: {}\n", file, grouped(triangles),
        mmverify::scene::sentence(mmverify::scene::LeftOut::varying_alpha));
}

bench::Result scene_result(const BenchOptions& options, const proofs::Levels& levels) {
  constexpr std::size_t rounds = 5;
  bench::SceneBakeOptions bake{options.scene, levels.first, levels.last};
  bake.rounds = rounds;
  bake.progress = progress_of("scene", options);
  bake.stop = stop_if_asked;
  try {
    const bench::SceneBakeFigures figures = bench::scene_bake_figures(bake);
    say_varying(options.scene, figures.varying);
    if (figures.triangles == 0) throw UsageError(options.scene + ": nothing to bake");
    return bench::scene_bake_tables(figures, bake);
  } catch (const mmverify::scene::BadScene& error) {
    throw EnvironmentError(error.what());
  }
}

/// Measures how fast the triangles of a scene are baked.
int run_scene_bench(const BenchOptions& options) {
  const bench::SceneBakeOptions otherwise;
  const proofs::Levels levels = levels_or(options, {otherwise.first, otherwise.last}, 12);
  return run_table(options, [&] { return scene_result(options, levels); });
}

/// Measures the sizes of a scene's maps in each form.
int run_scene_dag_bench(const BenchOptions& options) {
  const bench::SceneDagOptions otherwise;
  const proofs::Levels levels = levels_or(options, {otherwise.first, otherwise.last}, otherwise.last);
  if (options.index.samples > most_lookups)
    throw UsageError(
        fmt::format("--samples {}: bench dag does {} lookups at most", options.index.samples, most_lookups));
  const bench::SceneDagOptions dag{.file = options.scene,
                                   .first = levels.first,
                                   .last = levels.last,
                                   .seed = options.index.seed,
                                   .lookups = options.index.samples,
                                   .memory = options.memory == 0 ? otherwise.memory : options.memory,
                                   .progress = progress_of("dag", options),
                                   .stop = stop_if_asked};
  Outputs outputs(options);
  try {
    const bench::SceneDagScene figures = bench::scene_dag(dag);
    stop_if_asked();
    say_varying(options.scene, figures.varying);
    if (figures.maps == 0) throw UsageError(options.scene + ": nothing to bake");
    if (figures.rows.empty())
      throw UsageError(
          fmt::format("{}: every map of these levels is uniform; try other --levels", options.scene));
    outputs.print(bench::scene_dag_tables(figures, dag));
  } catch (const mmverify::scene::BadScene& error) {
    throw EnvironmentError(error.what());
  }
  return outputs.commit(false);
}

/// Measures the errors of another baker on real content, and its time.
int run_baker_bench(const BenchOptions& options) {
  const proofs::Levels levels = levels_or(options, {3, 6}, 12);
  return run_table(options, [&] {
    try {
      return bench::baker_tables(baker_figures(options, levels));
    } catch (const mmverify::scene::BadScene& error) {
      throw EnvironmentError(error.what());
    }
  });
}

/// Measures the cost of a sweep level by level, and that of a plain loop.
int run_sweep_bench(const BenchOptions& options) {
  const proofs::Levels levels = levels_or(options, {8, 13});
  return run_table(options, [&] {
    return bench::sweep_tables(sweep_figures(levels, options.threads, progress_of("sweep", options)));
  });
}

/// Measures lookups on a device. It is not among the topics, which run without a device.
int run_shader_bench(const BenchOptions& options) {
  if (options.topics.size() > 1) throw UsageError("bench shaders runs alone; leave the other topics out");
  if (!options.subject.empty() || !options.scene.empty() || !options.textures.empty() || options.sweep)
    throw UsageError("bench shaders takes only --levels, --hits, --device, --json and --csv");
  const proofs::Levels levels = levels_or(options, {12, 12}, 12);
  try {
    return run_table(options, [&] { return bench::shader_tables(shader_figures(options, levels)); });
  } catch (const shaders::WrongAnswer& wrong) {
    say(stderr, "mmverify: bench shaders: {}\n", wrong.what());
    return ExitCode::failed;
  }
}

using ChosenTopics = std::vector<const BenchTopic*>;

/// The levels of each topic, empty if it has none. Throws UsageError for levels or samples that a topic does
/// not allow.
std::vector<proofs::Levels> checked_levels(const BenchOptions& options, const ChosenTopics& topics) {
  std::vector<proofs::Levels> levels;
  for (const BenchTopic* topic : topics)
    levels.push_back(topic->levels ? levels_or(options, *topic->levels, topic->highest) : proofs::Levels{});
  if (topics.size() == 1 && !topics.front()->levels && !options.levels.empty())
    throw UsageError(fmt::format("--levels: bench {} takes no levels; leave it out", topics.front()->name));
  for (const BenchTopic* topic : topics)
    if (options.index.samples > topic->most_samples)
      throw UsageError(fmt::format("--samples {}: bench {} does {} lookups at most", options.index.samples,
                                   topic->name, topic->most_samples));
  return levels;
}

/// "40 s" or "3 min".
std::string duration(unsigned seconds) {
  return seconds < 90 ? fmt::format("{} s", seconds) : fmt::format("{} min", (seconds + 30) / 60);
}

/// Says which topics run, for how long, and how to ask for one.
void announce(const ChosenTopics& topics) {
  std::string each;
  unsigned seconds = 0;
  for (const BenchTopic* topic : topics) {
    each += fmt::format("{}{} ({})", each.empty() ? "" : ", ", topic->name, duration(topic->seconds));
    seconds += topic->seconds;
  }
  say(stderr,
      "bench: runs {}: about {} in all at default levels on two cores; for one alone: mmverify bench {}\n",
      each, duration(seconds), topics.front()->name);
}

/// Runs the given topics.
int run_topics(const BenchOptions& options, const ChosenTopics& topics) {
  const std::vector<proofs::Levels> levels = checked_levels(options, topics);
  if (topics.size() > 1 && !options.plot.empty()) throw UsageError("--plot draws one topic; name one");
  if (!topics.front()->draws) refuse_plot(options, fmt::format("bench {}", topics.front()->name));
  if (topics.size() > 1 && !options.quiet) announce(topics);
  Outputs outputs(options);
  for (std::size_t k = 0; k < topics.size(); ++k) outputs.print(measured(*topics[k], options, levels[k]));
  return outputs.commit(topics.size() > 1);
}

/// The names of the topics, "index, tree", with `last` before the last one; with_textures: "bench tree, bench
/// vq", the topics that read textures.
std::string names_of_topics(bool with_textures, const char* last) {
  std::vector<std::string> names;
  for (const BenchTopic& topic : bench_topics())
    if (topic.reads_textures || !with_textures)
      names.push_back((with_textures ? "bench " : "") + std::string(topic.name));
  const std::string final_name = names.back();
  names.pop_back();
  return fmt::format("{}{}{}", fmt::join(names, ", "), last, final_name);
}

int run_bench(const BenchOptions& options) {
  const bool of_shaders =
      std::find(options.topics.begin(), options.topics.end(), "shaders") != options.topics.end();
  if (options.device != 0 && !of_shaders) throw UsageError("--device: only bench shaders takes it");
  if (options.hits != 0 && !of_shaders) throw UsageError("--hits: only bench shaders takes it");
  if (of_shaders) {
    const proofs::InterruptGuard guard;
    return run_shader_bench(options);
  }
  ChosenTopics topics;
  const auto named = [&](const BenchTopic& topic) {
    return std::find(options.topics.begin(), options.topics.end(), topic.name) != options.topics.end();
  };
  for (const BenchTopic& topic : bench_topics())
    if (options.topics.empty() || named(topic)) topics.push_back(&topic);
  for (const std::string& topic : options.topics)
    if (std::none_of(bench_topics().begin(), bench_topics().end(),
                     [&](const BenchTopic& known) { return topic == known.name; }))
      throw UsageError(fmt::format("no topic is called '{}'; there are {}, and shaders{}", topic,
                                   names_of_topics(false, ", "), did_you_mean(topic, known_topics())));
  const auto only = [&](const char* name) {
    return topics.size() == 1 && topics.front()->name == std::string(name);
  };
  const std::string for_textures = "--textures: only for " + names_of_topics(true, " and ");
  const bool other_bench =
      options.sweep || !options.scene.empty() || (!options.subject.empty() && !only("vq"));
  if (options.maps != 0 && (other_bench || std::none_of(topics.begin(), topics.end(),
                                                        [](const BenchTopic* t) { return t->makes_maps; })))
    throw UsageError(
        "--maps: only for bench vq and bench bake with generated maps and textures; leave it out");
  const proofs::InterruptGuard guard;
  if (!options.subject.empty() && only("bake")) return run_baker_bench(options);
  if (options.memory != 0 && (options.scene.empty() || !only("dag")))
    throw UsageError("--memory: only bench dag --scene takes it");
  if (!options.scene.empty()) {
    if (only("dag")) {
      if (!options.subject.empty() || options.sweep)
        throw UsageError("bench dag --scene: takes --levels, --memory, --samples, --seed, --json and --plot");
      return run_scene_dag_bench(options);
    }
    if (!only("bake")) throw UsageError("--scene: only bench bake and bench dag take it");
    return run_scene_bench(options);
  }
  if (!options.subject.empty() || options.sweep) {
    const bool of_index = topics.front()->name == std::string("index") && options.topics.size() <= 1;
    if (options.sweep && !of_index) throw UsageError("--sweep: only for bench index");
    if (!of_index && topics.size() != 1)
      throw UsageError("--subject: name one topic, as in bench tree --subject ./mine.so");
    if (!options.textures.empty() && (of_index || !topics.front()->reads_textures))
      throw UsageError(for_textures);
    if (!of_index) return run_table(options, [&] { return codec_result(topics.front()->name, options); });
    return options.sweep ? run_sweep_bench(options) : run_subject_bench(options);
  }
  if (!options.textures.empty() &&
      std::any_of(topics.begin(), topics.end(), [](const BenchTopic* t) { return !t->reads_textures; }))
    throw UsageError(for_textures);
  return run_topics(options, topics);
}

void add_shader_options(CLI::App& command, BenchOptions& options) {
  command.add_option("--device", options.device, "shaders: the Vulkan device, by number; 0 where not given")
      ->check(whole_within(0, 9999));
  command
      .add_option(
          "--hits", options.hits,
          "shaders: the most hits of a dispatch, rounded down to a power of two; where not given 2^28, "
          "2^20 on a processor")
      ->check(whole_within(2, std::uint64_t{1} << 31));
}

}  // namespace

Action add_bench(CLI::App& program) {
  auto* command =
      program.add_subcommand("bench", "error against run time, the fast way beside the obvious one");
  auto options = std::make_shared<BenchOptions>();
  command
      ->add_option("topic", options->topics,
                   names_of_topics(false, " or ") + "; all where none is given; or shaders")
      ->type_name("TOPIC");
  command
      ->add_option("--levels", options->levels,
                   "levels A..B, both included; 1..16, of tree 3..12, of bake 3..9, where not given")
      ->type_name("A..B");
  command
      ->add_option("--samples", options->index.samples,
                   "points a level, of each kind of inputs; lookups a level and format")
      ->check(whole_within(1, std::uint64_t{1} << 40));
  command
      ->add_option(
          "--subject", options->subject,
          "tree, dag, vq, array, attribute: this library's codec beside ours; index: what judging it "
          "costs; bake: what this baker gets wrong of --scene or --textures, and its time")
      ->type_name("NAME|FILE.so");
  auto* const textures = command
                             ->add_option("--textures", options->textures,
                                          "tree, vq, bake: the PNG files in this folder instead")
                             ->type_name("FOLDER");
  command
      ->add_option("--scene", options->scene,
                   "bake: how fast this scene's own triangles are baked, instead; with --subject also a "
                   "folder; dag: what its maps take in each form")
      ->type_name("FILE.gltf")
      ->excludes(textures);
  command
      ->add_option("--memory", options->memory,
                   "dag --scene: the memory of a level's 4-state maps; above it only some maps are measured; "
                   "128 MiB where not given")
      ->check(whole_within(1, std::uint64_t{1} << 30));
  command->add_option("--maps", options->maps, "vq, bake: how many generated maps or textures")
      ->check(whole_within(1, 1 << 16))
      ->excludes(textures);
  command->add_flag("--sweep", options->sweep,
                    "measure sweeps of index.equals_reference instead, level by level");
  command
      ->add_option("--threads", options->threads,
                   "threads of a sweep; as many as the machine has where not given")
      ->check(whole_within(1, 1024));
  add_shader_options(*command, *options);
  command->add_option("--seed", options->index.seed, "seed of the points")->check(fits_64_bits);
  command->add_option("--json", options->json, "write the figures as JSON; - is stdout")->type_name("FILE|-");
  command->add_option("--csv", options->csv, "write the figures as comma-separated values; - is stdout")
      ->type_name("FILE|-");
  command->add_option("--plot", options->plot, "draw them, with gnuplot")
      ->check(plot_name)
      ->type_name("FILE.svg|FILE.png");
  command->add_flag("--quiet", options->quiet, "no progress on stderr");
  return [options] { return run_bench(*options); };
}

}  // namespace mmverify::cli
