// Rays with a known answer: one for each micro-triangle, edge and vertex, for anybody's ray test.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <vector>

#include "proofs/engine/kinds.hpp"
#include "proofs/engine/result.hpp"
#include "spec/micromap/micromap.hpp"
#include "spec/traverse/decision.hpp"

namespace mmverify::proofs::traverse {

/// Levels up to which rays are written.
inline constexpr Level finest_ray_level = 10;

/// The triangle (0,0,0), (1,0,0), (0,1,0), whose vertices have the barycentrics w, u, v; the ray from (u, v, 1) along
/// (0, 0, -1).  It hits at t = 1, and u and v are exact in binary32.
struct ConformanceRay {
  Kind kind = Kind::interior;
  float u = 0, v = 0;
  std::uint32_t index = 0;              ///< by the reference code, ties included
  std::vector<std::uint32_t> touching;  ///< of all closed micro-triangles that hold the point, ascending
  /// On the triangle's own edges, which no second triangle shares: a correct ray test may miss it.
  bool on_outline = false;
};

/// The 4-state map that rays are meant for: the low two bits of the index, exchanged as a mixing function of its other
/// bits says.  So the four children of a triangle have all four states, and no order of others is kept.
spec::micromap::State ray_state(std::uint32_t index);
/// Packed, 4 to a byte from the lowest bits on.  Domain: level up to finest_ray_level.
std::vector<std::uint8_t> ray_map(Level level);

/// What a ray without flags does with it: ignored, opaque, or non-opaque, where an any-hit shader runs.
spec::traverse::Outcome ray_outcome(spec::micromap::State state);

/// The greatest distance that can be asked for: a third is a micro-triangle's middle, which is no binary fraction.
inline constexpr double most_distance = 0.333;

/// All cells of a level where distance is 0: vertices, middles of edges, points inside at distance 1/4.  Else one point
/// inside each micro-triangle whose N u, N v and N w are at least `distance` from all whole numbers, N = 2^level: safe
/// for who rounds by less.
/// Domain: level up to finest_ray_level, distance in 0..most_distance.
void each_conformance_ray(Level level, double distance,
                          const std::function<bool(const ConformanceRay&)>& visit);

/// How many those are.
std::uint64_t conformance_rays(Level level, double distance);

/// Writes them as text: docs/RENDER.md has the format.  False where `out` no longer takes anything.
bool write_conformance_rays(Level level, double distance, std::FILE* out);

}  // namespace mmverify::proofs::traverse
