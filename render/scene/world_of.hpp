// A scene of glTF for rays, with its micromaps.
#pragma once

#include <cstdint>
#include <vector>

#include "render/opacity.hpp"
#include "render/world.hpp"
#include "scene/pipeline.hpp"

namespace mmverify::render {

struct SceneWorld {
  static constexpr std::uint32_t none = 0xffffffff;
  World world;
  std::vector<std::uint32_t> geometry_of;  ///< by Scene::primitives; none of one without triangles
  /// Alpha-tested by a texture, but left out of the plan: the texture decides each candidate, whatever the method.
  std::uint64_t unplanned = 0;
};

/// The greatest coordinate: products of three of them are finite in binary32.
inline constexpr float farthest = 1e12f;

/// The world of a scene: planned primitives on their surfaces; those that a plan leaves out on surfaces of their own
/// where they have texture, UVs and MASK or BLEND, without vertex alpha; the rest opaque, or left away where a constant
/// alpha is below the cutoff (BLEND: one half).
/// Domain: uses and plan of this scene, which outlives the world.
/// Errors: scene::BadScene with the node that places a vertex beyond farthest, or at no finite place.
SceneWorld world_of(const scene::Scene& scene, const std::vector<scene::MeshUse>& uses,
                    const scene::Plan& plan);

/// The scene's array, by the world's geometries.  Domain: arrays of this plan.
Micromaps micromaps_of(const SceneWorld& world, const scene::Plan& plan, const scene::SceneArrays& arrays);

/// The square maps of its pairs.  Domain: pairs and maps of this plan.
Squares squares_of(const SceneWorld& world, const scene::Plan& plan, const scene::Pairs& pairs,
                   const scene::SquareMaps& maps);

}  // namespace mmverify::render
