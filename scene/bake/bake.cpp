#include "scene/bake/bake.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "scene/bake/surface_baker.hpp"
#include "scene/bake/varying_alpha.hpp"

namespace mmverify::scene {
namespace {

using impl::micromap::Format;
using impl::micromap::State;

std::string name_of(const Scene& scene, std::size_t image) {
  return std::to_string(image) +
         (scene.images[image].name.empty() ? "" : " (" + scene.images[image].name + ")");
}

/// Stores the map in the fewest bits that hold it.
void keep(BakedTriangle& baked, impl::micromap::Bytes map, bool two_state) {
  const std::uint64_t count = impl::micromap::micro_triangles(baked.level);
  baked.states = impl::micromap::count_states(map, Format::four_state, count);
  if (two_state) {
    baked.states = {baked.states[0] + baked.states[2], baked.states[1] + baked.states[3], 0, 0};
  }
  for (std::size_t code = 0; code < 4; ++code)
    if (baked.states[code] == count) baked.uniform = static_cast<State>(code);
  if (baked.uniform) return;
  if (baked.states[2] + baked.states[3] != 0) {
    baked.map = std::move(map);
    return;
  }
  baked.format = Format::two_state;
  impl::micromap::Bytes two(impl::micromap::packed_bytes(count, Format::two_state));
  impl::micromap::force2(map, count, two);
  baked.map = std::move(two);
}

/// The bakers of the surfaces.  Errors: std::invalid_argument, which names the image.
std::vector<impl::bake::TriangleBaker> bakers_of(const Scene& scene, const Plan& plan, float margin) {
  std::vector<impl::bake::TriangleBaker> bakers;
  for (const Surface& surface : plan.surfaces) {
    try {
      bakers.push_back(surface_baker(scene, surface, margin));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("bake: image " + name_of(scene, surface.image) + ": " + error.what());
    }
  }
  return bakers;
}

}  // namespace

Baked bake(const Scene& scene, const Plan& plan, std::span<const unsigned> levels,
           const BakeOptions& options) {
  if (levels.size() != plan.triangles.size())
    throw std::invalid_argument("bake: levels for another number of triangles");
  const std::vector<impl::bake::TriangleBaker> bakers = bakers_of(scene, plan, options.margin);
  const VaryingAlphaBakers varying(scene, plan, options.margin);
  Baked all;
  all.triangles.resize(plan.triangles.size());
  std::vector<impl::bake::BakeCounts> counts(plan.triangles.size());
  // The finest triangles are first, so that the last one to end is small.
  std::vector<std::size_t> order(plan.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&levels](std::size_t a, std::size_t b) { return levels[a] > levels[b]; });
  const auto one = [&](std::size_t number) {
    const PlannedTriangle& planned = plan.triangles[number];
    BakedTriangle& baked = all.triangles[number];
    baked.level = levels[number];
    const std::uint64_t count = impl::micromap::micro_triangles(baked.level);
    impl::micromap::Bytes map(impl::micromap::packed_bytes(count, Format::four_state));
    const auto& uv = planned.uvs;
    const Uv& travel = plan.surfaces[planned.surface].travel;
    baked.by_bounds = planned.varies();
    try {
      if (baked.by_bounds)
        varying.bake(planned, baked.level, map);
      else
        counts[number] = bakers[planned.surface].bake_moving(
            {{{{uv[0][0], uv[0][1]}, {uv[1][0], uv[1][1]}, {uv[2][0], uv[2][1]}}}, travel[0], travel[1]},
            baked.level, map);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(error.what() + std::string(": UVs (") + std::to_string(uv[0][0]) + ", " +
                                  std::to_string(uv[0][1]) + ") on image " +
                                  name_of(scene, plan.surfaces[planned.surface].image));
    }
    counts[number].micro_triangles = count;
    keep(baked, std::move(map), options.two_state);
    if (options.done) options.done(count);
  };
  oneapi::tbb::task_arena arena(options.threads == 0 ? oneapi::tbb::task_arena::automatic
                                                     : static_cast<int>(options.threads));
  arena.execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<std::size_t>(0, order.size(), 1),
        [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
          for (std::size_t k = range.begin(); k != range.end(); ++k) one(order[k]);
        },
        oneapi::tbb::simple_partitioner());
  });
  for (const impl::bake::BakeCounts& c : counts) {
    all.counts.micro_triangles += c.micro_triangles;
    all.counts.leaves += c.leaves;
    all.counts.exact += c.exact;
  }
  return all;
}

}  // namespace mmverify::scene
