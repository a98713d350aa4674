#include "scene/bake/any_hit.hpp"

#include <cmath>

namespace mmverify::scene {
namespace {

using Vector = std::array<double, 3>;
constexpr Placement identity{1, 0, 0, 0, 1, 0, 0, 0, 1};

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A vector under the linear part of a placement.
Vector moved(const Placement& m, const Vector& x) {
  Vector y{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) y[row] += m[row + 3 * column] * x[column];
  return y;
}

double area(const Placement& m, const Vector& a, const Vector& b) {
  const Vector n = cross(moved(m, a), moved(m, b));
  return std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
}

}  // namespace

double placed_area(const Scene& scene, const Primitive& primitive, std::size_t triangle) {
  const auto& corners = primitive.triangles[triangle];
  const auto edge = [&](std::size_t to) {
    const Position &p = primitive.positions[corners[0]], &q = primitive.positions[corners[to]];
    return Vector{double{q[0]} - p[0], double{q[1]} - p[1], double{q[2]} - p[2]};
  };
  const Vector a = edge(1), b = edge(2);
  const Placements& placements = scene.meshes[primitive.mesh].placements;
  double size = placements.similar * area(identity, a, b);
  for (const auto& [linear, times] : placements.others) size += times * area(linear, a, b);
  return size;
}

AnyHitShares any_hit_shares(const Scene& scene, const Plan& plan, const Baked& baked) {
  AnyHitShares sum;
  for (const PlannedPrimitive& planned : plan.primitives)
    for (std::size_t t = 0; t < planned.triangles.size(); ++t) {
      const double size = placed_area(scene, scene.primitives[planned.primitive], t);
      const BakedTriangle& map = baked.triangles[planned.triangles[t].triangle];
      const double share = std::ldexp(size, -2 * static_cast<int>(map.level));
      sum.area += size;
      sum.transparent += share * static_cast<double>(map.states[0]);
      sum.opaque += share * static_cast<double>(map.states[1]);
      sum.unknown += share * static_cast<double>(map.states[2] + map.states[3]);
    }
  // Scales near the ends of double precision give no result.
  if (!std::isfinite(sum.area) || !std::isfinite(sum.transparent + sum.opaque + sum.unknown)) return {};
  if (sum.area > 0)
    for (double* const share : {&sum.transparent, &sum.opaque, &sum.unknown}) *share /= sum.area;
  return sum;
}

}  // namespace mmverify::scene
