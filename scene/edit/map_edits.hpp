// Other maps for triangles of a file.
#pragma once

#include <vector>

#include "scene/bake/bake.hpp"
#include "scene/edit/edited_file.hpp"

namespace mmverify::scene {

/// A triangle of a file, and its new map.
struct MapEdit {
  std::size_t mesh = 0, number = 0;  ///< meshes[mesh].primitives[number]
  std::size_t triangle = 0;
  std::size_t map = 0;  ///< number in a list of maps
};

/// Writes maps: over the record's bytes where all of its triangles get the same map, else to an equal record, else to a
/// new one; a uniform map is a special index.  Usage counts follow.  All other bytes stay.
/// Domain: a file without findings of validate_micromaps(), its triangles, each at most once.
/// Errors: BadScene; std::length_error for data beyond 2^32 bytes.
void write_maps(EditedFile& file, const std::vector<BakedTriangle>& maps, const std::vector<MapEdit>& edits);

/// Writes the usage counts of a micromap from its records.  Errors: BadScene if the records cannot be read.
void write_usage_counts(EditedFile& file, std::size_t micromap);

}  // namespace mmverify::scene
