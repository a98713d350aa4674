// Maps of another version of the texture: right in most places, and of some texture everywhere.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/scene/cause/inputs.hpp"

namespace mmverify::proofs::scene {

/// A sentence that names the part of the texture that has changed, if the stored maps may be those of another version:
///   - no T touches an O, which no texture allows;
///   - three of four known states are right, and two are the opposite of the right ones;
///   - the wrong ones lie within half of the UVs' bounding box, and of the texture.
/// Domain: maps of these triangles; no other change explains them.
std::optional<std::string> older_texture(const Judged& judged, const std::vector<std::size_t>& triangles,
                                         const std::vector<States>& stored, const std::vector<States>& right);

}  // namespace mmverify::proofs::scene
