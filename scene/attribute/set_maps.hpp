// The maps of a set's triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/attribute/distinct_maps.hpp"
#include "scene/attribute/set_triangles.hpp"

namespace mmverify::scene {

/// The most values of maps that are kept for a renderer, 1 GiB.
inline constexpr std::uint64_t most_kept_values = std::uint64_t{1} << 28;

/// The maps of all triangles of a set, of one kind and level.
struct SetMaps {
  /// The triangles must outlive the maps.
  SetMaps(const SetTriangles& triangles, MapKind kind, unsigned level, std::uint64_t most_values)
      : triangles(triangles),
        kind(kind),
        level(level),
        maps(values_of_map(kind, level), most_values,
             [&triangles, kind, level](std::size_t triangle, std::vector<MapValue>& map) {
               triangles.bake(triangle, kind, level, map);
             }),
        number(triangles.all().size()) {}

  const SetTriangles& triangles;
  MapKind kind;
  unsigned level;
  DistinctMaps maps;
  std::vector<std::uint32_t> number;  ///< of each triangle's map
};

}  // namespace mmverify::scene
