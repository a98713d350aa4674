#include "cli/scene/loaded.hpp"

#include <filesystem>

#include "scene/read/document.hpp"
#include "scene/read/file.hpp"
#include "scene/read/folder.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/quad.hpp"
#include "scene/sample/scene.hpp"

namespace mmverify::cli {

std::optional<GeneratedScene> generated_scene(const std::string& file) {
  if (file.empty()) return GeneratedScene{sample_name, mmverify::scene::sample_scene()};
  if (std::error_code none; file != "quad" || std::filesystem::exists(file, none)) return std::nullopt;
  return GeneratedScene{"the Quad", mmverify::scene::quad_scene()};
}

mmverify::scene::Scene loaded_scene(const std::string& file) {
  using namespace mmverify::scene;
  if (std::error_code none; std::filesystem::is_directory(file, none)) return load_textures(file);
  if (const auto made = generated_scene(file)) return load(made->name, made->bytes);
  return load(file);
}

void refuse_files_of(const std::string& file, const std::vector<NamedPath>& outputs) {
  if (std::error_code none; generated_scene(file) || std::filesystem::is_directory(file, none)) return;
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
