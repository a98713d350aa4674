// The figures of each material: its maps, their bytes, and the any-hit calls that they leave, level by level.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/bake/bake.hpp"

namespace mmverify::scene {

/// The maps of a material at one level; a triangle whose baked map is coarser keeps that one.
struct MaterialLevel {
  std::uint64_t maps = 0;   ///< distinct maps that are not uniform
  std::uint64_t bytes = 0;  ///< of these maps: 2-state without unknown states, else 4-state
  double unknown = 0;       ///< share of the placed area that calls the any-hit shader, in 0..1
};

struct MaterialFigures {
  std::size_t material = 0;                   ///< number in Scene::materials
  std::uint64_t triangles = 0, distinct = 0;  ///< of the plan
  double area = 0;                            ///< placed, in the scene's units, squared
  std::vector<MaterialLevel> levels;          ///< levels 0 to the finest baked one
};

/// The figures of the materials that the plan has, in the scene's order.  A coarser map is the baked one with four
/// children merged into one: T if all are T, O if all are O, else unknown.  It is that of a bake at that level, the
/// sides of unknown states aside, since alpha ranges over a micro-triangle as over its four children together.
/// Domain: a plan of this scene, baked in 4-state.
std::vector<MaterialFigures> material_figures(const Scene& scene, const Plan& plan, const Baked& baked);

/// The coarsest level that leaves at most `share` of the area to shaders; none if the finest baked one leaves more.
/// Domain: share in [0, 1].
std::optional<unsigned> level_for(const MaterialFigures& figures, double share);

/// The figures of all materials together.  Domain: no triangle is in two of them.
MaterialFigures total(const std::vector<MaterialFigures>& all);

}  // namespace mmverify::scene
