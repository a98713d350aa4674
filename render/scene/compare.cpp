#include "render/scene/compare.hpp"

#include <algorithm>
#include <set>

namespace mmverify::render {
namespace {

std::uint64_t texel_bytes(const scene::Scene& scene, const scene::Plan& plan) {
  std::set<std::size_t> images;
  for (const scene::Surface& surface : plan.surfaces) images.insert(surface.image);
  std::uint64_t bytes = 0;
  for (const std::size_t k : images)
    bytes += std::uint64_t{scene.images[k].width} * scene.images[k].height *
             static_cast<unsigned>(scene.images[k].bits()) / 8;
  return bytes;
}

class Comparison {
 public:
  Comparison(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
             const Tracer& tracer, const Camera& camera, const CompareOptions& options)
      : scene_(scene), plan_(plan), world_(world), tracer_(tracer), camera_(camera), options_(options) {}

  Compared all() {
    MethodFigures texture;
    texture.bytes = texel_bytes(scene_, plan_);
    add(texture, nullptr);
    if (plan_.triangles.empty()) return std::move(compared_);
    if (wants(Method::vq2) || wants(Method::vq4)) squares();
    if (std::any_of(options_.wanted.begin(), options_.wanted.end(), has_levels))
      for (unsigned level = options_.first; level <= options_.last; ++level) {
        const std::uint64_t bytes = scene::map_bytes_at_level(plan_, level);
        if (bytes > options_.memory) {
          compared_.first_left_out = level;
          compared_.wanted_bytes = bytes;
          break;
        }
        at_level(level);
      }
    return std::move(compared_);
  }

 private:
  bool wants(Method method) const {
    return std::find(options_.wanted.begin(), options_.wanted.end(), method) != options_.wanted.end();
  }
  void begins(const std::string& what, std::uint64_t of) const {
    if (options_.begins) options_.begins(what, of);
  }

  void squares() {
    begins("square maps", 0);
    const scene::Pairs pairs = scene::pairs(scene_, plan_);
    const scene::SquareMaps maps =
        scene::square_maps(scene_, plan_, pairs, {.threads = options_.trace.threads});
    const Squares squares = squares_of(world_, plan_, pairs, maps);
    for (const Method method : {Method::vq2, Method::vq4})
      if (wants(method)) add({.method = method}, opacity_of(method, squares).get());
  }

  void at_level(unsigned level) {
    const std::vector<unsigned> levels(plan_.triangles.size(), level);
    begins("bake level " + std::to_string(level),
           impl::micromap::micro_triangles(level) * plan_.triangles.size());
    const scene::Baked baked =
        scene::bake(scene_, plan_, levels, {.threads = options_.trace.threads, .done = options_.done});
    const Micromaps micromaps = micromaps_of(world_, plan_, scene::arrays(plan_, baked));
    const double predicted = scene::any_hit_shares(scene_, plan_, baked).known();
    begins("even rays", 0);
    const double even = tracer_
                            .even_rays(*opacity_of(Method::flat, micromaps), options_.even_rays,
                                       options_.seed, options_.trace.threads)
                            .known();
    for (const Method method : methods)
      if (has_levels(method) && wants(method)) {
        const auto opacity = opacity_of(method, micromaps);
        MethodFigures figures{.method = method, .level = level};
        if (method != Method::special) {
          figures.predicted = predicted;
          figures.even = even;
        }
        add(figures, opacity.get());
      }
  }

  void add(MethodFigures figures, const Opacity* opacity) {
    if (opacity != nullptr) figures.bytes = opacity->bytes();
    TraceOptions trace = options_.trace;
    trace.done = options_.done;
    const std::string name = std::string(name_of(figures.method)) +
                             (figures.level ? " level " + std::to_string(*figures.level) : "");
    Frame frame;
    const unsigned repeats = std::max(1u, options_.repeats);
    begins(name, std::uint64_t{trace.width} * trace.height * repeats);
    for (unsigned k = 0; k < repeats; ++k) {
      frame = tracer_.frame(camera_, opacity, trace);
      figures.seconds = k == 0 ? frame.seconds : std::min(figures.seconds, frame.seconds);
      figures.cpu_seconds = k == 0 ? frame.cpu_seconds : std::min(figures.cpu_seconds, frame.cpu_seconds);
    }
    figures.counts = frame.counts;
    if (compared_.methods.empty()) texture_ = frame;
    figures.differing = differing(texture_, frame);
    compared_.methods.push_back(figures);
    const double texture = compared_.methods.front().cpu_seconds;
    compared_.methods.back().times_texture = texture > 0 ? figures.cpu_seconds / texture : 0;
    if (options_.frame) options_.frame(compared_.methods.back(), frame);
    if (!options_.blending) return;
    add_blends(figures, BlendedBy::shader, opacity);
    if (opacity != nullptr) add_blends(figures, BlendedBy::fixed, opacity);
  }

  void add_blends(const MethodFigures& of, BlendedBy by, const Opacity* opacity) {
    BlendFigures figures{.method = of.method, .level = of.level, .by = by};
    Blending blending = *options_.blending;
    blending.by = by;
    TraceOptions trace = options_.trace;
    trace.done = options_.done;
    BlendFrame frame;
    for (unsigned k = 0; k < std::max(1u, options_.repeats); ++k) {
      begins(std::string(name_of(of.method)) + ", blending", std::uint64_t{trace.width} * trace.height);
      frame = tracer_.blend_frame(camera_, opacity, blending, trace);
      figures.seconds = k == 0 ? frame.seconds : std::min(figures.seconds, frame.seconds);
      figures.cpu_seconds = k == 0 ? frame.cpu_seconds : std::min(figures.cpu_seconds, frame.cpu_seconds);
    }
    figures.counts = frame.counts;
    if (compared_.blends.empty()) blended_texture_ = frame;
    figures.differing = differing(blended_texture_, frame);
    figures.spoiled = spoiled_as_met(frame);
    compared_.blends.push_back(figures);
    const BlendFigures& texture = compared_.blends.front();
    BlendFigures& last = compared_.blends.back();
    if (texture.counts.shader > 0)
      last.saved = 1 - static_cast<double>(last.counts.shader) / static_cast<double>(texture.counts.shader);
    if (texture.cpu_seconds > 0) last.times_texture = last.cpu_seconds / texture.cpu_seconds;
    if (options_.blend_frame) options_.blend_frame(last, frame);
  }

  const scene::Scene& scene_;
  const scene::Plan& plan_;
  const SceneWorld& world_;
  const Tracer& tracer_;
  const Camera& camera_;
  const CompareOptions& options_;
  Frame texture_;
  BlendFrame blended_texture_;
  Compared compared_;
};

}  // namespace

Compared compare(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                 const Tracer& tracer, const Camera& camera, const CompareOptions& options) {
  return Comparison(scene, plan, world, tracer, camera, options).all();
}

}  // namespace mmverify::render
