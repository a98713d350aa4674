#include "bench/papers/rays.hpp"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "bench/papers/drawings.hpp"
#include "bench/scene/view_tables.hpp"
#include "display/render/scene/colours_of.hpp"
#include "display/render/scene/compare.hpp"
#include "display/render/scene/path.hpp"
#include "display/render/scene/views.hpp"
#include "impl/index/index.hpp"
#include "scene/bake/arrays.hpp"
#include "scene/read/load.hpp"
#include "scene/read/shading.hpp"

namespace mmverify::bench::papers {
namespace {

constexpr std::uint32_t width = 320, height = 240;
constexpr std::uint64_t most_read_bytes = std::uint64_t{1}
                                          << 26;  ///< of maps: a number of 32 bits for each state
constexpr float aspect = static_cast<float>(width) / height;

/// The box around all that a texture tests, or around everything without that.
render::Box framed(const render::World& world) {
  const render::Box tested = render::box_of(world, true);
  return tested.empty ? render::box_of(world, false) : tested;
}

/// A scene made ready for rays.
struct Traced {
  render::SceneWorld world;
  render::Tracer tracer;
  render::Camera camera;

  explicit Traced(const PlannedScene& of)
      : world(render::world_of(of.scene, of.uses, of.plan)),
        tracer(world.world),
        camera(render::overview(framed(world.world), aspect)) {}
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

std::vector<scene::PrimitiveShading> shading_of(const PlannedScene& of) {
  return of.file.empty() ? scene::load_shading(of.name, of.bytes) : scene::load_shading(of.file);
}

/// Flat maps that add up the bits of their trees which Algorithm 3 would read.  For one thread.
class ReadBits final : public render::Opacity {
 public:
  /// The micromaps, whose records have one level, outlive the object.
  explicit ReadBits(const render::Micromaps& micromaps)
      : micromaps_(micromaps), flat_(render::opacity_of(render::Method::flat, micromaps)) {
    for (const impl::micromap::Record& record : micromaps.array.records) {
      const auto format = static_cast<impl::micromap::Format>(record.format);
      const auto bytes = impl::micromap::packed_bytes(impl::micromap::micro_triangles(record.level), format);
      const auto map = std::span(micromaps.array.data).subspan(record.offset, bytes);
      bits_.push_back(bits_read_by_index(record.level, impl::tree::encode_stream(record.level, format, map)));
    }
  }
  std::optional<impl::micromap::State> at(std::uint32_t geometry, std::uint32_t triangle,
                                          const render::Barycentrics& b) const override {
    const auto& codes = micromaps_.codes[geometry];
    if (!codes.empty() && codes[triangle] < bits_.size())
      read_ += bits_[codes[triangle]][impl::index::from_barycentrics(
          b.u, b.v, micromaps_.array.records[codes[triangle]].level)];
    return flat_->at(geometry, triangle, b);
  }
  std::uint64_t bytes() const override { return flat_->bytes(); }
  /// The bits since the last call.
  std::uint32_t taken() const { return static_cast<std::uint32_t>(std::exchange(read_, 0)); }

