// The maps of a set's triangles in memory, as a renderer would hold them.
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
  std::size_t texture = 0;  ///< of AttributeScene::textures
  UvTriangle uvs;
};

/// Equal maps are there once.
struct LaidMaps {
  AttributeSet set = 0;
  unsigned level = 0;
  MapKind kind = MapKind::faces;
  std::span<const MapOfTriangle> triangles;
  std::vector<std::size_t> first;     ///< by triangle: its map begins at values[first]
  std::vector<std::uint32_t> values;  ///< r | g << 8 | b << 16 | a << 24; in a map as MapBaker has them
};

/// Maps are laid up to so many values, 1 GiB.
inline constexpr std::uint64_t most_laid_values = std::uint64_t{1} << 28;

/// Fills first and values; values stay empty, and so does first, where they would be more than most_laid_values.
/// keys: of the map of each triangle; map(k, out) bakes that of triangle k.  Domain: set, level, kind and triangles are
/// there, as many keys as triangles.
void lay(LaidMaps& laid, std::span<const MapKey> keys,
         const std::function<void(std::size_t, std::vector<MapValue>&)>& map);

}  // namespace mmverify::scene
