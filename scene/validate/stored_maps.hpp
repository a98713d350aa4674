// The micromaps that another program has stored for a scene's triangles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "impl/micromap/array.hpp"
#include "impl/micromap/validate.hpp"
#include "scene/bake/bake.hpp"
#include "scene/plan/plan.hpp"

namespace mmverify::scene {

/// A primitive with maps that are not judged, since its alpha is not the texture's alone.
struct NotJudged {
  std::size_t primitive = 0;  ///< number in Scene::primitives
  std::uint64_t triangles = 0;
  LeftOut why = LeftOut::opaque;
};

/// The link from a triangle to its map.
struct MapLink {
  std::size_t primitive = 0;            ///< number in Scene::primitives
  std::size_t triangle = 0;             ///< of the primitive
  std::size_t array = 0;                ///< number in StoredMaps::arrays
  std::uint64_t base = 0;               ///< the primitive's base triangle
  std::optional<std::uint64_t> record;  ///< number in the array; none for a special index
};

/// Each triangle that has a map, as a plan and its baked result; no two triangles share one.
struct StoredMaps {
  Plan plan;
  Baked baked;
  std::vector<MapLink> links;                 ///< by triangle of the plan
  std::vector<impl::micromap::Array> arrays;  ///< the file's micromaps, also those that no triangle has
  std::uint64_t special = 0;                  ///< triangles with a special index, among these
  std::vector<NotJudged> not_judged;
};

/// The stored maps of a glTF file with EXT_mesh_opacity_micromap; special indices are maps of level 0.
/// Domain: a file without findings of validate_micromaps(), and its scene by load().
StoredMaps stored_maps(const std::string& file, const Scene& scene);

/// The stored maps of an array and the indices of one primitive, as in a build's buffers.
/// Domain: an input without findings of impl::micromap::validate(); as many triangles as the primitive has.
StoredMaps stored_maps(const impl::micromap::Input& input, const Scene& scene, std::size_t primitive);

/// A record's map.  Domain: a record of an array without findings of impl::micromap::validate().
BakedTriangle stored_map(const impl::micromap::Array& array, std::uint64_t record);

}  // namespace mmverify::scene
