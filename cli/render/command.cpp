// mmverify render: traces a scene's rays, with any-hit shaders by texture and by micromaps.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "bench/scene/render_tables.hpp"
#include "cli/arguments/arguments.hpp"
#include "cli/bench/tables.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/png_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/render/path.hpp"
#include "cli/render/picture_size.hpp"
#include "cli/scene/loaded.hpp"
#include "display/render/picture.hpp"
#include "display/render/scene/colours_of.hpp"
#include "display/render/scene/compare.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/progress.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read/load.hpp"

namespace mmverify::cli {
namespace {

using proofs::Interrupted;
using proofs::InterruptGuard;
using proofs::Progress;

struct RenderOptions {
  std::string file, level = "6", picture, heat, json;
  std::vector<std::string> methods{"all"};
  std::string blend, colours;
  unsigned colour_level = 3;
  PictureSize size;
  std::uint64_t camera = 0, cameras = 0, seed = 1, memory = std::uint64_t{1} << 30;
  unsigned threads = 0, repeats = 1, states = 4, ambient = 0;
  bool no_shadows = false, quiet = false;
};

bool has_unknown_regions(render::Method method) {
  return method == render::Method::vq2 || method == render::Method::vq4;
}

std::vector<render::Method> wanted_methods(const std::vector<std::string>& names, unsigned states) {
  std::vector<render::Method> wanted;
  for (const std::string& name : names) {
    if (name == "all") {
      std::vector<render::Method> all(std::begin(render::methods), std::end(render::methods));
      if (states == 2) std::erase_if(all, has_unknown_regions);
      return all;
    }
    const auto method = render::method_of(name);
    if (!method)
      throw UsageError(fmt::format(
          "--method {}: it is one of texture, special, flat, tree, ranked, vq2, vq4, bitmask and all", name));
    if (states == 2 && has_unknown_regions(*method))
      throw UsageError(
          fmt::format("--method {}: square maps have unknown regions; leave --states 2 out", name));
    wanted.push_back(*method);
  }
  return wanted;
}

std::vector<mmverify::scene::MeshUse> uses_of(const std::string& file) {
  using namespace mmverify::scene;
  if (const auto made = generated_scene(file)) return load_uses(made->name, made->bytes);
  return load_uses(file);
}

void commit(OutputFile& file, const render::Picture& picture) {
  commit_png(file, picture.width, picture.height, picture.rgb);
}

/// The reason why equal pictures are no evidence; empty if methods were compared with the texture.
std::string vacuous(const render::Compared& compared, const mmverify::scene::Plan& plan,
                    const std::vector<render::Method>& wanted) {
  const auto asks = [](render::Method method) { return method != render::Method::texture; };
  if (std::none_of(wanted.begin(), wanted.end(), asks)) return {};
  if (plan.triangles.empty()) return "no triangle has opacity to test by micromaps, so nothing was compared";
  if (compared.methods.size() == 1) return "no method was compared; give more --memory or a lower --level";
  if (compared.methods.front().counts.planned == 0)
    return "no ray met a triangle with micromaps, so nothing was compared; another --camera or --size would "
           "do";
  return {};
}

/// The pictures of a run, each below its method and a figure.
class Tiles {
 public:
  void add(const render::MethodFigures& of, const std::string& figure, render::Picture picture) {
    pictures_.push_back(std::move(picture));
    titles_.push_back(fmt::format("{}{}: {}", render::name_of(of.method),
                                  of.level ? fmt::format(" {}", *of.level) : "", figure));
  }
  /// `most`: the end of a heat map's scale, else 0.
  render::Picture beside_each_other(std::uint32_t most) const {
    return render::side_by_side(pictures_, titles_, most);
  }
  bool empty() const { return pictures_.empty(); }
  /// Whether the picture fits: PNG allows sides up to 32768; four pictures make a row.
  bool fit(std::uint32_t height) const {
    return (std::uint64_t{height} + 40) * (pictures_.size() / 4 + 1) < 32000;
  }

