// Materials whose cutoff no alpha reaches.
#pragma once

#include <vector>

#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {

/// A warning (material.cutoff) for each material of alphaMode MASK whose alphaCutoff is above 1: nothing of it is drawn.
/// Source: glTF 2.0, 3.9.4.
std::vector<FileViolation> cutoffs_above_1(const Document& document);

}  // namespace mmverify::scene
