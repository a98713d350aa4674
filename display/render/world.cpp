#include "display/render/world.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

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

bool has_inverse(const Instance& instance, float reach) {
  using Column = std::array<double, 3>;
  const auto column = [&instance](std::size_t c) {
    return Column{instance.transform[3 * c], instance.transform[3 * c + 1], instance.transform[3 * c + 2]};
  };
  const auto product = [](const Column& a, const Column& b) {
    return Column{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto length = [](const Column& a) { return std::hypot(a[0], a[1], a[2]); };
  const Column a = column(0), b = column(1), c = column(2);
  const Column rows[3] = {product(b, c), product(c, a), product(a, b)};
  const double determinant = std::fabs(a[0] * rows[0][0] + a[1] * rows[0][1] + a[2] * rows[0][2]);
  // Embree's determinants are floats, and so are the products in them.
  if (!(determinant >= 0x1p-100 && determinant <= 0x1p100)) return false;
  // If the determinant is smaller, rounding makes up most of the inverse.
  if (determinant < 1e-5 * length(a) * length(b) * length(c)) return false;
  // Embree takes coordinates up to 2^60; a camera may stand 2^12 times as far off as the scene is wide.
  return std::all_of(std::begin(rows), std::end(rows), [&](const Column& row) {
    const double most = length(row);
    return most <= 0x1p100 && most / determinant * std::max(1.0, double{reach}) <= 0x1p40;
  });
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
