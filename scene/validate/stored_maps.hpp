// The micromaps that another program has stored for a scene's triangles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

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

/// Each triangle that has a map, as a plan and its baked result; no two triangles share one.
struct StoredMaps {
  Plan plan;
  Baked baked;
  std::uint64_t special = 0;  ///< triangles with a special index, among these
  std::vector<NotJudged> not_judged;
};

/// The stored maps of a glTF file with EXT_mesh_opacity_micromap; special indices are maps of level 0.
/// Domain: a file without findings of validate_micromaps(), and its scene by load().
StoredMaps stored_maps(const std::string& file, const Scene& scene);

/// The stored maps of an array and the indices of one primitive, as in a build's buffers.
/// Domain: an input without findings of impl::micromap::validate(); as many triangles as the primitive has.
StoredMaps stored_maps(const impl::micromap::Input& input, const Scene& scene, std::size_t primitive);

}  // namespace mmverify::scene
