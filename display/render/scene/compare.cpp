#include "display/render/scene/compare.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "display/render/picture.hpp"
#include "scene/flip/flip.hpp"

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

/// Keeps the least times of a frame that is traced in several rounds.
template <class Figures, class Frame>
void keep_least(Figures& figures, const Frame& frame, unsigned round) {
  figures.seconds = round == 0 ? frame.seconds : std::min(figures.seconds, frame.seconds);
  figures.cpu_seconds = round == 0 ? frame.cpu_seconds : std::min(figures.cpu_seconds, frame.cpu_seconds);
}

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

class Comparison {
 public:
  Comparison(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
             const Tracer& tracer, const Camera& camera, const CompareOptions& options)
      : scene_(scene), plan_(plan), world_(world), tracer_(tracer), camera_(camera), options_(options) {
    trace_ = options.trace;
    trace_.done = options.done;
  }

  Compared all() {
    texture_alone();
    const LeftOut left_out = each_forms(scene_, plan_, world_, options_.forms(),
                                        [this](const FormsOfMaps& maps) { held_against(maps); });
    compared_.first_left_out = left_out.first;
    compared_.wanted_bytes = left_out.bytes;
    return std::move(compared_);
  }

 private:
  unsigned rounds() const { return std::max(1u, options_.repeats); }
  void begins(const std::string& what, std::uint64_t frames) const {
    if (options_.begins) options_.begins(what, std::uint64_t{trace_.width} * trace_.height * frames);
  }
  BlendFrame blend_frame(const Opacity* opacity, BlendedBy by) const {
    Blending blending = *options_.blending;
    blending.by = by;
    return tracer_.blend_frame(camera_, opacity, blending, trace_);
  }

  void texture_alone() {
    MethodFigures figures{.times_texture = 1};
    figures.bytes = texel_bytes(scene_, plan_);
    begins(std::string(name_of(Method::texture)), rounds());
    for (unsigned k = 0; k < rounds(); ++k)
      keep_least(figures, texture_ = tracer_.frame(camera_, nullptr, trace_), k);
    figures.counts = texture_.counts;
    compared_.methods.push_back(figures);
    if (options_.frame) options_.frame(figures, texture_);
    if (!options_.blending) return;
    BlendFigures blends{.times_texture = 1};
    begins("texture, blending", rounds());
    for (unsigned k = 0; k < rounds(); ++k)
      keep_least(blends, blended_texture_ = blend_frame(nullptr, BlendedBy::shader), k);
    blends.counts = blended_texture_.counts;
    blends.spoiled = spoiled_as_met(blended_texture_);
    compared_.blends.push_back(blends);
    if (options_.blend_frame) options_.blend_frame(blends, blended_texture_);
  }

  /// Mean FLIP of a frame's picture beside the texture's.
  double flip_of(const Frame& frame) const {
    const Picture right = seen(world_.world, texture_, options_.colours),
                  its = seen(world_.world, frame, options_.colours);
    return flip::mean(flip::error_map({right.width, right.height, right.rgb},
                                      {its.width, its.height, its.rgb}, {.threads = options_.trace.threads}));
  }

  /// The other load of the machine changes from minute to minute.  So each round traces the texture's frame
  /// again beside all forms.
  void held_against(const FormsOfMaps& maps) {
    const std::string of = maps.predicted ? "level " + std::to_string(*maps.forms.front().level)
                                          : std::string(name_of(maps.forms.front().method));
    std::optional<double> even;
    if (maps.predicted) {
      begins("even rays", 0);
      even = tracer_.even_rays(*maps.flat, options_.even_rays, options_.seed, options_.trace.threads).known();
    }
    begins(of, (maps.forms.size() + 1) * rounds());
    MethodFigures texture;
    std::vector<MethodFigures> figures(maps.forms.size());
    std::vector<Frame> frames(maps.forms.size());
    for (unsigned k = 0; k < rounds(); ++k) {
      keep_least(texture, tracer_.frame(camera_, nullptr, trace_), k);
      for (std::size_t f = 0; f < maps.forms.size(); ++f)
        keep_least(figures[f], frames[f] = tracer_.frame(camera_, maps.forms[f].opacity.get(), trace_), k);
    }
    std::optional<std::size_t> whole;  // the first form of the same maps
    for (std::size_t f = 0; f < maps.forms.size(); ++f) {
      MethodFigures& its = figures[f];
      its.method = maps.forms[f].method;
      its.level = maps.forms[f].level;
      its.counts = frames[f].counts;
      its.bytes = maps.forms[f].opacity->bytes();
      its.differing = differing(texture_, frames[f]);
      its.times_texture = ratio(its.cpu_seconds, texture.cpu_seconds);
      if (options_.states == 2) {
        its.flip = flip_of(frames[f]);
        if (its.method != Method::special) {
          its.apart = differing(frames[whole.value_or(f)], frames[f]);
          whole = whole.value_or(f);
        }
      }
      if (its.method != Method::special) its.predicted = maps.predicted, its.even = even;
      compared_.methods.push_back(its);
      if (options_.frame) options_.frame(its, frames[f]);
    }
    if (options_.blending) blends_held_against(maps, of);
  }

  void blends_held_against(const FormsOfMaps& maps, const std::string& of) {
    constexpr BlendedBy ways[] = {BlendedBy::shader, BlendedBy::fixed};
    constexpr std::size_t count = std::size(ways);
    begins(of + ", blending", (count * maps.forms.size() + 1) * rounds());
    BlendFigures texture;
    std::vector<BlendFigures> figures(count * maps.forms.size());
    std::vector<BlendFrame> frames(figures.size());
    for (unsigned k = 0; k < rounds(); ++k) {
      keep_least(texture, blend_frame(nullptr, BlendedBy::shader), k);
      for (std::size_t f = 0; f < figures.size(); ++f)
        keep_least(figures[f], frames[f] = blend_frame(maps.forms[f / count].opacity.get(), ways[f % count]),
                   k);
    }
    const auto calls = static_cast<double>(compared_.blends.front().counts.shader);
    for (std::size_t f = 0; f < figures.size(); ++f) {
      BlendFigures& its = figures[f];
      its.method = maps.forms[f / count].method;
      its.level = maps.forms[f / count].level;
      its.by = ways[f % count];
      its.counts = frames[f].counts;
      its.differing = differing(blended_texture_, frames[f]);
      its.spoiled = spoiled_as_met(frames[f]);
      if (calls > 0) its.saved = 1 - static_cast<double>(its.counts.shader) / calls;
      its.times_texture = ratio(its.cpu_seconds, texture.cpu_seconds);
      compared_.blends.push_back(its);
      if (options_.blend_frame) options_.blend_frame(its, frames[f]);
    }
  }

  const scene::Scene& scene_;
  const scene::Plan& plan_;
  const SceneWorld& world_;
  const Tracer& tracer_;
  const Camera& camera_;
  const CompareOptions& options_;
  TraceOptions trace_;
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
