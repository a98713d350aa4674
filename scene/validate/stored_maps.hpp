// The micromaps that somebody else has made for a scene's triangles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "impl/micromap/validate.hpp"
#include "scene/bake/bake.hpp"
#include "scene/plan/plan.hpp"

namespace mmverify::scene {

/// A primitive with maps whose alpha is not the texture's alone, so that nothing is said of them.
struct NotJudged {
  std::size_t primitive = 0;  ///< of Scene::primitives
  std::uint64_t triangles = 0;
  LeftOut why = LeftOut::opaque;
};

/// Each triangle that has a map, as a plan and what was baked of it: no two share one.
struct StoredMaps {
  Plan plan;
  Baked baked;
  std::uint64_t special = 0;  ///< triangles with a special index, among these
  std::vector<NotJudged> not_judged;
};

/// Those of a glTF file with EXT_mesh_opacity_micromap: special indices are maps of level 0.
/// Domain: a file in which validate_micromaps() finds nothing, and its scene by load().
StoredMaps stored_maps(const std::string& file, const Scene& scene);

/// An array and the indices of one primitive, as they lie in a build's buffers.
/// Domain: an input in which impl::micromap::validate() finds nothing; as many triangles as the primitive has.
StoredMaps stored_maps(const impl::micromap::Input& input, const Scene& scene, std::size_t primitive);

}  // namespace mmverify::scene
