#include "cli/views/views.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

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
#include "scene/sample/scene.hpp"

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
  if (!file.empty())
    return {loaded_scene(file), file_of::load_uses(file), file_of::load_attributes(file),
            file_of::load_shading(file)};
  const file_of::Bytes bytes = file_of::sample_scene();
  return {loaded_scene(file), file_of::load_uses(sample_name, bytes),
          file_of::load_attributes(sample_name, bytes), file_of::load_shading(sample_name, bytes)};
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
  const std::uint64_t rays = arguments.rays;
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

/// Compares the views of each level with the textures', and writes their pictures.
void add_rows(bench::ViewFigures& figures, const render::Views& views, const proofs::Levels& levels,
              const ViewArguments& arguments) {
  for (const std::uint8_t pixel : views.textured()) figures.textured_pixels += pixel;
  const render::Picture textures = views.picture(render::ShownFrom::textures);
  if (!arguments.pictures.empty()) written(arguments.pictures, "textures", textures);
  for (unsigned level = levels.first; level <= levels.last; ++level)
    for (const render::ShownFrom from : {render::ShownFrom::faces, render::ShownFrom::vertices}) {
      const std::string name =
          fmt::format("{}_level{}", from == render::ShownFrom::faces ? "faces" : "vertices", level);
      tell(arguments, name);
      const render::Picture maps = views.picture(from, level);
      bench::ViewRow row{
          from, level, bench::view_error(textures, maps, views.textured(), arguments.threads), {}};
      if (!arguments.pictures.empty())
        row.file = written(arguments.pictures, name, bench::beside(textures, maps, row.error, longest_view));
      row.error.map.clear();
      figures.rows.push_back(std::move(row));
    }
}

render::Camera camera_of(const render::World& world, const ViewArguments& arguments) {
  const float aspect = static_cast<float>(arguments.size.width) / static_cast<float>(arguments.size.height);
  const render::Box box = render::box_of(world, false);
  return arguments.camera == 0 ? render::overview(box, aspect)
                               : render::on_path(box, arguments.seed, arguments.camera, aspect);
}

}  // namespace

int render_views(const ViewArguments& arguments) {
  check(arguments);
  const proofs::Levels levels = parse_levels(arguments.levels, "--level");
  need_folder("--pictures", arguments.pictures);
  JsonOutput json(arguments.json);
  const proofs::InterruptGuard guard;
  const auto stop = [] {
    if (proofs::interrupted()) throw proofs::Interrupted();
  };

  const Loaded read = loaded(arguments.file);
  const render::SceneWorld world = render::world_of(read.scene, read.uses, file_of::plan(read.scene));
  if (world.world.instances.empty())
    throw EnvironmentError(fmt::format("{}: no triangle to render", read.scene.file));
  const render::Tracer tracer(world.world);
  const render::Camera camera = camera_of(world.world, arguments);
  tell(arguments, "rays");
  const render::TraceOptions trace{.width = arguments.rays * arguments.size.width,
                                   .height = arguments.rays * arguments.size.height,
                                   .threads = arguments.threads,
                                   .shadows = !arguments.no_shadows,
                                   .done = [&](std::uint64_t) { stop(); }};
  const render::Frame frame = tracer.frame(camera, nullptr, trace);
  const render::Views views(read.scene, world, read.attributes, read.shading, frame, camera,
                            {.rays = arguments.rays,
                             .shading = arguments.shading,
                             .sun = trace.light,
                             .threads = arguments.threads,
                             .stop = stop});
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
                             .shading = arguments.shading,
                             .camera = arguments.camera,
                             .seed = arguments.seed,
                             .threads = arguments.threads,
                             .rows = {}};
  add_rows(figures, views, levels, arguments);
  const bench::Result result = bench::view_tables(figures);
  print_result(json.text(), result);
  json.write([&] { return result_json(result); });
  return complete;
}

}  // namespace mmverify::cli
