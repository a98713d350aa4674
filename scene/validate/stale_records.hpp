// Records of bakes that no longer describe their file.
#pragma once

#include <vector>

#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {

/// A warning (bake.stale) for each primitive whose record of its bake differs from the file: an input was changed after
/// the bake.  Nothing is baked; files without records are not decoded.
/// A scene that cannot be read has none: the validator of micromaps reports the reason.
std::vector<FileViolation> stale_records(const Document& document, Draft draft);

}  // namespace mmverify::scene
