#include "display/render/scene/world_of.hpp"

#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "scene/bake/surface_baker.hpp"
#include "scene/read/bad_scene.hpp"

namespace mmverify::render {
namespace {

Surface surface_of(const scene::Scene& scene, const scene::Surface& planned) {
  const scene::SurfaceInputs inputs = scene::surface_inputs(scene, planned);
  return Surface(inputs.texels, inputs.sampling, inputs.mode);
}

/// The surface of a primitive that the plan leaves out; none unless a texture tests the primitive's alpha.
std::optional<scene::Surface> unplanned_surface(const scene::Scene& scene,
                                                const scene::Primitive& primitive) {
  const scene::Material& material = scene.material_of(primitive);
  if (material.mode == scene::AlphaMode::opaque || !material.texture || !material.texture->image ||
      primitive.uvs.empty() || !scene.images[*material.texture->image].decoded())
    return std::nullopt;
  for (const scene::Uv& uv : primitive.uvs)
    for (const float x : uv)
      if (std::fabs(x) >= 0x1p20f) return std::nullopt;
  scene::Surface surface;
  surface.image = *material.texture->image;
  surface.sampler = material.texture->sampler;
  surface.mode = material.mode;
  if (material.mode == scene::AlphaMode::mask) surface.cutoff = material.cutoff;
  surface.base_color_alpha = material.base_color_alpha;
  return surface;
}

bool within_reach(const World& world, const Instance& instance) {
  for (const std::uint32_t g : world.meshes[instance.mesh])
    for (const auto& triangle : world.geometries[g].triangles)
      for (const std::uint32_t vertex : triangle)
        for (const float x : placed(instance, world.geometries[g].positions[vertex]))
          if (!(std::fabs(x) <= farthest)) return false;
  return true;
}

bool invisible(const scene::Material& material) {
  if (material.mode == scene::AlphaMode::opaque || material.texture) return false;
  return material.base_color_alpha < (material.mode == scene::AlphaMode::mask ? material.cutoff : 0.5f);
}

}  // namespace

SceneWorld world_of(const scene::Scene& scene, const std::vector<scene::MeshUse>& uses,
                    const scene::Plan& plan) {
  SceneWorld made;
  World& world = made.world;
  for (const scene::Surface& surface : plan.surfaces) world.surfaces.push_back(surface_of(scene, surface));
  std::vector<std::optional<std::uint32_t>> planned(scene.primitives.size());
  for (const scene::PlannedPrimitive& p : plan.primitives) planned[p.primitive] = p.surface;
  world.meshes.resize(scene.meshes.size());
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const scene::Primitive& primitive = scene.primitives[k];
    made.geometry_of.push_back(SceneWorld::none);
    if (primitive.triangles.empty() || invisible(scene.material_of(primitive))) continue;
    Geometry geometry;
    geometry.positions = primitive.positions;
    geometry.triangles = primitive.triangles;
    geometry.surface = planned[k];
    if (!geometry.surface)
      if (const auto own = unplanned_surface(scene, primitive)) {
        geometry.surface = static_cast<std::uint32_t>(world.surfaces.size());
        world.surfaces.push_back(surface_of(scene, *own));
        geometry.planned = false;
        made.unplanned += primitive.triangles.size();
      }
    if (geometry.surface)
      for (const scene::Uv& uv : primitive.uvs) geometry.uvs.push_back({uv[0], uv[1]});
    geometry.colour = static_cast<std::uint32_t>(primitive.material.value_or(scene.materials.size()));
    made.geometry_of.back() = static_cast<std::uint32_t>(world.geometries.size());
    world.meshes[primitive.mesh].push_back(made.geometry_of.back());
    world.geometries.push_back(std::move(geometry));
  }
  for (const scene::MeshUse& use : uses) {
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(use.mesh);
    for (std::size_t c = 0; c < 9; ++c) instance.transform[c] = static_cast<float>(use.to_scene.linear[c]);
    for (std::size_t c = 0; c < 3; ++c)
      instance.transform[9 + c] = static_cast<float>(use.to_scene.translation[c]);
    if (!within_reach(world, instance))
      throw scene::BadScene(
          scene.file, use.node ? "node " + std::to_string(*use.node) : "mesh " + std::to_string(use.mesh),
          "rays need coordinates up to 1e12, and a vertex of mesh " + std::to_string(use.mesh) +
              " is placed beyond; scale the scene down");
    if (!world.meshes[use.mesh].empty()) world.instances.push_back(instance);
  }
  return made;
}

Micromaps micromaps_of(const SceneWorld& world, const scene::Plan& plan, const scene::SceneArrays& arrays) {
  namespace micromap = impl::micromap;
  Micromaps made;
  made.array = arrays.array;
  made.codes.resize(world.world.geometries.size());
  const std::size_t bytes = micromap::width(arrays.encoding) / 8;
  made.index_bytes = static_cast<unsigned>(bytes);
  for (std::size_t k = 0; k < plan.primitives.size(); ++k) {
    const std::uint32_t geometry = world.geometry_of[plan.primitives[k].primitive];
    if (geometry == SceneWorld::none) continue;
    const auto& indices = arrays.primitives[k].geometry.indices;
    for (std::size_t at = 0; at < indices.size(); at += bytes) {
      std::uint32_t code = 0;
      std::memcpy(&code, indices.data() + at, bytes);
      if (const auto special = micromap::special_state(code, arrays.encoding))
        code = micromap::special_code(*special, micromap::Encoding::u32);
      made.codes[geometry].push_back(code);
    }
  }
  return made;
}

Squares squares_of(const SceneWorld& world, const scene::Plan& plan, const scene::Pairs& pairs,
                   const scene::SquareMaps& maps) {
  Squares made{maps.vq2, maps.vq4, {}};
  made.places.resize(world.world.geometries.size());
  for (std::size_t k = 0; k < plan.primitives.size(); ++k) {
    const std::uint32_t geometry = world.geometry_of[plan.primitives[k].primitive];
    if (geometry == SceneWorld::none) continue;
    for (const auto& place : pairs.places[k]) {
      SquarePlace its;
      if (place)
        its = {place->pair, place->upper ? impl::vq::Half::upper : impl::vq::Half::lower, place->order};
      made.places[geometry].push_back(its);
    }
  }
  return made;
}

}  // namespace mmverify::render
