// A glTF scene as a world for rays, with its micromaps.
#pragma once

#include <cstdint>
#include <vector>

#include "display/render/opacity.hpp"
#include "display/render/world.hpp"
#include "scene/pipeline.hpp"

namespace mmverify::render {

struct SceneWorld {
  static constexpr std::uint32_t none = 0xffffffff;
  World world;
  std::vector<std::uint32_t> geometry_of;  ///< by Scene::primitives; none without triangles, or if invisible
  /// The number of triangles whose alpha a texture tests although the plan leaves them out.  The texture
  /// decides each of their candidates, whatever the method.
  std::uint64_t unplanned = 0;
};

/// The greatest coordinate: products of three of them are finite in binary32.
inline constexpr float farthest = 1e12f;

/// The world of a scene.  Planned primitives are on the plan's surfaces.  A primitive that the plan leaves
/// out has a surface of its own if it has a texture, UVs, and MASK or BLEND; vertex alpha is ignored.  The
/// rest is opaque, or left out if its constant alpha is below the cutoff (BLEND: one half).
/// Domain: uses and plan of this scene, which outlives the world.
/// Errors: scene::BadScene with the node that places a vertex beyond `farthest`, or at no finite place.
SceneWorld world_of(const scene::Scene& scene, const std::vector<scene::MeshUse>& uses,
                    const scene::Plan& plan);

/// The micromaps of the scene's array, by the world's geometries.  Domain: arrays of this plan.
Micromaps micromaps_of(const SceneWorld& world, const scene::Plan& plan, const scene::SceneArrays& arrays);

/// The square maps of the scene's pairs.  Domain: pairs and maps of this plan.
Squares squares_of(const SceneWorld& world, const scene::Plan& plan, const scene::Pairs& pairs,
                   const scene::SquareMaps& maps);

}  // namespace mmverify::render
