#include "cli/views/views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "bench/scene/view_tables.hpp"
#include "cli/arguments/arguments.hpp"
#include "cli/bench/tables.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/png_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/scene/loaded.hpp"
#include "proofs/engine/interrupt.hpp"
#include "scene/attribute/footprint.hpp"
#include "scene/read/load.hpp"

namespace mmverify::cli {
namespace {

namespace file_of = mmverify::scene;

/// The greatest width of a view, since three are put in one picture.
constexpr std::uint32_t longest_view = 1024;

/// The most rays in a frame, which takes about 64 bytes a ray.
constexpr std::uint64_t most_rays = std::uint64_t{1} << 26;

/// The parts of a file that are shaded.
struct Loaded {
  file_of::Scene scene;
  std::vector<file_of::MeshUse> uses;
  file_of::AttributeScene attributes;
  std::vector<file_of::PrimitiveShading> shading;
};

Loaded loaded(const std::string& file) {
  const auto made = generated_scene(file);
  if (!made)
    return {loaded_scene(file), file_of::load_uses(file), file_of::load_attributes(file),
            file_of::load_shading(file)};
  return {file_of::load(made->name, made->bytes), file_of::load_uses(made->name, made->bytes),
          file_of::load_attributes(made->name, made->bytes), file_of::load_shading(made->name, made->bytes)};
}

/// Writes FOLDER/NAME.png and returns its path.
std::string written(const std::string& folder, const std::string& name, const render::Picture& picture) {
  const auto path = std::filesystem::path(folder) / (name + ".png");
  OutputFile file(path.string());
  commit_png(file, picture.width, picture.height, picture.rgb);
  return path.generic_string();
}

void check(const ViewArguments& arguments) {
  if (parse_levels(arguments.levels, "--level").last > file_of::finest_attribute_level)
    throw UsageError(fmt::format("--level {}: maps of attributes go up to level {}", arguments.levels,
                                 file_of::finest_attribute_level));
  const std::uint64_t rays = arguments.cones ? std::max(arguments.rays, arguments.reference) : arguments.rays;
  if (arguments.cones && arguments.reference % arguments.rays != 0)
    throw UsageError(fmt::format("--reference {}: more rays than --rays {}, and a multiple of them",
                                 arguments.reference, arguments.rays));
  const auto [width, height] = arguments.size;
  if (rays * width > 16384 || rays * height > 16384 || rays * rays * width * height > most_rays)
    throw UsageError(
        fmt::format("--size {}x{}, --rays {}: too many rays; at most 16384 along a side and 2^26 in a view",
                    width, height, rays));
  if (std::error_code none; std::filesystem::is_directory(arguments.file, none))
    throw UsageError(
        fmt::format("views {}: a folder of textures has no triangles; name a glTF file", arguments.file));
  if (!render::has_embree()) throw EnvironmentError("views: " + render::embree_text());
}

void tell(const ViewArguments& arguments, const std::string& what) {
  if (!arguments.quiet) say(stderr, "views: {}\n", what);
}

/// Compares the views of each level with the textures' view `right`, and writes their pictures.
void add_rows(bench::ViewFigures& figures, const render::Views& views, const render::Picture& right,
              const proofs::Levels& levels, const ViewArguments& arguments) {
  using render::Detail, render::ShownFrom;
  for (const std::uint8_t pixel : views.textured()) figures.textured_pixels += pixel;
  if (!arguments.pictures.empty()) written(arguments.pictures, "textures", right);
  const auto add = [&](ShownFrom from, unsigned level, Detail detail) {
    const std::string name = fmt::format("{}_level{}{}", from == ShownFrom::faces ? "faces" : "vertices",
                                         level, detail == Detail::cones ? "_cones" : "");
    tell(arguments, name);
    const render::Picture maps = views.picture(from, level, detail);
    bench::ViewRow row{
        from, level, detail, bench::view_error(right, maps, views.textured(), arguments.threads), {}};
    if (!arguments.pictures.empty())
      row.file = written(arguments.pictures, name, bench::beside(right, maps, row.error, longest_view));
    row.error.map.clear();
    figures.rows.push_back(std::move(row));
  };
  for (unsigned level = levels.first; level <= levels.last; ++level)
    for (const ShownFrom from : {ShownFrom::faces, ShownFrom::vertices}) {
      add(from, level, Detail::finest);
      if (arguments.cones) add(from, level, Detail::cones);
    }
}

render::Camera camera_of(const render::World& world, const ViewArguments& arguments) {
  const float aspect = static_cast<float>(arguments.size.width) / static_cast<float>(arguments.size.height);
  const render::Box box = render::box_of(world, false);
  return arguments.camera == 0 ? render::overview(box, aspect)
                               : render::on_path(box, arguments.seed, arguments.camera, aspect);
}

/// Traces and shades views of a scene from one camera.  What the constructor takes outlives it.
class Viewer {
 public:
  Viewer(const Loaded& read, const render::SceneWorld& world, const ViewArguments& arguments)
      : read_(read),
        world_(world),
        arguments_(arguments),
        tracer_(world.world),
        camera_(camera_of(world.world, arguments)) {}

