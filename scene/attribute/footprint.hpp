// The sizes of attribute micromaps in closed form.
#pragma once

#include <cstdint>

namespace mmverify::scene {

enum class MapKind : std::uint8_t { faces, vertices };
inline constexpr MapKind map_kinds[] = {MapKind::faces, MapKind::vertices};

/// The finest level that is measured.
inline constexpr unsigned finest_attribute_level = 10;

/// Values of a map: 4^n of faces, (N+1)(N+2)/2 of vertices, N = 2^n.  Domain: level in 0..16.
constexpr std::uint64_t values_of_map(MapKind kind, unsigned level) {
  const std::uint64_t n = std::uint64_t{1} << level;
  return kind == MapKind::faces ? n * n : (n + 1) * (n + 2) / 2;
}

/// The bytes of an RGBA8 value, as for textures.
inline constexpr std::uint64_t bytes_of_value = 4;

/// The bytes of `maps` maps, without mips.  Source: Color and Attribute Micromaps, 5.1, whose figure 1 is
/// this:
///   58,626 maps of vertices at level 4, of the Shoe's three textures of 2048^2, are 71.29 % of 3 x 4 x 2048^2
constexpr std::uint64_t bytes_of_maps(std::uint64_t maps, MapKind kind, unsigned level) {
  return maps * values_of_map(kind, level) * bytes_of_value;
}

/// The first level at which `maps` maps take more than `bytes`; no_level if none up to 16 does.
constexpr unsigned no_level = 17;
constexpr unsigned level_beyond(std::uint64_t maps, MapKind kind, std::uint64_t bytes) {
  unsigned level = 0;
  while (level < no_level && bytes_of_maps(maps, kind, level) <= bytes) ++level;
  return level;
}

}  // namespace mmverify::scene
