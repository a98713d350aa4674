// The scene that a command is given.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace mmverify::cli {

/// What messages call the scene of our own.
inline constexpr char sample_name[] = "the suite's own scene";

/// A glTF or GLB file's scene, or a folder's textures; without a file the scene of our own.  Errors: scene::BadScene.
mmverify::scene::Scene loaded_scene(const std::string& file);

}  // namespace mmverify::cli
