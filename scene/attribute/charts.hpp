// The charts of an atlas, and the distances of its texels from their borders.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "scene/attribute/atlas.hpp"

namespace mmverify::scene {

/// The chart of each triangle, numbered from 0 in order of appearance.  A chart is a connected component of
/// triangles with common edges in the texture: both corners have the same coordinates.  Triangles that lie on
/// one another by a mirror or a copy may thus be in one chart.
std::vector<std::uint32_t> charts_of(std::span<const UvTriangle> triangles);

/// The chart of a texel that no triangle shows.
inline constexpr std::uint32_t no_chart = std::numeric_limits<std::uint32_t>::max();

/// The bands of texels by their distance from the border of their chart:
///   the least k with d <= 2^k, where d is the distance to the nearest texel of another chart or of none, the longer of
///   both axes' (1 between neighbours, also across a corner); `last` + 1 if k would be more than `last`
/// The image's own edge is no border.  A texel of no chart has no_band.
/// Domain: charts.size() = width height, last < 30.
inline constexpr std::uint8_t no_band = 255;
std::vector<std::uint8_t> bands_of(std::span<const std::uint32_t> charts, std::uint32_t width,
                                   std::uint32_t height, unsigned last);

}  // namespace mmverify::scene
