#include "render/world.hpp"

#include <algorithm>

namespace mmverify::render {

void Box::add(const Point& p) {
  if (empty) low = high = p;
  empty = false;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], p[k]);
    high[k] = std::max(high[k], p[k]);
  }
}

Point placed(const Instance& instance, const Point& p) {
  const auto& m = instance.transform;
  Point out{};
  for (std::size_t row = 0; row < 3; ++row)
    out[row] = m[row] * p[0] + m[row + 3] * p[1] + m[row + 6] * p[2] + m[row + 9];
  return out;
}

Box box_of(const World& world, bool with_surface_only) {
  Box box;
  for (const Instance& instance : world.instances)
    for (const std::uint32_t g : world.meshes[instance.mesh]) {
      const Geometry& geometry = world.geometries[g];
      if (with_surface_only && !geometry.surface) continue;
      for (const auto& triangle : geometry.triangles)
        for (const std::uint32_t vertex : triangle) box.add(placed(instance, geometry.positions[vertex]));
    }
  return box;
}

}  // namespace mmverify::render