  render::Frame traced(std::uint32_t rays) const {
    return tracer_.frame(camera_, nullptr,
                         {.width = rays * arguments_.size.width,
                          .height = rays * arguments_.size.height,
                          .threads = arguments_.threads,
                          .shadows = !arguments_.no_shadows,
                          .done = [](std::uint64_t) { stop(); }});
  }
  render::Views views(const render::Frame& frame, std::uint32_t rays) const {
    return {read_.scene,
            world_,
            read_.attributes,
            read_.shading,
            frame,
            camera_,
            {.rays = rays, .shading = arguments_.shading, .threads = arguments_.threads, .stop = stop}};
  }

 private:
  static void stop() {
    if (proofs::interrupted()) throw proofs::Interrupted();
  }

  const Loaded& read_;
  const render::SceneWorld& world_;
  const ViewArguments& arguments_;
  render::Tracer tracer_;
  render::Camera camera_;
};

}  // namespace

int render_views(const ViewArguments& arguments) {
  check(arguments);
  const proofs::Levels levels = parse_levels(arguments.levels, "--level");
  need_folder("--pictures", arguments.pictures);
  JsonOutput json(arguments.json);
  const proofs::InterruptGuard guard;
  const Loaded read = loaded(arguments.file);
  const render::SceneWorld world = render::world_of(read.scene, read.uses, file_of::plan(read.scene));
  if (world.world.instances.empty())
    throw EnvironmentError(fmt::format("{}: no triangle to render", read.scene.file));
  const Viewer viewer(read, world, arguments);
  tell(arguments, "rays");
  const render::Frame frame = viewer.traced(arguments.rays);
  const render::Views views = viewer.views(frame, arguments.rays);
  if (views.triangles() == 0)
    throw UsageError(
        fmt::format("{}: no ray met a triangle with a texture, so nothing was compared; another --camera or "
                    "--size would do",
                    read.scene.file));

  bench::ViewFigures figures{.file = read.scene.file,
                             .embree = render::embree_text(),
                             .triangles = file_of::count_triangles(read.scene).unique,
                             .textured_triangles = views.triangles(),
                             .width = arguments.size.width,
                             .height = arguments.size.height,
                             .rays = arguments.rays,
                             .reference = arguments.cones ? arguments.reference : 0,
                             .shading = arguments.shading,
                             .camera = arguments.camera,
                             .seed = arguments.seed,
                             .threads = arguments.threads,
                             .rows = {}};
  render::Picture right = views.picture(render::ShownFrom::textures);
  if (arguments.cones) {
    tell(arguments, "the view with more rays");
    const render::Frame finer = viewer.traced(arguments.reference);
    const render::Picture reference =
        viewer.views(finer, arguments.reference).picture(render::ShownFrom::textures);
    figures.textures = bench::view_error(reference, right, views.textured(), arguments.threads);
    right = reference;
  }
  add_rows(figures, views, right, levels, arguments);
  const bench::Result result = bench::view_tables(figures);
  print_result(json.text(), result);
  json.write([&] { return result_json(result); });
  return complete;
}

}  // namespace mmverify::cli
