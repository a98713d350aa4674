// Primitives that draw one geometry with different micromaps.
#pragma once

#include <vector>

#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {

/// An advice (primitive.same_geometry) for each primitive whose attributes and indices are the accessors of one before
/// it, while the draft's extension differs: a reader that finds maps by the accessors gives both the maps of one.
/// Time: O(p log p) in the primitives.
std::vector<FileViolation> same_geometry(const Document& document, Draft draft);

}  // namespace mmverify::scene
