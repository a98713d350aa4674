// A folder of textures as a scene.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// Each picture of the folder, by name, on a square of its own: two triangles with all of the texture, repeated,
/// linearly filtered, MASK with the cutoff 1/2.  What is no .png, .jpg or .jpeg is passed over; folders within are not
/// looked into.
/// Errors: BadScene where the folder cannot be read or has no picture, and as of decode_alpha().
Scene load_textures(const std::string& folder);

}  // namespace mmverify::scene
