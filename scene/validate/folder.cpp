#include "scene/validate/folder.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/read/bad_scene.hpp"
#include "scene/read/document.hpp"
#include "scene/read/file.hpp"
#include "scene/validate/container.hpp"
#include "scene/validate/file.hpp"

namespace mmverify::scene {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

/// Whether the first bytes are a container's.
bool is_container(const fs::path& path) {
  std::array<char, 8> first{};
  std::ifstream in(path, std::ios::binary);
  in.read(first.data(), first.size());
  const auto* const bytes = reinterpret_cast<const unsigned char*>(first.data());
  return container_kind({bytes, static_cast<std::size_t>(in.gcount())}).has_value();
}

bool is_sidecar_file(const fs::path& path) try {
  return kind_of(read_file(path, path.string(), "")) == FileKind::sidecar;
} catch (const BadScene&) {
  return false;  // any program's JSON may be empty or too large
}

bool is_judged(const fs::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".glb" || ending == ".gltf") return true;
  return ending == ".json" ? is_sidecar_file(path) : is_container(path);
}

/// Adds the values of members `file`, at any depth.
void add_files(const Json& json, std::vector<std::string>& names) {
  if (json.is_object() && json.contains("file") && json["file"].is_string())
    names.push_back(json["file"].get<std::string>());
  if (json.is_structured())
    for (const Json& part : json) add_files(part, names);
}

}  // namespace

std::vector<std::string> micromap_files(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code none;
    if (fs::is_regular_file(it->path(), none) && is_judged(it->path())) files.push_back(it->path().string());
  }
  if (error) throw BadScene(folder, "the folder", error.message());
  if (files.empty())
    throw BadScene(folder, "the folder", "no .glb, .gltf, sidecar of an array or container is in it");
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> files_named_by(const std::string& file) try {
  const Bytes bytes = read_file(file, file, "");
  const auto kind = kind_of(bytes);
  std::vector<std::string> paths;
  if (kind == FileKind::sidecar) {
    std::vector<std::string> names;
    add_files(Json::parse(bytes.begin(), bytes.end(), nullptr, false), names);
    for (const std::string& name : names) paths.push_back((fs::path(file).parent_path() / name).string());
  } else if (kind == FileKind::gltf) {
    const Json json = Json::parse(split(bytes, file).json, nullptr, false);
    for (const char* list : {"buffers", "images"})
      for (const Json& one : member(json, list))
        if (const Json& uri = member(one, "uri");
            uri.is_string() && !uri.get_ref<const std::string&>().starts_with("data:"))
          paths.push_back(beside(file, uri.get<std::string>(), list).string());
  }
  return paths;
} catch (const BadScene&) {
  return {};
}

}  // namespace mmverify::scene