 private:
  std::vector<render::Picture> pictures_;
  std::vector<std::string> titles_;
};

render::Camera camera_of(const render::World& world, const RenderOptions& options) {
  const float aspect = static_cast<float>(options.size.width) / static_cast<float>(options.size.height);
  render::Box box = render::box_of(world, true);
  if (box.empty) box = render::box_of(world, false);
  return options.camera == 0 ? render::overview(box, aspect)
                             : render::on_path(box, options.seed, options.camera, aspect);
}

/// The operations whose payload does not depend on the order of hits.
constexpr std::array<std::pair<const char*, mmverify::impl::traverse::Operation>, 3> operations{
    {{"max", mmverify::impl::traverse::Operation::max},
     {"min", mmverify::impl::traverse::Operation::min},
     {"add", mmverify::impl::traverse::Operation::add}}};

std::optional<mmverify::impl::traverse::Operation> wanted_operation(const std::string& name) {
  if (name.empty()) return std::nullopt;
  for (const auto& [known, operation] : operations)
    if (name == known) return operation;
  throw UsageError(fmt::format(
      "--blend {:.40}: it is one of max, min and add, which give one payload in any order of hits", name));
}

std::optional<render::ColoursOf> wanted_colours(const RenderOptions& options) {
  if (options.colours.empty() && options.blend.empty()) return std::nullopt;
  if (options.colours.empty() || options.colours == "faces") return render::ColoursOf::faces;
  if (options.colours == "vertices") return render::ColoursOf::vertices;
  throw UsageError(fmt::format("--colours {:.40}: it is one of faces and vertices", options.colours));
}

mmverify::scene::AttributeScene attributes_of(const std::string& file) {
  using namespace mmverify::scene;
  if (const auto made = generated_scene(file)) return load_attributes(made->name, made->bytes);
  return load_attributes(file);
}

proofs::Levels levels_of_maps(const std::string& text) {
  const proofs::Levels levels = parse_levels(text, "--level");
  if (levels.last > mmverify::scene::finest_level)
    throw UsageError(fmt::format("--level {}: maps go up to level {}", text, mmverify::scene::finest_level));
  return levels;
}

void tell_scene(bench::RenderFigures& figures, const mmverify::scene::Scene& scene,
                const mmverify::scene::Plan& plan, const render::SceneWorld& world) {
  const auto triangles = mmverify::scene::count_triangles(scene);
  const auto tested = mmverify::scene::counts(plan);
  figures.file = scene.file;
  figures.triangles = triangles.unique;
  figures.placed = triangles.placed;
  figures.tested = tested.unique;
  figures.tested_placed = tested.placed;
  figures.unplanned = world.unplanned;
}

void tell_options(bench::RenderFigures& figures, const RenderOptions& options) {
  figures.width = options.size.width;
  figures.height = options.size.height;
  figures.camera = options.camera;
  figures.seed = options.seed;
  figures.threads = options.threads;
  figures.embree = render::embree_text();
  figures.operation = options.blend;
  figures.states = options.states;
  figures.ambient = options.ambient;
}

bool some_pixel_differs(const bench::RenderFigures& figures) {
  const auto differs = [](const auto& run) { return run.differing != 0; };
  if (figures.states == 2)
    return std::any_of(figures.methods.begin(), figures.methods.end(),
                       [](const render::MethodFigures& run) { return run.apart.value_or(0) != 0; });
  return std::any_of(figures.methods.begin(), figures.methods.end(), differs) ||
         std::any_of(figures.blends.begin(), figures.blends.end(), differs);
}

void tell_colours(bench::RenderFigures& figures, const render::ColourMaps& colours,
                  const RenderOptions& options) {
  figures.colours = colours.of() == render::ColoursOf::faces ? "faces" : "vertices";
  figures.colour_level = options.colour_level;
  figures.colour_bytes = colours.bytes();
}

void refuse_what_cannot_be_rendered(const RenderOptions& options) {
  refuse_same_file({{"the scene", options.file},
                    {"-o", options.picture},
                    {"--heat", options.heat},
                    {"--json", options.json}});
  if (std::error_code none; std::filesystem::is_directory(options.file, none))
    throw UsageError(
        fmt::format("render {}: a folder of textures has no triangles; name a glTF file", options.file));
  if (!render::has_embree()) throw EnvironmentError("render: " + render::embree_text());
}

/// The pictures that a run is asked for: what the last method saw, or each of 2 states, and the heat maps of all.
class Pictures {
 public:
  explicit Pictures(const RenderOptions& options) : options_(options) {
    if (!options.picture.empty()) seen_file_.emplace(options.picture);
    if (!options.heat.empty()) heat_file_.emplace(options.heat);
  }
  /// Draws each frame of the comparison. `compared`, its colours and `world` outlive the run.
  void draw_frames_of(render::CompareOptions& compared, const render::World& world) {
    compared.blend_frame = [this, &compared, &world](const render::BlendFigures&,
                                                     const render::BlendFrame& frame) {
      if (seen_file_) seen_ = render::blended(world, frame, *compared.blending);
    };
    compared.frame = [this, &compared, &world](const render::MethodFigures& figures,
                                               const render::Frame& frame) {
      if (seen_file_ && !compared.blending) {
        seen_ = render::seen(world, frame, compared.colours);
        if (options_.states == 2 && two_states_.fit(options_.size.height))
          two_states_.add(figures, fmt::format("{} differ", figures.differing), *seen_);
      }
      if (!heat_file_ || !heat_maps_.fit(options_.size.height)) return;
      if (heat_maps_.empty()) most_ = render::scale_of(frame);
      heat_maps_.add(figures, std::to_string(figures.counts.shader), render::heat(frame, most_));
    };
  }
  void write(bench::RenderFigures& figures) {
    if (seen_file_) {
      commit(*seen_file_, two_states_.empty() ? *seen_ : two_states_.beside_each_other(0));
      figures.pictures.push_back({options_.blend.empty() ? "seen" : "blended", options_.picture});
    }
    if (heat_file_) {
      commit(*heat_file_, heat_maps_.beside_each_other(most_));
      figures.pictures.push_back({"heat", options_.heat});
    }
  }

