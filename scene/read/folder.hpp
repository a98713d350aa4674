// A folder of textures as a scene.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace mmverify::scene {

/// The pictures of a folder, sorted by name, each on a square of its own: two triangles with all of the
/// texture, repeated, linearly filtered, MASK with the cutoff 1/2.  Pictures end in .png, .jpg, .jpeg, .webp,
/// .avif, .dds, .ktx2 or .tga.  Scene::notes names what is passed over: other files, folders within, and
/// pictures of a kind that is not read here, with the reason.
/// Errors: BadScene if the folder cannot be read or has no picture, and as of decode_alpha().
Scene load_textures(const std::string& folder);

}  // namespace mmverify::scene
