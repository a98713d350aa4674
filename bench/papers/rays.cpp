#include "bench/papers/rays.hpp"

#include <fmt/format.h>

#include "bench/scene/view_tables.hpp"
#include "display/render/scene/colours_of.hpp"
#include "display/render/scene/compare.hpp"
#include "display/render/scene/views.hpp"
#include "scene/read/load.hpp"
#include "scene/read/shading.hpp"
#include "scene/sample/scene.hpp"

namespace mmverify::bench::papers {
namespace {

constexpr std::uint32_t width = 320, height = 240;
constexpr float aspect = static_cast<float>(width) / height;

/// A scene made ready for rays.
struct Traced {
  render::SceneWorld world;
  render::Tracer tracer;
  render::Camera camera;

  explicit Traced(const PlannedScene& of)
      : world(render::world_of(of.scene, of.uses, of.plan)),
        tracer(world.world),
        camera(render::overview(render::box_of(world.world, true), aspect)) {}
};

render::CompareOptions compare_options(Measured& m, unsigned first, unsigned last,
                                       std::vector<render::Method> wanted) {
  render::CompareOptions options{.first = first, .last = last, .wanted = std::move(wanted)};
  options.trace = {.width = width, .height = height, .threads = m.sources().threads};
  options.even_rays = 1;
  options.begins = [&m](const std::string& what, std::uint64_t) { m.begins("rays, " + what); };
  options.done = [&m](std::uint64_t) { m.stop(); };
  return options;
}

scene::AttributeScene attributes_of(const PlannedScene& of) {
  const scene::Bytes sample = of.file.empty() ? scene::sample_scene() : scene::Bytes();
  return of.file.empty() ? scene::load_attributes(of.name, sample) : scene::load_attributes(of.file);
}

std::vector<scene::PrimitiveShading> shading_of(const PlannedScene& of) {
  const scene::Bytes sample = of.file.empty() ? scene::sample_scene() : scene::Bytes();
  return of.file.empty() ? scene::load_shading(of.name, sample) : scene::load_shading(of.file);
}

std::string ratio_text(double value) { return fmt::format("{:.2f}", value); }

}  // namespace

render::Picture heat_maps(Measured& m, std::size_t at) {
  const PlannedScene& of = m.scenes()[at];
  const Traced traced(of);
  using render::Method;
  render::CompareOptions options = compare_options(m, 6, 6, {Method::vq2, Method::vq4, Method::flat});
  std::vector<render::Picture> maps;
  std::vector<std::string> titles;
  std::uint32_t most = 0;
  options.frame = [&](const render::MethodFigures& figures, const render::Frame& frame) {
    if (most == 0) most = render::scale_of(frame);
    maps.push_back(render::heat(frame, most));
    titles.push_back(fmt::format("{}{}: {}", render::name_of(figures.method),
                                 figures.level ? fmt::format(" {}", *figures.level) : "",
                                 figures.counts.shader));
  };
  render::compare(of.scene, of.plan, traced.world, traced.tracer, traced.camera, options);
  return render::side_by_side(maps, titles, most);
}

render::Picture blended_by_max(Measured& m, std::size_t at) {
  constexpr unsigned colour_level = 3;
  const PlannedScene& of = m.scenes()[at];
  const Traced traced(of);
  const render::ColourMaps colours =
      render::colours_of(of.scene, traced.world, attributes_of(of), render::ColoursOf::faces, colour_level,
                         m.sources().threads, [&m](std::uint64_t) { m.stop(); });
  const render::Blending blending{.operation = impl::traverse::Operation::max, .colours = &colours};
  const render::BlendFrame frame = traced.tracer.blend_frame(
      traced.camera, nullptr, blending,
      {.width = width, .height = height, .threads = m.sources().threads, .done = [&m](std::uint64_t) {
         m.stop();
       }});
  return render::blended(traced.world.world, frame, blending);
}

std::vector<Drawn> views(Measured& m, std::size_t at, const std::vector<unsigned>& levels) {
  constexpr std::uint32_t rays = 2;  ///< along each side of a pixel
  constexpr std::uint64_t most_shown =
      10'000;  ///< triangles: each is baked at each level, seconds for a thousand
  const PlannedScene& of = m.scenes()[at];
  const Traced traced(of);
  const scene::AttributeScene attributes = attributes_of(of);
  const std::vector<scene::PrimitiveShading> shading = shading_of(of);
  const auto stop = [&m] { m.stop(); };
  const render::TraceOptions trace{.width = rays * width,
                                   .height = rays * height,
                                   .threads = m.sources().threads,
                                   .done = [&m](std::uint64_t) { m.stop(); }};
  const render::Frame frame = traced.tracer.frame(traced.camera, nullptr, trace);
  const render::Views shown(of.scene, traced.world, attributes, shading, frame, traced.camera,
                            {.rays = rays, .sun = trace.light, .threads = m.sources().threads, .stop = stop});
  std::vector<Drawn> all;
  if (shown.triangles() == 0 || shown.triangles() > most_shown) return all;
  const render::Picture textures = shown.picture(render::ShownFrom::textures);
  for (const unsigned level : levels)
    for (const render::ShownFrom from : {render::ShownFrom::faces, render::ShownFrom::vertices}) {
      const char* const kind = from == render::ShownFrom::faces ? "faces" : "vertices";
      m.begins(fmt::format("{}, views by {} of level {}", of.name, kind, level));
      const render::Picture maps = shown.picture(from, level);
      const ViewError error = view_error(textures, maps, shown.textured(), m.sources().threads);
      all.push_back({"table 3", fmt::format("view_{}_{}", kind, level),
                     fmt::format("Textures, {} of level {}, FLIP: mean {:.4f}, {:.4f} where a texture shows",
                                 kind, level, error.flip, error.textured_flip),
                     beside(textures, maps, error, width)});
    }
  return all;
}

Grid frame_times(Measured& m) {
  const std::vector<std::size_t> scenes = masked(m);
  Grid grid{{"scene", "method", "level", "calls a ray", "frame over the texture's"}, {}};
  if (!render::has_embree() || scenes.empty()) return grid;
  const PlannedScene& of = m.scenes()[scenes.front()];
  const Traced traced(of);
  using render::Method;
  render::CompareOptions options = compare_options(m, 0, 6, {Method::flat, Method::tree, Method::ranked});
  options.repeats = 3;
  options.trace.threads = 1;
  for (const render::MethodFigures& row :
       render::compare(of.scene, of.plan, traced.world, traced.tracer, traced.camera, options).methods) {
    const double rays = static_cast<double>(row.counts.rays + row.counts.shadow_rays);
    grid.rows.push_back({of.name, std::string(render::name_of(row.method)),
                         row.level ? std::to_string(*row.level) : "",
                         fmt::format("{:.3f}", static_cast<double>(row.counts.shader) / rays),
                         ratio_text(row.times_texture)});
  }
  return grid;
}

}  // namespace mmverify::bench::papers