 private:
  const render::Micromaps& micromaps_;
  std::unique_ptr<render::Opacity> flat_;
  std::vector<std::vector<std::uint32_t>> bits_;  ///< by record and index
  mutable std::uint64_t read_ = 0;
};

/// The 2-state maps of a scene, all of one level.
render::Micromaps two_state_maps(Measured& m, const PlannedScene& of, const render::SceneWorld& world,
                                 unsigned level) {
  scene::BakeOptions options = m.options();
  options.two_state = true;
  const std::vector<unsigned> levels(of.plan.triangles.size(), level);
  return render::micromaps_of(world, of.plan,
                              scene::arrays(of.plan, scene::bake(of.scene, of.plan, levels, options)));
}

/// A figure of each pixel's primary ray.
PixelNumbers by_pixel(Measured& m, const Traced& traced, const render::Opacity* opacity,
                      const std::function<std::uint32_t(const render::Pixel&)>& figure) {
  PixelNumbers numbers{width, height, std::vector<std::uint32_t>(std::size_t{width} * height, 0)};
  const render::TraceOptions options{.width = width, .height = height, .shadows = false};
  for (std::uint32_t y = 0; y < height; ++y) {
    m.stop();
    for (std::uint32_t x = 0; x < width; ++x)
      numbers.of[x + std::size_t{width} * y] =
          figure(traced.tracer.pixel(traced.camera, opacity, options, x, y));
  }
  return numbers;
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

std::vector<Drawn> bits_of_rays(Measured& m, std::size_t at) {
  const PlannedScene& of = m.scenes()[at];
  const Traced traced(of);
  m.begins("bits that rays read");
  const PixelNumbers calls =
      by_pixel(m, traced, nullptr, [](const render::Pixel& p) { return p.by_primary.shader; });
  std::vector<Drawn> all;
  all.push_back(
      {"figure 9", "calls_of_rays", of.name + ": any-hit calls of primary rays by the texture alone",
       render::side_by_side({coloured(calls, calls.most())},
                            {fmt::format("calls: {:.2f} a ray that has any", calls.mean())}, calls.most())});
  for (const unsigned level : {4u, 9u}) {
    if (scene::map_bytes_at_level(of.plan, level) > most_read_bytes) continue;
    const render::Micromaps maps = two_state_maps(m, of, traced.world, level);
    const ReadBits opacity(maps);
    const PixelNumbers bits =
        by_pixel(m, traced, &opacity, [&](const render::Pixel&) { return opacity.taken(); });
    all.push_back(
        {"figure 9", fmt::format("bits_of_rays_level{}", level),
         fmt::format("{}: bits of the 2-state trees that primary rays read, level {}", of.name, level),
         render::side_by_side({coloured(bits, bits.most())},
                              {fmt::format("level {}: {:.0f} bits a ray that reads any", level, bits.mean())},
                              bits.most(), "bits of the trees read or more")});
  }
  return all;
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

namespace {

/// A scene's files, made ready for views.
struct Viewed {
  const PlannedScene& of;
  Traced traced;
  scene::AttributeScene attributes;
  std::vector<scene::PrimitiveShading> shading;
  explicit Viewed(const PlannedScene& scene)
      : of(scene), traced(scene), attributes(attributes_of(scene)), shading(shading_of(scene)) {}
};

constexpr std::uint32_t view_rays = 2;  ///< along each side of a pixel
constexpr std::uint64_t most_shown =
    10'000;  ///< triangles: each is baked at each level, seconds for a thousand

render::Frame view_frame(Measured& m, const Viewed& viewed, std::uint32_t smaller) {
  return viewed.traced.tracer.frame(viewed.traced.camera, nullptr,
                                    {.width = view_rays * width / smaller,
                                     .height = view_rays * height / smaller,
                                     .threads = m.sources().threads,
                                     .done = [&m](std::uint64_t) { m.stop(); }});
}

render::Views views_of(Measured& m, const Viewed& viewed, const render::Frame& frame) {
  return {viewed.of.scene,
          viewed.traced.world,
          viewed.attributes,
          viewed.shading,
          frame,
          viewed.traced.camera,
          {.rays = view_rays, .threads = m.sources().threads, .stop = [&m] { m.stop(); }}};
}

/// The scene whose views fit the budget: the first that shows at most most_shown textured triangles, in pictures whose
/// sides are halved up to `halvings` times if no scene does.  None if no scene shows any.
struct Budgeted {
  std::size_t scene;
  std::uint32_t smaller;
};
std::optional<Budgeted> within_budget(Measured& m) {
  constexpr unsigned halvings = 4;
  for (unsigned k = 0; k <= halvings; ++k)
    for (std::size_t at = 0; at < m.scenes().size(); ++at) {
      m.stop();
      const PlannedScene& of = m.scenes()[at];
      if (render::world_of(of.scene, of.uses, of.plan).world.instances.empty()) continue;
      const Viewed viewed(of);
      const render::Frame frame = view_frame(m, viewed, 1u << k);
      const std::uint64_t shown = views_of(m, viewed, frame).triangles();
      if (shown != 0 && shown <= most_shown) return Budgeted{at, 1u << k};
    }
  return std::nullopt;
}

}  // namespace

std::vector<Drawn> views(Measured& m, const std::vector<unsigned>& levels) {
  m.begins("views");
  const auto chosen = within_budget(m);
  std::vector<Drawn> all;
  if (!chosen) return all;
  const Viewed viewed(m.scenes()[chosen->scene]);
  const render::Frame frame = view_frame(m, viewed, chosen->smaller);
  const render::Views shown = views_of(m, viewed, frame);
  const std::string which =
      fmt::format("{}, {} triangles in view ({} at most)", viewed.of.name, shown.triangles(), most_shown);
  const render::Picture textures = shown.picture(render::ShownFrom::textures);
  const auto draw = [&](render::ShownFrom from, unsigned level, render::Detail detail) {
    const bool cones = detail == render::Detail::cones;
    const char* const kind = from == render::ShownFrom::faces ? "faces" : "vertices";
    m.begins(fmt::format("{}, views by {} of level {}", viewed.of.name, kind, level));
    const render::Picture maps = shown.picture(from, level, detail);
    const ViewError error = view_error(textures, maps, shown.textured(), m.sources().threads);
    all.push_back(
        {cones ? "figure 8" : "table 3", fmt::format("view_{}_{}{}", kind, level, cones ? "_cones" : ""),
         fmt::format("{}: textures, {} of level {}{}, FLIP: mean {:.4f}, {:.4f} where a texture shows", which,
                     kind, level, cones ? " and its mips by ray cones" : "", error.flip, error.textured_flip),
         beside(textures, maps, error, width)});
  };
  for (const unsigned level : levels)
    for (const render::ShownFrom from : {render::ShownFrom::faces, render::ShownFrom::vertices})
      draw(from, level, render::Detail::finest);
  for (const render::ShownFrom from : {render::ShownFrom::faces, render::ShownFrom::vertices})
    draw(from, levels.back(), render::Detail::cones);
  return all;
}

namespace {

constexpr unsigned of_tables = 6;  ///< the level of the paper's tables

render::CompareOptions two_states(Measured& m, std::vector<render::Method> wanted) {
  render::CompareOptions options = compare_options(m, 1, of_tables, std::move(wanted));
  options.states = 2;
  return options;
}

std::vector<render::MethodFigures> compared(const Traced& traced, const PlannedScene& of,
                                            const render::CompareOptions& options) {
  return render::compare(of.scene, of.plan, traced.world, traced.tracer, traced.camera, options).methods;
}

std::string title_of(const render::MethodFigures& row) {
  return row.level                               ? fmt::format("level {}", *row.level)
         : row.method == render::Method::texture ? "texture"
                                                 : "bitmask";
}

}  // namespace

render::Picture two_state_pictures(Measured& m, std::size_t at) {
  const PlannedScene& of = m.scenes()[at];
  const Traced traced(of);
  std::vector<render::Picture> pictures;
  std::vector<std::string> titles;
  render::CompareOptions options = two_states(m, {render::Method::flat, render::Method::bitmask});
  options.frame = [&](const render::MethodFigures& figures, const render::Frame& frame) {
    pictures.push_back(render::seen(traced.world.world, frame));
    titles.push_back(title_of(figures) + (figures.flip ? fmt::format(": FLIP {:.4f}", *figures.flip) : ""));
  };
  compared(traced, of, options);
  return render::side_by_side(pictures, titles, 0);
}

Grid two_state_figures(Measured& m) {
  const std::vector<std::size_t> scenes = masked(m);
  Grid grid{{"scene", "picture by", "pixels unlike the texture's", "FLIP", "any-hit calls", "bytes"}, {}};
  if (!render::has_embree() || scenes.empty()) return grid;
  const PlannedScene& of = m.scenes()[scenes.front()];
  const Traced traced(of);
  for (const render::MethodFigures& row :
       compared(traced, of, two_states(m, {render::Method::flat, render::Method::bitmask})))
    grid.rows.push_back({of.name, title_of(row), std::to_string(row.differing),
                         row.flip ? fmt::format("{:.4f}", *row.flip) : "0", std::to_string(row.counts.shader),
                         std::to_string(row.bytes)});
  return grid;
}

Grid bitmask_times(Measured& m) {
  const std::vector<std::size_t> scenes = masked(m);
  Grid grid{{"scene", "method", "calls a ray", "bytes", "frame over the texture's"}, {}};
  if (!render::has_embree() || scenes.empty()) return grid;
  const PlannedScene& of = m.scenes()[scenes.front()];
  const Traced traced(of);
  for (const unsigned states : {2u, 4u}) {
    render::CompareOptions options = compare_options(m, of_tables, of_tables, {render::Method::bitmask});
    options.states = states;
    options.repeats = 3;
    options.trace.threads = 1;
    for (const render::MethodFigures& row : compared(traced, of, options))
      if (row.method == render::Method::bitmask)
        grid.rows.push_back({of.name, fmt::format("bitmask, {}-state", states),
                             fmt::format("{:.3f}", calls_a_ray(row.counts)), std::to_string(row.bytes),
                             ratio_text(row.times_texture)});
  }
  return grid;
}

Grid viewpoint_means(Measured& m) {
  constexpr std::uint64_t cameras = 4;
  constexpr unsigned ambient = 4;
  const std::vector<std::size_t> scenes = masked(m);
  Grid grid{{"scene", "method", "calls a ray: mean", "least", "most", "deviation", "over the texture's: mean",
             "least", "most", "deviation"},
            {}};
  if (!render::has_embree() || scenes.empty()) return grid;
  const PlannedScene& of = m.scenes()[scenes.front()];
  const Traced traced(of);
  using render::Method;
  render::CompareOptions options =
      compare_options(m, of_tables, of_tables, {Method::flat, Method::tree, Method::ranked, Method::bitmask});
  options.trace.threads = 1;
  options.trace.ambient = ambient;
  const render::Path path = render::along_path(of.scene, of.plan, traced.world, traced.tracer,
                                               options.forms(), options.trace, 1, cameras);
  for (const render::PathRow& row : path.rows) {
    std::vector<std::string> cells{of.name, std::string(name_of(row.method))};
    for (const std::vector<double>& figure : {row.calls_a_ray, row.times_texture}) {
      const render::Spread spread = render::spread_of(figure);
      for (const double value : {spread.mean, spread.least, spread.most, spread.deviation})
        cells.push_back(fmt::format("{:.3f}", value));
    }
    grid.rows.push_back(std::move(cells));
  }
  return grid;
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
  for (const render::MethodFigures& row : compared(traced, of, options))
    grid.rows.push_back({of.name, std::string(render::name_of(row.method)),
                         row.level ? std::to_string(*row.level) : "",
                         fmt::format("{:.3f}", calls_a_ray(row.counts)), ratio_text(row.times_texture)});
  return grid;
}

}  // namespace mmverify::bench::papers
