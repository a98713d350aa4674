// Loads the scene of a command.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/output/output_file.hpp"
#include "scene/read/file.hpp"
#include "scene/scene.hpp"

namespace mmverify::cli {

/// The name of the built-in scene in messages.
inline constexpr char sample_name[] = "the suite's own scene";

/// A scene that the suite makes itself.
struct GeneratedScene {
  std::string name;  ///< in messages
  mmverify::scene::Bytes bytes;
};
/// The suite's own scene if no file is named; the Quad for "quad", unless a file has that name.  None for others.
std::optional<GeneratedScene> generated_scene(const std::string& file);

/// A glTF or GLB file's scene, or a folder's textures, or a generated_scene(). Errors:
/// scene::BadScene.
mmverify::scene::Scene loaded_scene(const std::string& file);

/// Refuses outputs that are buffers or images of a glTF file.  Domain: a file that can be read, or a folder, or none.
/// Errors: UsageError.
void refuse_files_of(const std::string& file, const std::vector<NamedPath>& outputs);

}  // namespace mmverify::cli
