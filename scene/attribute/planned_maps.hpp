// Plans of maps of faces or of vertices: each triangle has a level of its own, or needs no map.
//
// A triangle gets the lowest level at which its error is at most the wanted error: the root of the mean
// square over the texels whose centre it shows, in codes of 8 bits, over the channels in use.  It has no map
// if one value, the mean of the texels under it, keeps that error, or if it shows no texel's centre: its
// value is then one of a palette.
// Faces share nothing with their neighbours' faces, so a triangle's level binds no other.  A map of faces of
// level 0 is that one value.
// For vertices, neighbours are triangles with two common vertices of a primitive; their levels differ by one
// at most (impl/attribute/plan.hpp).  The finer triangle's edge is decimated, or the coarser triangle is
// raised if decimation breaks the error.  Decimated values are written into the map, so that a lookup needs
// to know nothing of them.
// Source: Color and Attribute Micromaps, 3.2 and 7.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/attribute/measure.hpp"

namespace mmverify::scene {

/// The triangles of a plan at a level, without those that have no map.
struct PlannedLevel {
  unsigned level = 0;
  std::uint64_t lowest =
      0;  ///< before grading: triangles for which it is the lowest level that keeps the error, or the last level
  std::uint64_t planned = 0;    ///< after grading; for faces the same
  std::uint64_t decimated = 0;  ///< triangles among these with a decimated edge
  std::uint64_t distinct = 0;   ///< their maps, equal ones once
};

/// The figures of a set's plan, and the error that it reaches.
struct PlannedMaps {
  AttributeSet set = 0;
  MapKind kind = MapKind::faces;
  double wanted = 0;            ///< a triangle's error
  std::uint64_t triangles = 0;  ///< of the set
  std::uint64_t special = 0;    ///< without a map
  std::uint64_t palette = 0;    ///< different values of triangles without a map
  std::uint64_t not_kept = 0;   ///< triangles with more error even at the last level
  std::vector<PlannedLevel> levels;
  MapError error;  ///< over the set: the same texels as in MapsAtLevel

  std::uint64_t maps() const;      ///< one a triangle
  std::uint64_t distinct() const;  ///< equal ones once
  /// 4 bytes a value: of distinct maps, and of the palette.
  std::uint64_t value_bytes() const;
};

/// The bytes of a triangle beside values: 4 for the place of its map or the number of its value in the
/// palette, and in a plan 1 more for its level.
inline constexpr std::uint64_t bytes_of_place = 4, bytes_of_level = 1;

/// Plans each set, faces and vertices, for each of the errors.  The options first, last, averaging, threads,
/// progress and stop are used.
/// Levels are first..last; a triangle that keeps the error at no level has the last.
/// Domain: as of measure(); errors >= 0, else std::invalid_argument.
std::vector<PlannedMaps> planned_maps(const AttributeScene& scene, const AttributeOptions& options,
                                      std::span<const double> wanted);

}  // namespace mmverify::scene
