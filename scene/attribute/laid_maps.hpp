// The maps of a set's triangles in memory, as a renderer would have them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/attribute/baker.hpp"
#include "scene/attribute/shared_maps.hpp"
#include "scene/read/attributes.hpp"

namespace mmverify::scene {

/// A triangle in one attribute set.
struct MapOfTriangle {
  std::size_t texture = 0;  ///< number in AttributeScene::textures
  UvTriangle uvs;
};

/// The maps of a set; equal maps are stored once.
struct LaidMaps {
  AttributeSet set = 0;
  unsigned level = 0;
  MapKind kind = MapKind::faces;
  std::span<const MapOfTriangle> triangles;
  std::vector<std::size_t> first;     ///< by triangle: its map begins at values[first]
  std::vector<std::uint32_t> values;  ///< r | g << 8 | b << 16 | a << 24; within a map in MapBaker's order
};

/// The limit of stored values, 1 GiB.
inline constexpr std::uint64_t most_laid_values = std::uint64_t{1} << 28;

/// Fills `first` and `values`; both stay empty if there would be more than most_laid_values.
/// `keys` has the key of each triangle's map, and map(k, out) bakes the map of triangle k.
/// Domain: set, level, kind and triangles are filled in, as many keys as triangles.
void lay(LaidMaps& laid, std::span<const MapKey> keys,
         const std::function<void(std::size_t, std::vector<MapValue>&)>& map);

}  // namespace mmverify::scene
