#include "bench/scene/bake.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <variant>

#include "bench/bake/obvious.hpp"
#include "bench/timing.hpp"
#include "scene/bake/surface_baker.hpp"
#include "scene/read/load.hpp"

namespace mmverify::bench {
namespace {

namespace fast = impl::bake;
namespace scene = mmverify::scene;

fast::BaseTriangle base_of(const scene::UvTriangle& uv) {
  return {{{uv[0][0], uv[0][1]}, {uv[1][0], uv[1][1]}, {uv[2][0], uv[2][1]}}};
}

/// Samples the centres of the planned triangles that have bytes of alpha; returns the number of these.
std::size_t sample_centres(const SceneBakeOptions& options, const scene::Scene& loaded,
                           const scene::Plan& planned, std::uint32_t level,
                           std::vector<std::uint8_t>& states) {
  std::size_t sampled = 0;
  for (const scene::PlannedTriangle& t : planned.triangles) {
    if (options.stop) options.stop();
    const scene::Surface& surface = planned.surfaces[t.surface];
    const scene::Image& image = loaded.images[surface.image];
    const auto* const alpha = std::get_if<std::vector<std::uint8_t>>(&image.alpha);
    if (alpha == nullptr) continue;
    ++sampled;
    bake_centre({{alpha->data(), image.width, image.height, image.width}, double{surface.cutoff}},
                base_of(t.uvs), level, states);
  }
  return sampled;
}

SceneBakeLevel level_figures(const SceneBakeOptions& options, const scene::Scene& loaded,
                             const scene::Plan& planned, const std::vector<fast::TriangleBaker>& bakers,
                             std::uint32_t level) {
  const std::size_t count = std::size_t{1} << 2 * level;
  std::vector<std::uint8_t> map((count + 3) / 4), states(count);
  const auto bake_all = [&] {
    for (const scene::PlannedTriangle& t : planned.triangles) {
      if (options.stop) options.stop();
      bakers[t.surface].bake(base_of(t.uvs), level, map);
    }
  };
  std::size_t sampled = 0;
  const auto sample_all = [&] { sampled = sample_centres(options, loaded, planned, level, states); };
  // Both take turns for the same time, so that other load on the machine disturbs both.
  std::vector<double> ours, centres;
  const auto sum = [](const std::vector<double>& ns) { return std::accumulate(ns.begin(), ns.end(), 0.0); };
  while (ours.size() < options.rounds ||
         (ours.size() < options.most_rounds && sum(ours) < options.seconds * 1e9)) {
    ours.push_back(once_ns(bake_all));
    if (sum(centres) < sum(ours)) centres.push_back(once_ns(sample_all));
  }
  const auto of = [count](double ns, std::size_t triangles) {
    return ns / static_cast<double>(triangles * count);
  };
  const auto fastest = [](const std::vector<double>& of_rounds) {
    return *std::min_element(of_rounds.begin(), of_rounds.end());
  };
  const std::size_t triangles = planned.triangles.size();
  return {level,
          triangles * count,
          ours.size(),
          of(median(ours), triangles),
          of(fastest(ours), triangles),
          sampled == 0 ? 0 : of(fastest(centres), sampled)};
}

}  // namespace

SceneBakeFigures scene_bake_figures(const SceneBakeOptions& options) {
  if (options.rounds == 0 || options.rounds > options.most_rounds || options.first > options.last ||
      options.last > fast::max_bake_level)
    throw std::invalid_argument(
        "bake bench: a round at least, and no more at least than at most; levels up to 12");
  const auto begins = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  begins(options.file);
  const scene::Scene loaded = scene::load(options.file);
  const scene::Plan planned = scene::plan(loaded);
  SceneBakeFigures figures{options.file,
                           planned.triangles.size(),
                           0,
                           {},
                           triangles_left_out(loaded, planned, scene::LeftOut::varying_alpha)};
  if (planned.triangles.empty()) return figures;
  std::vector<fast::TriangleBaker> bakers;
  figures.ready_ms = median_ns(options.rounds,
                               [&] {
                                 bakers.clear();
                                 for (const scene::Surface& surface : planned.surfaces)
                                   bakers.push_back(scene::surface_baker(loaded, surface));
                               }) /
                     1e6;
  for (std::uint32_t level = options.first; level <= options.last; ++level) {
    begins("level " + std::to_string(level));
    figures.levels.push_back(level_figures(options, loaded, planned, bakers, level));
  }
  return figures;
}

}  // namespace mmverify::bench
