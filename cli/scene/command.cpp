// mmverify scene: a scene's plan, its micromaps, and the laws on them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>

#include "cli/arguments/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/plot_file.hpp"
#include "cli/output/png_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/prove/run_identity.hpp"
#include "cli/scene/bake_effort.hpp"
#include "cli/scene/loaded.hpp"
#include "cli/scene/scene.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/progress.hpp"
#include "proofs/scene/laws.hpp"
#include "scene/picture/opacity_picture.hpp"
#include "scene/sample/scene.hpp"
#include "scene/validate/micromaps.hpp"
#include "scene/write/glb.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
using proofs::BadCase;
using proofs::Interrupted;
using proofs::InterruptGuard;
using proofs::Job;
using proofs::Progress;
using proofs::Replayed;
using proofs::Report;
using proofs::Result;
using proofs::RunOptions;

struct SceneOptions {
  std::string file, level = "auto", sizes, json, plot, glb, journal, replay, at, subject, picture;
  std::optional<double> asks;  ///< a share, in [0, 1]
  double timeout = 10;
  std::uint64_t memory = std::uint64_t{1} << 30, seed = 1;
  BakeEffort effort;
  unsigned threads = 0, level_limit = finest_level;
  bool no_laws = false, quiet = false, details = false;
  float margin = 0;
  bool moving = false;
  int states = 4;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

LevelRequest request(const SceneOptions& options) {
  LevelRequest r;
  r.memory = options.memory;
  if (options.level == "auto") return r;
  r.level = parse_level(options.level);
  if (*r.level > finest_level)
    throw UsageError(fmt::format("--level {}: maps go up to level {}", options.level, finest_level));
  if (*r.level > options.level_limit)
    throw UsageError(fmt::format("--level {}: above --level-limit {}", options.level, options.level_limit));
  return r;
}

void stop_if_interrupted() {
  if (proofs::interrupted()) throw Interrupted();
}

/// Bakes with a progress bar; if baking fails, the error names the file.
template <class Bake>
auto baked(const std::string& file, const SceneOptions& options, std::uint64_t micro_triangles, Bake bake) {
  Progress progress(micro_triangles, !options.quiet);
  progress.now("bake");
  try {
    return bake(BakeOptions{options.threads, options.states == 2, options.margin, [&](std::uint64_t done) {
                              progress.add(done);
                              stop_if_interrupted();
                            }});
  } catch (const std::invalid_argument& error) {
    throw EnvironmentError(fmt::format("{}: {}", file, error.what()));
  }
}

/// The sizes with every triangle at each of some levels: the paper's figure 5.
std::vector<SceneFigures::AtLevel> at_levels(const Scene& scene, const Plan& plan,
                                             const SceneOptions& options) {
  std::vector<SceneFigures::AtLevel> all;
  if (options.sizes.empty()) return all;
  const proofs::Levels range = parse_levels(options.sizes, "--sizes");
  if (range.last > finest_level)
    throw UsageError(fmt::format("--sizes {}: maps go up to level {}", options.sizes, finest_level));
  for (unsigned level = range.first; level <= range.last; ++level) {
    if (const auto bytes = map_bytes_at_level(plan, level); bytes > options.memory) {
      say(stderr, "sizes: level {} would take {} bytes, more than --memory; left out from here on\n", level,
          grouped(bytes));
      break;
    }
    const std::uint64_t all_of = impl::micromap::micro_triangles(level) * plan.triangles.size();
    all.push_back({level, baked(scene.file, options, all_of, [&](const BakeOptions& bake) {
                     return sizes_at_level(scene, plan, level, bake);
                   })});
  }
  return all;
}

/// The options that decide the maps besides levels, "--moving --margin 0.5 ".
std::string baking(const SceneOptions& options) {
  std::string text;
  if (options.moving) text += "--moving ";
  if (options.margin != 0) text += fmt::format("--margin {} ", options.margin);
  if (options.states != 4) text += "--states 2 ";
  return text;
}

/// The options that decide the levels, "--level-limit 7 ".
std::string levels(const SceneOptions& options) {
  std::string text;
  if (options.level != "auto") text += "--level " + options.level + " ";
  if (options.level_limit != finest_level) text += fmt::format("--level-limit {} ", options.level_limit);
  if (options.memory != SceneOptions().memory) text += fmt::format("--memory {} ", options.memory);
  return text;
}

/// The command with the arguments that decide the maps, for replaying a case.
std::string command(const SceneOptions& options) {
  std::string text = "mmverify scene " + (options.file.empty() ? "" : shell_quoted(options.file) + " ");
  text += levels(options) + baking(options);
  if (!options.subject.empty()) return text + "--subject " + shell_quoted(options.subject);
  text.pop_back();
  return text;
}

/// Replays one case, with `--level` for the case's level.
int replayed(const std::vector<Job>& jobs, const SceneOptions& options) {
  for (const Job& job : jobs) {
    if (job.law->id != options.replay || options.at.empty()) continue;
    const auto [level, at] = [&] {
      const auto colon = options.at.find('@');
      if (colon == std::string::npos) throw UsageError("--case " + options.at + ": write LEVEL@CASE");
      return std::pair(parse_level(options.at.substr(0, colon)), options.at.substr(colon + 1));
    }();
    if (job.levels.first != level) continue;
    try {
      const Replayed r = job.law->replay(*job.subject, level, at);
      say(stdout, "{} {} level {} case {} expected {} got {}\n", r.holds ? "holds" : "refuted", job.law->id,
          level, at, r.expected, r.got);
      return r.holds ? complete : failed;
    } catch (const BadCase& bad) {
      throw UsageError(fmt::format("--case {}", bad.what()));
    }
  }
  throw UsageError(
      fmt::format("--replay {}: no law of that name has cases of that level in this scene", options.replay));
}

/// The report of a scene without a case for any law.
Report nothing_to_bake() {
  Result result;
  result.law = "bake.conservative";
  result.topic = "bake";
  result.subject = "impl";
  result.method = "sample";
  result.domain = "the micro-triangles of this scene";
  result.verdict = proofs::Verdict::not_applicable;
  result.reason = "nothing to bake";
  Report report;
  report.results.push_back(std::move(result));
  return report;
}

class Output {
 public:
  explicit Output(const SceneOptions& options) : options_(options), json_(options.json) {
    if (!options.glb.empty()) glb_.emplace(options.glb);
    if (!options.plot.empty()) plot_.emplace(options.plot);
  }
  std::FILE* text() const { return json_.text(); }
  void json(const Report& report, const std::string& scene) {
    json_.write([&] { return to_json(report, options_.seed, {}, {}, scene); });
  }
  void glb(const Plan& plan, const Scene& scene, const SceneArrays& arrays) {
    if (!glb_) return;
    const BakeSettings settings{options_.margin, options_.states == 2};
    const Bytes sample = options_.file.empty() ? sample_scene() : Bytes();
    const Bytes bytes =
        options_.file.empty()
            ? with_micromaps(sample_name, sample, scene, plan, arrays, options_.glb, settings)
            : with_micromaps(options_.file, std::nullopt, scene, plan, arrays, options_.glb, settings);
    glb_->commit({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const int column = options_.details ? 11 : 10;  // the lines before it have that one
    say(text(), "  {:<{}}{}: {} bytes, no rule of EXT_mesh_opacity_micromap broken\n", "written", column,
        options_.glb, grouped(bytes.size()));
    if (const std::uint64_t old = options_.file.empty() ? 0 : old_micromap_bytes(options_.file); old != 0)
      say(text(), "  {:<{}}{} bytes are those of {}'s own micromaps, which nothing reads any more\n", "",
          column, grouped(old), options_.file);
  }
  void plot(const SceneFigures& figures) {
    if (plot_) plot_->commit(sizes_picture(figures));
  }

 private:
  const SceneOptions& options_;
  JsonOutput json_;
  std::optional<PlotFile> plot_;
  std::optional<OutputFile> glb_;
};

/// Runs the pipeline and prints its plan before it bakes.
SceneMicromaps micromaps_of(const Scene& scene, const LevelRequest& wanted, const SceneOptions& options,
                            Output& output) {
  PipelineOptions pipeline{.levels = wanted, .level_limit = options.level_limit};
  std::optional<Progress> progress;
  pipeline.planned = [&](const Plan& plan, const mmverify::scene::Levels& levels) {
    if (options.replay.empty() && (options.details || plan.triangles.empty() || !options.subject.empty()))
      print_plan(output.text(), scene, plan, levels);
    std::fflush(output.text());
    if (plan.triangles.empty()) return false;
    progress.emplace(levels.micro_triangles, !options.quiet);
    progress->now("bake");
    return true;
  };
  if (options.moving) pipeline.moving = MovingTextures::planned;
  pipeline.bake = {options.threads, options.states == 2, options.margin, [&](std::uint64_t done) {
                     progress->add(done);
                     stop_if_interrupted();
                   }};
  try {
    return make_micromaps(scene, pipeline);
  } catch (const std::invalid_argument& error) {
    // Before the plan is printed, the budget is at fault; after that, the file.
    if (progress) throw EnvironmentError(fmt::format("{}: {}", scene.file, error.what()));
    throw UsageError(fmt::format("--memory {}: {}", wanted.memory, error.what()));
  }
}

bool is_fault(const Result& result) {
  return result.verdict == proofs::Verdict::refuted || result.verdict == proofs::Verdict::broken;
}

/// Runs the laws and prints their results as they come, without --details the faults alone; `how`: the setting that
/// decides which cases they have.
Report ran(const std::vector<Job>& jobs, const SceneOptions& options, std::FILE* out,
           const std::string& how) {
  TextReport text(out, false);
  const bool all = options.details || !options.subject.empty();
  RunOptions run;
  run.threads = options.threads;
  run.seed = options.seed;
  run.show_progress = !options.quiet;
  run.mutants = false;
  proofs::Identity identity;
  if (!options.journal.empty()) identity = identity_of(jobs, run);
  identity.emplace_back("samples", how);
  const auto journal = open_journal(options.journal, std::move(identity), {});
  run.journal = journal.get();
  const Report report = run_jobs(jobs, run, [&](const Result& r) {
    if (all || is_fault(r)) text.add(r);
  });
  if (all || std::any_of(report.results.begin(), report.results.end(), is_fault)) text.finish(report, false);
  if (report.interrupted && journal)
    say(stderr, "stopped; the same command goes on from {}\n", options.journal);
  return report;
}

/// Judges another baker on the scene, and compares it with ours.
int judged(const proofs::scene::Data& data, const proofs::bake::BakeSubjectPtr& baker,
           const SceneOptions& options, Output& output) {
  const proofs::scene::SubjectMaps maps(data, baker);
  const proofs::scene::SubjectLaws laws = proofs::scene::subject_laws(maps, command(options));
  if (!options.replay.empty()) return replayed(laws.jobs, options);
  say(output.text(), "\nlaws on the maps of {}\n", baker->name());
  if (laws.jobs.empty())
    throw UsageError(
        fmt::format("--subject {}: its declared support covers no triangle of this scene", baker->name()));
  const Report report = ran(laws.jobs, options, output.text(), "all");
  const SubjectFigures figures{baker->name(), maps.totals()};
  print_subject(output.text(), figures);
  output.json(report, scene_json(nullptr, data.scene, data.plan, {}, figures));
  refuse_nothing(report);
  return exit_code(report);
}

/// A GLB by the name of a .gltf would be taken for JSON by the tools that go by names.
void refuse_text_name(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".gltf")
    throw UsageError(fmt::format("-o {}: a GLB is written, in one file; name it .glb", name));
}

/// The letters and digits of a name, others as _.
std::string file_name_of(const std::string& name) {
  std::string all;
  for (const char c : name.substr(0, 64)) all += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return all;
}

/// Writes a picture of each material's maps.
void write_pictures(const SceneFigures& figures, const SceneOptions& options, std::FILE* out) {
  if (options.picture.empty()) return;
  constexpr std::uint32_t longest = 1024;
  for (const MaterialFigures& one : figures.materials) {
    const auto picture =
        material_picture(figures.scene, figures.made.plan, figures.made.baked, one.material, longest);
    if (!picture) continue;
    const std::string& name = figures.scene.materials[one.material].name;
    const auto path =
        std::filesystem::path(options.picture) /
        fmt::format("material_{}{}.png", one.material, name.empty() ? "" : "_" + file_name_of(name));
    OutputFile file(path.string());
    commit_png(file, picture->width, picture->height, picture->rgb);
    say(out, "  {:<10}{}\n", "picture", path.generic_string());
    stop_if_interrupted();
  }
}

/// Refuses options that cannot go together.
void refuse_conflicts(const SceneOptions& options) {
  refuse_text_name(options.glb);
  refuse_same_file({{"the scene", options.file},
                    {"--json", options.json},
                    {"--plot", options.plot},
                    {"-o", options.glb},
                    {"--journal", options.journal}});
  if (options.asks && options.states == 2) throw UsageError("--asks: with --states 2 no shader is asked");
  if (std::error_code none; !options.glb.empty() && std::filesystem::is_directory(options.file, none))
    throw UsageError("-o: a folder of textures is no scene to write");
}

/// Runs the laws on a baked scene; prints and writes the results.
int reported(const proofs::scene::Data& data, const SceneMicromaps& made, double load_seconds,
             const SceneOptions& options, Output& output) {
  const Scene& loaded = data.scene;
  const proofs::scene::SceneLaws laws =
      options.no_laws ? proofs::scene::SceneLaws()
                      : proofs::scene::scene_laws(data, sample_of(options.effort, data, options.threads),
                                                  command(options));
  if (!options.replay.empty()) return replayed(laws.jobs, options);
  const SceneFigures figures{loaded,
                             made,
                             sizes(loaded, made.plan, made.baked, made.arrays, options.threads),
                             vq2_footprint(made.squares, stop_if_interrupted),
                             vq4_footprint(made.squares, stop_if_interrupted),
                             load_seconds,
                             options.states == 2,
                             options.level != "auto",
                             material_figures(loaded, made.plan, made.baked),
                             at_levels(loaded, made.plan, options)};
  if (options.details) {
    print_left_out(output.text(), laws.left_out);
    print_figures(output.text(), figures);
    print_materials(output.text(), figures, options.asks);
    print_levels(output.text(), figures);
    if (!options.no_laws) say(output.text(), "\nlaws on this scene\n");
  } else {
    for (const std::string& note : loaded.notes) say(output.text(), "note: {}\n", printable(note));
  }
  std::fflush(output.text());
  const Report report =
      options.no_laws ? Report() : ran(laws.jobs, options, output.text(), word_of(options.effort));
  if (const auto note = proofs::scene::rationals_text(laws)) say(output.text(), "note: {}\n", *note);
  if (!options.details) {
    print_summary(output.text(), figures, report, options.asks, options.file,
                  {options.moving, baking(options), levels(options), options.glb});
    if (options.asks) print_materials(output.text(), figures, options.asks);
    print_levels(output.text(), figures);
  }
  output.glb(made.plan, loaded, made.arrays);
  write_pictures(figures, options, output.text());
  output.plot(figures);
  output.json(report, scene_json(&figures, loaded, made.plan, laws.left_out));
  return exit_code(report);
}

int scene(const SceneOptions& options) {
  refuse_conflicts(options);
  const auto baker = options.subject.empty() ? nullptr : parse_baker(options.subject, options.timeout);
  const InterruptGuard guard;
  need_folder("--picture", options.picture);
  Output output(options);
  const LevelRequest wanted = request(options);
  const auto start = std::chrono::steady_clock::now();
  const Scene loaded = loaded_scene(options.file);
  refuse_files_of(options.file, {{"--json", options.json},
                                 {"--plot", options.plot},
                                 {"-o", options.glb},
                                 {"--journal", options.journal}});
  const double load_seconds = seconds_since(start);
  const SceneMicromaps made = micromaps_of(loaded, wanted, options, output);
  if (made.plan.triangles.empty()) {
    output.glb(made.plan, loaded, {});
    output.json(nothing_to_bake(), scene_json(nullptr, loaded, made.plan, {}));
    return complete;
  }
  const proofs::scene::Data data{loaded,     made.plan,    made.baked,     made.arrays,
                                 made.pairs, made.squares, options.margin, options.states == 2};
  if (baker) return judged(data, baker, options, output);
  return reported(data, made, load_seconds, options, output);
}

void add_replay(CLI::App& command, SceneOptions& options, std::initializer_list<CLI::Option*> others) {
  auto* const replay =
      command.add_option("--replay", options.replay, "show one case of a law again")->type_name("LAW");
  replay->needs(command.add_option("--case", options.at, "the case of --replay")
                    ->type_name("LEVEL@CASE")
                    ->needs(replay));
  for (CLI::Option* const written : others) replay->excludes(written);
}

void add_subject(CLI::App& command, SceneOptions& options, std::initializer_list<CLI::Option*> others) {
  auto* const subject =
      command
          .add_option("--subject", options.subject,
                      "judge this baker's 4-state maps of the scene, and time it, in the place of ours")
          ->type_name("NAME|FILE.so");
  for (CLI::Option* const of_ours : others) subject->excludes(of_ours);
  command.add_option("--timeout", options.timeout, "seconds that the subject may take for a triangle")
      ->check(finite_within(0.01, 86400));
}

/// Takes "2%" or "2" for 0.02.
std::string percent_within_0_to_100(const std::string& text) {
  const std::string number = text.ends_with("%") ? text.substr(0, text.size() - 1) : text;
  double percent = -1;
  if (!CLI::detail::lexical_cast(number, percent) || !(percent >= 0 && percent <= 100))
    throw CLI::ValidationError(fmt::format("{:.40}: write a share such as 2%, from 0% to 100%", text));
  return fmt::format("{}", percent / 100);
}

/// The options for who looks at maps.
void add_artists(CLI::App& command, SceneOptions& options) {
  command
      .add_option("--asks", options.asks,
                  "name the coarsest level that leaves so much of the area to shaders")
      ->type_name("PERCENT")
      ->transform(percent_within_0_to_100);
  command
      .add_option("--picture", options.picture, "draw each material's maps on its texture, in this folder")
      ->type_name("FOLDER");
  command.add_flag("--details", options.details, "also the plan, all sizes, each law and each material");
}

}  // namespace

Action add_scene(CLI::App& program) {
  auto* command = program.add_subcommand(
      "scene", "plan and bake the micromaps of a glTF scene, and run the laws on them");
  auto options = std::make_shared<SceneOptions>();
  command
      ->add_option("file", options->file,
                   "the scene, or a folder of textures; without it the suite's own, a plant and a fence")
      ->type_name("FILE.gltf|FILE.glb|FOLDER");
  auto* const output =
      command
          ->add_option("-o,--output", options->glb,
                       "write the scene with its micromaps: glTF with EXT_mesh_opacity_micromap")
          ->type_name("OUT.glb");
  command->add_option("--level", options->level, "level of every triangle; auto: its highest useful one")
      ->type_name("N|auto");
  command
      ->add_option("--level-limit", options->level_limit, "the finest level that the device takes; of auto")
      ->check(whole_within(0, finest_level));
  command->add_option("--memory", options->memory, "bytes that all maps may take; levels are lowered to fit")
      ->check(fits_a_size)
      ->transform(CLI::AsSizeValue(false));
  auto* const states = command->add_option("--states", options->states, "2: force-2-state of every map")
                           ->check(CLI::IsMember({2, 4}));
  command
      ->add_option(
          "--margin", options->margin,
          "texels by which micro-triangles are dilated along both axes; sampler: 5/1024, for 8-bit weights")
      ->transform(CLI::Transformer(std::map<std::string, float>{{"sampler", sampler_margin}}))
      ->check(finite_within(0, 64));
  command->add_flag("--moving", options->moving,
                    "bake also triangles whose UVs an animation moves: O and T hold wherever it moves them");
  add_artists(*command, *options);
  add_effort(*command, options->effort);
  auto* const no_laws = command->add_flag("--no-laws", options->no_laws, "bake, without the laws");
  auto* const sizes = command
                          ->add_option("--sizes", options->sizes,
                                       "also the sizes with every triangle at each of these levels")
                          ->type_name("A..B");
  auto* const plot =
      command
          ->add_option("--plot", options->plot, "draw what shaders are called for against bytes, and --sizes")
          ->check(plot_name)
          ->type_name("FILE.svg|FILE.png");
  auto* const json = command->add_option("--json", options->json, "write the results as JSON; - is stdout")
                         ->type_name("FILE|-");
  command
      ->add_option("--journal", options->journal,
                   "keep what the laws have done here; the same command goes on from it")
      ->type_name("FILE");
  command->add_option("--seed", options->seed, "seed of every sample")->check(fits_64_bits);
  command
      ->add_option("--threads", options->threads,
                   "worker threads; as many as the machine has where not given")
      ->check(whole_within(1, 1024));
  add_replay(*command, *options, {json, output, plot, sizes, no_laws});
  add_subject(*command, *options, {states, output, sizes, no_laws});
  command->add_flag("--quiet", options->quiet, "no progress");
  return [options] { return scene(*options); };
}

}  // namespace mmverify::cli
