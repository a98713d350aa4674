#include "display/render/scene/forms.hpp"

#include <algorithm>

#include "display/render/bitmask.hpp"

namespace mmverify::render {
namespace {

class Makes {
 public:
  Makes(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
        const FormsOptions& options)
      : scene_(scene), plan_(plan), world_(world), options_(options) {}

  bool wants(Method method) const {
    return std::find(options_.wanted.begin(), options_.wanted.end(), method) != options_.wanted.end();
  }

  void squares(const std::function<void(const FormsOfMaps&)>& visit) const {
    begins("square maps", 0);
    const scene::Pairs pairs = scene::pairs(scene_, plan_);
    const scene::SquareMaps maps = scene::square_maps(scene_, plan_, pairs, {.threads = options_.threads});
    const Squares squares = squares_of(world_, plan_, pairs, maps);
    FormsOfMaps made;
    for (const Method method : {Method::vq2, Method::vq4})
      if (wants(method)) made.forms.push_back({method, {}, opacity_of(method, squares)});
    visit(made);
  }

  void bitmask(const std::function<void(const FormsOfMaps&)>& visit) const {
    begins("bitmask", 0);
    FormsOfMaps made;
    made.forms.push_back({Method::bitmask, {}, bitmask_of(world_.world, options_.states)});
    visit(made);
  }

  void at_level(unsigned level, const std::function<void(const FormsOfMaps&)>& visit) const {
    const std::vector<unsigned> levels(plan_.triangles.size(), level);
    begins("bake level " + std::to_string(level),
           impl::micromap::micro_triangles(level) * plan_.triangles.size());
    const scene::Baked baked =
        scene::bake(scene_, plan_, levels,
                    {.threads = options_.threads, .two_state = options_.states == 2, .done = options_.done});
    const Micromaps micromaps = micromaps_of(world_, plan_, scene::arrays(plan_, baked));
    FormsOfMaps made;
    made.predicted = scene::any_hit_shares(scene_, plan_, baked).known();
    made.flat = opacity_of(Method::flat, micromaps);
    for (const Method method : methods)
      if (has_levels(method) && wants(method))
        made.forms.push_back({method, level, opacity_of(method, micromaps)});
    visit(made);
  }

 private:
  void begins(const std::string& what, std::uint64_t of) const {
    if (options_.begins) options_.begins(what, of);
  }

  const scene::Scene& scene_;
  const scene::Plan& plan_;
  const SceneWorld& world_;
  const FormsOptions& options_;
};

}  // namespace

LeftOut each_forms(const scene::Scene& scene, const scene::Plan& plan, const SceneWorld& world,
                   const FormsOptions& options, const std::function<void(const FormsOfMaps&)>& visit) {
  if (plan.triangles.empty()) return {};
  const Makes makes(scene, plan, world, options);
  if (makes.wants(Method::vq2) || makes.wants(Method::vq4)) makes.squares(visit);
  if (makes.wants(Method::bitmask)) makes.bitmask(visit);
  if (std::none_of(options.wanted.begin(), options.wanted.end(), has_levels)) return {};
  for (unsigned level = options.first; level <= options.last; ++level) {
    const std::uint64_t bytes = scene::map_bytes_at_level(plan, level);
    if (bytes > options.memory) return {level, bytes};
    makes.at_level(level, visit);
  }
  return {};
}

}  // namespace mmverify::render
