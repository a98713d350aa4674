// The shares of rays that micromaps decide, and of rays that still call the any-hit shader.
#pragma once

#include "scene/bake/bake.hpp"

namespace mmverify::scene {

/// Shares of the placed area of the planned triangles; each micro-triangle is 4^-level of its triangle.
struct AnyHitShares {
  double area = 0;         ///< in the scene's units, squared
  double transparent = 0;  ///< share in 0..1
  double opaque = 0;
  double unknown = 0;  ///< calls the any-hit shader
  double known() const { return transparent + opaque; }
};

/// The shares of rays that meet the triangles evenly over their area; a triangle counts as often, and as
/// large, as nodes place it.  In double precision.  All are 0 if no area is placed, or one beyond double
/// precision.
AnyHitShares any_hit_shares(const Scene& scene, const Plan& plan, const Baked& baked);

/// The area of a primitive's triangle, as often and as large as nodes place it.  In double precision.
/// Domain: triangle below primitive.triangles.size().
double placed_area(const Scene& scene, const Primitive& primitive, std::size_t triangle);

}  // namespace mmverify::scene
