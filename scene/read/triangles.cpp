#include "scene/read/triangles.hpp"

namespace mmverify::scene {

std::vector<Triangle> triangles(Topology topology, std::span<const std::uint32_t> v) {
  std::vector<Triangle> all;
  const std::size_t count = topology == Topology::list ? v.size() / 3 : v.size() < 3 ? 0 : v.size() - 2;
  all.reserve(count);
  for (std::size_t i = 0; i < count; ++i) switch (topology) {
      case Topology::list: all.push_back({v[3 * i], v[3 * i + 1], v[3 * i + 2]}); break;
      case Topology::strip: all.push_back({v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]}); break;
      case Topology::fan: all.push_back({v[i + 1], v[i + 2], v[0]}); break;
    }
  return all;
}

}  // namespace mmverify::scene