 private:
  const RenderOptions& options_;
  std::optional<OutputFile> seen_file_, heat_file_;
  std::optional<render::Picture> seen_;
  Tiles heat_maps_, two_states_;
  std::uint32_t most_ = 1;  ///< the scale of heat maps, which the first one sets
};

render::CompareOptions compare_options(const proofs::Levels& levels,
                                       const std::vector<render::Method>& wanted,
                                       const RenderOptions& options) {
  render::CompareOptions compared{.first = levels.first, .last = levels.last, .wanted = wanted};
  compared.trace = {.width = options.size.width,
                    .height = options.size.height,
                    .threads = options.threads,
                    .shadows = !options.no_shadows,
                    .ambient = options.ambient,
                    .seed = options.seed};
  compared.states = options.states;
  compared.repeats = options.repeats;
  compared.seed = options.seed;
  compared.memory = options.memory;
  return compared;
}

/// Shows the steps of a comparison, and stops it at an interrupt.
void show_progress(render::CompareOptions& compared, std::optional<Progress>& progress, bool quiet) {
  compared.begins = [&progress, quiet](const std::string& what, std::uint64_t of) {
    progress.reset();
    progress.emplace(of, !quiet);
    progress->now(what);
    if (proofs::interrupted()) throw Interrupted();
  };
  compared.done = [&progress](std::uint64_t count) {
    progress->add(count);
    if (proofs::interrupted()) throw Interrupted();
  };
}

/// The plan of a scene.  Says how many triangles it leaves out because their vertex alpha varies.
mmverify::scene::Plan planned(const mmverify::scene::Scene& scene) {
  constexpr auto why = mmverify::scene::LeftOut::varying_alpha;
  mmverify::scene::Plan plan = mmverify::scene::plan(scene);
  if (const std::uint64_t triangles = triangles_left_out(scene, plan, why); triangles != 0)
    say(stderr, "render: {} triangles are left out of the plan, and their texture alone is tested: {}\n",
        grouped(triangles), sentence(why));
  return plan;
}

int render_scene(const RenderOptions& options) {
  const proofs::Levels levels = levels_of_maps(options.level);
  const std::vector<render::Method> wanted = wanted_methods(options.methods, options.states);
  const auto operation = wanted_operation(options.blend);
  const auto colours_of = wanted_colours(options);
  refuse_what_cannot_be_rendered(options);
  JsonOutput json(options.json);
  Pictures pictures(options);
  const InterruptGuard guard;
  const mmverify::scene::Scene scene = loaded_scene(options.file);
  const auto uses = uses_of(options.file);
  const mmverify::scene::Plan plan = planned(scene);
  const render::SceneWorld world = render::world_of(scene, uses, plan);
  if (world.world.instances.empty())
    throw EnvironmentError(fmt::format("{}: no triangle to render", scene.file));
  const render::Tracer tracer(world.world);
  const render::Camera camera = camera_of(world.world, options);

  std::optional<Progress> progress;
  render::CompareOptions compared = compare_options(levels, wanted, options);
  show_progress(compared, progress, options.quiet);
  if (options.cameras != 0) {
    return render_path(
        {scene, plan, world, tracer, options.cameras, options.seed, json, [&progress] { progress.reset(); }},
        compared);
  }
  std::optional<render::ColourMaps> colours;
  if (colours_of) {
    compared.begins("colours", mmverify::scene::count_triangles(scene).unique);
    colours = render::colours_of(scene, world, attributes_of(options.file), *colours_of, options.colour_level,
                                 options.threads, compared.done);
  }
  compared.colours = colours ? &*colours : nullptr;
  if (operation) compared.blending = render::Blending{.operation = *operation, .colours = compared.colours};
  pictures.draw_frames_of(compared, world.world);
  bench::RenderFigures figures;
  std::string nothing;
  try {
    const render::Compared all = render::compare(scene, plan, world, tracer, camera, compared);
    progress.reset();
    if (all.first_left_out)
      say(stderr, "render: maps of level {} would take {} bytes, more than --memory; left out from here on\n",
          *all.first_left_out, grouped(all.wanted_bytes));
    nothing = vacuous(all, plan, wanted);
    figures.methods = all.methods;
    figures.blends = all.blends;
  } catch (const std::invalid_argument& error) {
    throw EnvironmentError(fmt::format("{}: {}", scene.file, error.what()));
  }
  tell_scene(figures, scene, plan, world);
  tell_options(figures, options);
  if (colours) tell_colours(figures, *colours, options);
  pictures.write(figures);
  const bench::Result result = bench::render_tables(figures);
  print_result(json.text(), result);
  json.write([&] { return result_json(result); });
  if (some_pixel_differs(figures)) return failed;
  if (!nothing.empty()) throw UsageError(fmt::format("{}: {}", scene.file, nothing));
  return complete;
}

/// Adds the options of pictures.
void add_drawing(CLI::App& command, RenderOptions& options) {
  command
      .add_option("--blend", options.blend,
                  "hits on surfaces blend their colours into the ray's payload as well: max, min or add")
      ->type_name("OPERATION");
  command
      .add_option(
          "--colours", options.colours,
          "draw base colours from attribute micromaps, of faces or vertices; --blend without it: faces")
      ->type_name("faces|vertices");
  command.add_option("--colour-level", options.colour_level, "level of these maps; 3 where not given")
      ->check(whole_within(0, 8));
  command
      .add_option("-o,--output", options.picture,
                  "write the picture, of the last method; with --states 2 of each beside the texture's")
      ->check(png_name)
      ->type_name("FILE.png");
  command
      .add_option("--heat", options.heat,
                  "write how often each pixel called an any-hit shader, method by method")
      ->check(png_name)
      ->type_name("FILE.png");
}

/// Adds the options of cameras and of the frames from them; add_drawing() has added its own.
void add_cameras(CLI::App& command, RenderOptions& options) {
  command
      .add_option("--camera", options.camera,
                  "0: all that has alpha-tested triangles; 1, 2, ...: of a random path")
      ->check(whole_within(0, 1'000'000'000));
  auto* const cameras =
      command
          .add_option("--cameras", options.cameras,
                      "law traverse.same_image on the scene: so many cameras of a random path, each of which "
                      "looks at a triangle with micromaps")
          ->check(whole_within(1, 10'000));
  command.add_option("--seed", options.seed, "seed of the random path")->check(fits_64_bits);
  command.add_flag("--no-shadows", options.no_shadows, "no shadow rays");
  command
      .add_option("--ambient-occlusion", options.ambient,
                  "so many rays from each hit, of random directions about its normal, darken the picture")
      ->check(whole_within(1, render::most_ambient))
      ->type_name("N");
  command
      .add_option("--repeat", options.repeats,
                  "rounds of a frame by the texture and by each method; the least time counts")
      ->check(whole_within(1, 1000));
  // Along a path frames are compared, and neither drawn nor timed.
  for (const char* const other :
       {"--camera", "--blend", "--colours", "--colour-level", "--output", "--heat", "--repeat", "--states"})
    cameras->excludes(command.get_option(other));
  command.get_option("--states")->excludes(command.get_option("--blend"));
}

}  // namespace

Action add_render(CLI::App& program) {
  auto* command =
      program.add_subcommand("render",
                             "trace a glTF scene with Embree, any-hit shaders by texture and by micromaps; "
                             "exit 1 where a pixel differs, 2 where nothing was compared");
  auto options = std::make_shared<RenderOptions>();
  command
      ->add_option(
          "file", options->file,
          "the scene; quad: two triangles with two textures; without it the suite's own, a plant and a fence")
      ->type_name("FILE.gltf|FILE.glb");
  command->add_option("--level", options->level, "level of maps; 6 where not given")->type_name("N|A..B");
  command
      ->add_option("--method", options->methods,
                   "how opacity is asked for, beside the texture alone: special, flat, tree, ranked, vq2, "
                   "vq4, bitmask; "
                   "all")
      ->delimiter(',')
      ->type_name("NAME[,NAME...]")
      ->allow_extra_args(false);
  command
      ->add_option("--states", options->states,
                   "2: maps and bitmask without unknown states, whose pictures are not the texture's")
      ->check(CLI::IsMember({2u, 4u}));
  add_drawing(*command, *options);
  command->add_option("--json", options->json, "write the figures as JSON; - is stdout")->type_name("FILE|-");
  add_picture_size(*command, options->size);
  add_cameras(*command, *options);
  command->add_option("--memory", options->memory, "bytes that all maps of a level may take")
      ->check(fits_a_size)
      ->transform(CLI::AsSizeValue(false));
  command
      ->add_option("--threads", options->threads,
                   "worker threads; as many as the machine has where not given")
      ->check(whole_within(1, 1024));
  command->add_flag("--quiet", options->quiet, "no progress");
  return [options, colour_level = command->get_option("--colour-level")] {
    if (colour_level->count() != 0 && options->colours.empty() && options->blend.empty())
      throw UsageError(
          "--colour-level is the level of the maps of --colours or --blend; give one of these, too");
    return render_scene(*options);
  };
}

}  // namespace mmverify::cli
