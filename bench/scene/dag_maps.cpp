#include "bench/scene/dag_maps.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "impl/micromap/reorder.hpp"
#include "scene/bake/surface_baker.hpp"

namespace mmverify::bench {

using impl::micromap::Format;
using Map = std::vector<std::uint8_t>;

std::vector<MapUse> map_uses(const scene::Plan& plan) {
  std::vector<MapUse> uses;
  std::map<std::pair<std::uint32_t, scene::VertexOrder>, std::size_t> numbers;
  for (const scene::PlannedPrimitive& primitive : plan.primitives)
    for (const scene::TriangleUse& use : primitive.triangles) {
      const auto [found, is_new] = numbers.try_emplace({use.triangle, use.order}, uses.size());
      if (is_new) uses.push_back({use.triangle, use.order, 0});
      ++uses[found->second].triangles;
    }
  return uses;
}

SceneMaps::SceneMaps(const scene::Scene& scene, const scene::Plan& plan)
    : plan_(plan), uses_(map_uses(plan)) {
  for (const scene::Surface& surface : plan.surfaces) bakers_.push_back(scene::surface_baker(scene, surface));
}

std::size_t SceneMaps::fitting(std::uint32_t level, std::uint64_t budget) const {
  const std::uint64_t each =
      impl::micromap::packed_bytes(impl::micromap::micro_triangles(level), Format::four_state);
  return static_cast<std::size_t>(
      std::clamp<std::uint64_t>(budget / each, 1, std::max<std::uint64_t>(uses_.size(), 1)));
}

std::vector<Map> SceneMaps::baked(std::uint32_t level, std::size_t taken,
                                  const std::function<void()>& stop) const {
  const std::uint64_t bytes =
      impl::micromap::packed_bytes(impl::micromap::micro_triangles(level), Format::four_state);
  std::vector<Map> maps;
  Map other(bytes);
  for (std::size_t j = 0; j < taken; ++j) {
    if (stop) stop();
    const MapUse& use = uses_[use_of(j, taken)];
    const scene::PlannedTriangle& planned = plan_.triangles[use.triangle];
    const auto& uv = planned.uvs;
    Map& map = maps.emplace_back(bytes);
    bakers_[planned.surface].bake({{{uv[0][0], uv[0][1]}, {uv[1][0], uv[1][1]}, {uv[2][0], uv[2][1]}}}, level,
                                  map);
    if (use.order == scene::VertexOrder{0, 1, 2}) continue;
    impl::micromap::reorder(map, level, Format::four_state, use.order, other);
    map.swap(other);
  }
  return maps;
}

MapsAtLevel SceneMaps::in_format(std::uint32_t level, Format format, const std::vector<Map>& baked) const {
  const std::uint64_t states = impl::micromap::micro_triangles(level);
  MapsAtLevel in{level, impl::micromap::bits(format), baked.size(), 0, {}, {}};
  for (std::size_t j = 0; j < baked.size(); ++j) {
    Map map = baked[j];
    if (format == Format::two_state) {
      map.resize(impl::micromap::packed_bytes(states, format));
      impl::micromap::force2(baked[j], states, map);
    }
    if (impl::micromap::uniform(map, format, states)) {
      ++in.uniform;
      continue;
    }
    in.maps.push_back(std::move(map));
    in.triangles.push_back(uses_[use_of(j, baked.size())].triangles);
  }
  return in;
}

}  // namespace mmverify::bench
