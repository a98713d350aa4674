// Maps of faces or of vertices, each triangle's of a level of its own, and triangles that need none.
//
// A triangle gets the lowest level of which its error is at most the one that is wanted: the root of the mean square over
// the texels whose centre it shows, in codes of 8 bits, the channels in use.  Where one value, the mean of the texels
// under it, keeps that error, or it shows no texel's centre, it has no map: its value is one of a palette.
// Faces have nothing in common with their neighbours', so that a triangle's level binds no other.  A map of faces of level
// 0 is that one value.
// Of vertices neighbours, which have two vertices of a primitive in common, then differ by one level at most
// (impl/attribute/plan.hpp): the finer one's edge is decimated, or the coarser one is raised where that breaks the error.
// Decimated values are written into the map, so that a lookup needs to know nothing of them.
// Source: Color and Attribute Micromaps, 3.2 and 7.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/attribute/measure.hpp"

namespace mmverify::scene {

/// The triangles of a plan at a level, those without a map left aside.
struct PlannedLevel {
  unsigned level = 0;
  std::uint64_t lowest =
      0;  ///< before grading: triangles of which it is the lowest that keeps the error, or the last
  std::uint64_t planned = 0;    ///< once it is graded; of faces the same
  std::uint64_t decimated = 0;  ///< of these, with a decimated edge
  std::uint64_t distinct = 0;   ///< their maps, equal ones once
};

/// What the plan of a set takes, and the error that it reaches.
struct PlannedMaps {
  AttributeSet set = 0;
  MapKind kind = MapKind::faces;
  double wanted = 0;            ///< error of a triangle
  std::uint64_t triangles = 0;  ///< of the set
  std::uint64_t special = 0;    ///< without a map
  std::uint64_t palette = 0;    ///< different values of those
  std::uint64_t not_kept = 0;   ///< with more error at the last level, too
  std::vector<PlannedLevel> levels;
  MapError error;  ///< over the set: the same texels as of MapsAtLevel

  std::uint64_t maps() const;      ///< as triangles have them
  std::uint64_t distinct() const;  ///< equal ones once
  /// 4 a value: of maps, equal ones once, and of the palette.
  std::uint64_t value_bytes() const;
};

/// What a triangle takes beside values: 4 bytes that say where its map is or which value of the palette it has; of a plan
/// 1 more, its level.
inline constexpr std::uint64_t bytes_of_place = 4, bytes_of_level = 1;

/// A plan of each set, of faces and of vertices, for each of the errors.  Of the options first, last, averaging, threads, progress and stop count.
/// Levels are first..last; a triangle that keeps the error at none has the last.
/// Domain: as of measure(); errors >= 0, else std::invalid_argument.
std::vector<PlannedMaps> planned_maps(const AttributeScene& scene, const AttributeOptions& options,
                                      std::span<const double> wanted);

}  // namespace mmverify::scene
