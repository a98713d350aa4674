// Records of bakes that no longer describe their file.
#pragma once

#include <functional>
#include <vector>

#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {

/// A warning (bake.stale) for each primitive whose record of its bake differs from the file: an input was changed after
/// the bake.  Nothing is baked; files without records are not decoded.
/// Domain: any document; none that cannot be read.
std::vector<FileViolation> stale_records(const std::function<Document()>& open, Draft draft);

}  // namespace mmverify::scene
