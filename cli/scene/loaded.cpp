#include "cli/scene/loaded.hpp"

#include <filesystem>

#include "scene/read/folder.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"

namespace mmverify::cli {

mmverify::scene::Scene loaded_scene(const std::string& file) {
  using namespace mmverify::scene;
  if (std::error_code none; std::filesystem::is_directory(file, none)) return load_textures(file);
  if (!file.empty()) return load(file);
  const Bytes bytes = sample_scene();
  return load(sample_name, bytes);
}

}  // namespace mmverify::cli
