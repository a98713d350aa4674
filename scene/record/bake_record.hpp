// The record of a bake: the inputs that a primitive's maps were made from, kept in the file beside them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// The settings of a bake that no scene has.
struct BakeSettings {
  float margin = 0;
  bool two_state = false;
};

/// The member of the primitive extension's `extras` that holds the record.
inline constexpr const char* bake_record_name = "mmverify_bake";

/// The record as a JSON object: "version" 1, the alpha mode, cutoff and factors, hashes of the texture's alpha and of the
/// triangles' UVs, the sampler, UV set, transform, and the settings.
/// Domain: a primitive of a plan of this scene.
std::string bake_record(const Scene& scene, const Primitive& primitive, const BakeSettings& settings);

/// Why no micromap can be baked for a primitive any more: "alphaMode is OPAQUE now".  Empty if one can, as far as a record
/// tells.
std::string why_unbakeable(const Scene& scene, const Primitive& primitive);

/// The inputs that have changed since: "cutoff was 0.5, is 0.75".  Empty if none has, or for a record of another version.
/// A member that the record lacks is not compared.
/// Errors: std::invalid_argument if `record` is no JSON object.
std::vector<std::string> changes_since(std::string_view record, const Scene& scene,
                                       const Primitive& primitive);

}  // namespace mmverify::scene
