#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mmverify::scene {

const char* name_of(Wrap wrap) noexcept {
  switch (wrap) {
    case Wrap::repeat: return "REPEAT";
    case Wrap::mirrored_repeat: return "MIRRORED_REPEAT";
    case Wrap::clamp_to_edge: break;
  }
  return "CLAMP_TO_EDGE";
}

Uv transformed(const TextureTransform& transform, const Uv& uv) {
  if (transform == TextureTransform{}) return uv;
  // A rotation of 0 is exact, whatever the library's sine gives.
  const double c = transform.rotation == 0 ? 1 : std::cos(double{transform.rotation});
  const double s = transform.rotation == 0 ? 0 : std::sin(double{transform.rotation});
  const double u = double{transform.scale[0]} * uv[0], v = double{transform.scale[1]} * uv[1];
  return {static_cast<float>(transform.offset[0] + (c * u + s * v)),
          static_cast<float>(transform.offset[1] + (c * v - s * u))};
}

namespace {

/// The range of a sine or cosine over angles, with a hair more: `top`, an angle at which it is 1.
std::array<double, 2> wave_range(double (*wave)(double), double top, double from, double to) {
  if (from == to) return {wave(from), wave(from)};
  constexpr double turn = 2 * std::numbers::pi, hair = 0x1p-40;
  const auto holds = [&](double angle) {
    return std::ceil((from - angle) / turn - hair) <= std::floor((to - angle) / turn + hair);
  };
  const double at_from = wave(from), at_to = wave(to), least = std::min(at_from, at_to),
               greatest = std::max(at_from, at_to);
  return {holds(top + turn / 2) ? -1 : std::max(-1.0, least - hair),
          holds(top) ? 1 : std::min(1.0, greatest + hair)};
}

}  // namespace

std::array<Uv, 2> transformed(const TransformRange& range, const Uv& uv) {
  const TextureTransform &low = range.least, &high = range.greatest;
  if (low == high) return {transformed(low, uv), transformed(low, uv)};
  const bool still = low.rotation == 0 && high.rotation == 0;
  const auto c = still ? std::array<double, 2>{1, 1} : wave_range(std::cos, 0, low.rotation, high.rotation),
             s = still ? std::array<double, 2>{0, 0}
                       : wave_range(std::sin, std::numbers::pi / 2, low.rotation, high.rotation);
  // Each coordinate rises or falls with each of its inputs, rounded or not: so its extremes are at their ends.
  std::array<double, 2> least{HUGE_VAL, HUGE_VAL}, greatest{-HUGE_VAL, -HUGE_VAL};
  for (unsigned ends = 0; ends < 16; ++ends) {
    const double u = double{(ends & 1) != 0 ? high.scale[0] : low.scale[0]} * uv[0],
                 v = double{(ends & 2) != 0 ? high.scale[1] : low.scale[1]} * uv[1],
                 cosine = c[ends >> 2 & 1], sine = s[ends >> 3 & 1];
    const std::array<double, 2> at{cosine * u + sine * v, cosine * v - sine * u};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      least[axis] = std::min(least[axis], at[axis]);
      greatest[axis] = std::max(greatest[axis], at[axis]);
    }
  }
  const auto moved = [](const Uv& offset, const std::array<double, 2>& by) {
    return Uv{static_cast<float>(offset[0] + by[0]), static_cast<float>(offset[1] + by[1])};
  };
  return {moved(low.offset, least), moved(high.offset, greatest)};
}

const Material& Scene::material_of(const Primitive& primitive) const {
  static const Material by_default;
  return primitive.material ? materials[*primitive.material] : by_default;
}

TriangleCounts count_triangles(const Scene& scene) {
  TriangleCounts counts;
  for (const Primitive& primitive : scene.primitives) {
    counts.unique += primitive.triangles.size();
    counts.placed += primitive.triangles.size() * scene.meshes[primitive.mesh].uses;
  }
  return counts;
}

}  // namespace mmverify::scene
