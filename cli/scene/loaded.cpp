#include "cli/scene/loaded.hpp"

#include <filesystem>

#include "scene/read/document.hpp"
#include "scene/read/file.hpp"
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

void refuse_files_of(const std::string& file, const std::vector<NamedPath>& outputs) {
  if (std::error_code none; file.empty() || std::filesystem::is_directory(file, none)) return;
  const mmverify::scene::Document document = mmverify::scene::open_document(file);
  for (const char* list : {"buffers", "images"})
    for (const auto& one : mmverify::scene::member(document.json, list)) {
      const std::string uri = one.value("uri", std::string());
      if (uri.empty() || uri.starts_with("data:")) continue;
      const NamedPath input{"a file of the scene", mmverify::scene::beside(file, uri, list).string()};
      for (const NamedPath& output : outputs) refuse_same_file({input, output});
    }
}

}  // namespace mmverify::cli
