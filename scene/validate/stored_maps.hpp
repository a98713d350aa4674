// The micromaps that another program has stored for a scene's triangles.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "impl/micromap/array.hpp"
#include "impl/micromap/validate.hpp"
#include "scene/bake/bake.hpp"
#include "scene/plan/plan.hpp"

namespace mmverify::scene {

struct Document;

/// A primitive with maps that are not judged, since its alpha is not the texture's alone.
struct NotJudged {
  std::size_t primitive = 0;  ///< number in Scene::primitives
  std::uint64_t triangles = 0;
  LeftOut why = LeftOut::opaque;
};

/// The link from a triangle of the file to its map.
struct MapLink {
  std::size_t primitive = 0;            ///< number in Scene::primitives
  std::size_t triangle = 0;             ///< of the primitive
  std::size_t array = 0;                ///< number in StoredMaps::arrays
  std::uint64_t base = 0;               ///< the primitive's base triangle
  std::optional<std::uint64_t> record;  ///< number in the array; none for a special index
  std::size_t planned = 0;              ///< number in Plan::triangles
};

/// A micromap of a file: records and data.
using StoredArray = std::shared_ptr<const impl::micromap::Array>;

/// The triangles that have a map, as a plan and its baked result.  A planned triangle stands for all of its primitive
/// that have its UVs, whole periods of the texture aside, and its map.  Maps share the bytes of their array.
struct StoredMaps {
  Plan plan;
  Baked baked;
  std::vector<MapLink> links;      ///< one a triangle of the file
  std::vector<std::size_t> first;  ///< by triangle of the plan: the first link among those that it stands for
  std::vector<StoredArray> arrays;  ///< the file's micromaps, also those that no triangle has
  std::uint64_t special = 0;        ///< triangles with a special index, among these
  std::vector<NotJudged> not_judged;

  const MapLink& link(std::size_t planned) const { return links[first[planned]]; }
};

/// The stored maps of a glTF file with EXT_mesh_opacity_micromap; special indices are maps of level 0.
/// Domain: a file without findings of validate_micromaps(), and its scene by load().
StoredMaps stored_maps(const std::string& file, const Scene& scene);
StoredMaps stored_maps(const Document& document, const Scene& scene);

/// The stored maps of an array and the indices of one primitive, as in a build's buffers.
/// Domain: an input without findings of impl::micromap::validate(); as many triangles as the primitive has.
StoredMaps stored_maps(const impl::micromap::Input& input, const Scene& scene, std::size_t primitive);

/// The maps whose triangles have no vertex alpha that varies: of these each state is known.  The others are not_judged.
StoredMaps without_varying_alpha(const StoredMaps& maps);

/// A record's map.  Domain: a record of an array without findings of impl::micromap::validate().
BakedTriangle stored_map(const StoredArray& array, std::uint64_t record);

}  // namespace mmverify::scene
