// The share of rays for which the any-hit shader is still called, and of those that micromaps decide.
#pragma once

#include <cstdint>

#include "scene/bake/bake.hpp"

namespace mmverify::scene {

/// Shares of the placed area of the planned triangles, each micro-triangle 4^-level of its triangle's.
struct AnyHitShares {
  double area = 0;         ///< in the scene's units, squared
  double transparent = 0;  ///< share in 0..1
  double opaque = 0;
  double unknown = 0;  ///< where the any-hit shader is still called
  double known() const { return transparent + opaque; }
};

/// Of rays that meet the triangles evenly over their area; a triangle counts as often, and as large, as nodes
/// place it.  In double precision.  Where no area is placed, or one beyond double precision, all are 0.
AnyHitShares any_hit_shares(const Scene& scene, const Plan& plan, const Baked& baked);

}  // namespace mmverify::scene
