#include "scene/scene.hpp"

#include <cmath>

namespace mmverify::scene {

const char* name_of(Wrap wrap) noexcept {
  switch (wrap) {
    case Wrap::repeat:
      return "REPEAT";
    case Wrap::mirrored_repeat:
      return "MIRRORED_REPEAT";
    case Wrap::clamp_to_edge:
      break;
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
