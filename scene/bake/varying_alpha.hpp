// A baker of triangles whose vertex alpha varies, by bounds of alpha.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/plan/plan.hpp"

namespace mmverify::scene {

/// The bakers of the surfaces that have such triangles.
class VaryingAlphaBakers {
 public:
  /// Time and memory: a small part of the texels', for each image.  The scene outlives this.
  VaryingAlphaBakers(const Scene& scene, const Plan& plan, float margin);
  ~VaryingAlphaBakers();

  /// Bakes the packed 4-state map.  With the least and greatest sampled number t in a micro-triangle's box, grown by the
  /// margin, the surface's factor f, and the least and greatest vertex alpha a at its corners:
  ///   O if min t f a is opaque, T if max t f a is transparent, else UO or UT as alpha at its centroid is rather
  ///   opaque or not, up to rounding
  /// T and O are right for the micro-triangle, since texture and vertex alpha lie within their bounds on all of it; unknown
  /// states may be needless.
  /// Domain: a triangle of the plan, level in 0..12, map.size() = ceil(4^level / 4).
  /// Source: glTF 2.0, 3.9.2: COLOR_0 is a linear multiplier; spec/bake/state.hpp.
  /// Law: bake.conservative
  void bake(const PlannedTriangle& triangle, unsigned level, std::span<std::uint8_t> map) const;

 private:
  class OfSurface;
  std::vector<std::unique_ptr<const OfSurface>> surfaces_;
};

}  // namespace mmverify::scene
