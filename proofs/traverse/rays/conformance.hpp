// Rays with a known answer, one for each micro-triangle, edge and vertex, for any ray test.
#pragma once

#include <cstdio>
#include <functional>

#include "proofs/engine/kinds.hpp"
#include "spec/traverse/decision.hpp"

namespace mmverify::proofs::traverse {

/// The highest level of written rays.
inline constexpr Level finest_ray_level = 10;

/// A ray from (u, v, 1) along (0, 0, -1) to the triangle (0,0,0), (1,0,0), (0,1,0), whose vertices have the
/// barycentrics w, u, v.  It hits at t = 1, and u and v are exact in binary32.
struct ConformanceRay {
  Kind kind = Kind::interior;
  float u = 0, v = 0;
  std::uint32_t index = 0;  ///< the reference code's index, ties included
  std::vector<std::uint32_t>
      touching;  ///< the indices of all closed micro-triangles that hold the point, ascending
  /// The point lies on the triangle's own edges, which no second triangle shares: a correct ray test may miss it.
  bool on_outline = false;
};

/// The state of the 4-state map for the rays: the low two bits of the index, changed by a mixing function of its
/// other bits.  The four children of a triangle have all four states, in an order that varies.
spec::micromap::State ray_state(std::uint32_t index);
/// The packed map, 4 states a byte from the lowest bits on.  Domain: level up to finest_ray_level.
std::vector<std::uint8_t> ray_map(Level level);

/// The outcome for a ray without flags: ignored, opaque, or non-opaque, for which an any-hit shader runs.
spec::traverse::Outcome ray_outcome(spec::micromap::State state);

/// The greatest distance: at a third is a micro-triangle's middle, which is no binary fraction.
inline constexpr double most_distance = 0.333;

/// Visits the rays of a level.  With distance 0: all cells, by vertices, middles of edges, and points inside at
/// distance 1/4.  Else one point inside each micro-triangle whose N u, N v and N w are at least `distance` from all
/// whole numbers, N = 2^level; rounding by less is harmless there.
/// Domain: level up to finest_ray_level, distance in 0..most_distance.
void each_conformance_ray(Level level, double distance,
                          const std::function<bool(const ConformanceRay&)>& visit);

/// The number of these rays.
std::uint64_t conformance_rays(Level level, double distance);

/// Writes these rays as text in the format of docs/RENDER.md.  False if `out` no longer accepts lines.
bool write_conformance_rays(Level level, double distance, std::FILE* out);

}  // namespace mmverify::proofs::traverse
