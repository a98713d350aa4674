// The memory that a scene's opacity takes, form by form.
#pragma once

#include <array>
#include <cstdint>

#include "scene/bake/arrays.hpp"

namespace mmverify::scene {

/// The bytes in one mode, 2-state or 4-state.  Each member counts its own form and nothing else.
struct ModeFootprint {
  std::uint64_t records = 0;  ///< micromaps that are not uniform in this mode
  std::uint64_t data = 0;     ///< their packed maps
  /// The same maps as the paper's two bit sequences, each starting at a whole byte.
  std::uint64_t tree = 0;
  std::uint64_t our_tree = 0;  ///< the same maps in impl/tree's form for random access
  std::uint64_t graph = 0;     ///< the same maps in one graph, impl/dag, with its records of 8 bytes
  std::uint64_t bitmask = 0;   ///< 1 or 2 bits a texel of every alpha texture in use
};

struct Footprint {
  std::uint64_t records = 0;          ///< micromaps
  std::uint64_t special = 0;          ///< triangles with a special index
  std::uint64_t record_bytes = 0;     ///< 8 a record
  std::uint64_t index_bytes = 0;      ///< a code a triangle
  std::uint64_t array_data = 0;       ///< as built: 2-state if no state is unknown, else 4-state
  std::array<ModeFootprint, 2> mode;  ///< 2-state, 4-state
  std::uint64_t texture = 0;          ///< 8 or 16 bits a texel of every alpha texture in use, without mips
  std::uint64_t vertex_data = 0;      ///< 12 bytes a triangle of vertex indices, 8 a vertex of UVs
};

/// The footprint of a scene.  Domain: arrays of this baked plan.
/// Source: Succinct Opacity Micromaps, 5.1 and table 2.
Footprint footprint(const Scene& scene, const Plan& plan, const SceneArrays& arrays, unsigned threads = 0);

}  // namespace mmverify::scene
