#include "scene/read/document.hpp"

#include <algorithm>
#include <string_view>

#include "scene/read/bad_scene.hpp"
#include "scene/read/check_json.hpp"
#include "scene/read/json_fault.hpp"
#include "scene/read/unique_names.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

/// Whether a text is two whole numbers with a point between.  Source: glTF 2.0, asset.schema.json.
bool is_version(const std::string& text) {
  const auto is_number = [](std::string_view part) {
    return !part.empty() &&
           std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  const std::size_t point = std::min(text.find('.'), text.size());
  return is_number(text.substr(0, point)) && point < text.size() && is_number(text.substr(point + 1));
}

/// Refuses a glTF that says it needs another version than 2.0.  A file of a later minor version may be read
/// as 2.0 unless it asks for more.  Source: glTF 2.0, 3.2.
void check_version(const Json& json, const std::string& file) {
  const Json& asset = json["asset"];
  const std::string& version = asset["version"].get_ref<const std::string&>();
  const auto needs = asset.find("minVersion");
  if (needs != asset.end() && !needs->get_ref<const std::string&>().starts_with("1.") && *needs != "2.0")
    throw UnreadVersion(
        file, "/asset/minVersion",
        "the file needs glTF " + shown(needs->get_ref<const std::string&>()) + "; 2.0 is read here");
  if (!is_version(version))
    throw BadScene(file, "/asset/version", "'" + shown(version) + "' is no version; write 2.0");
  if (!version.starts_with("2."))
    throw UnreadVersion(file, "/asset/version", "glTF " + shown(version) + "; only 2.x is read");
}

/// Calls take(mesh, primitive, accessor) for each primitive whose indices no view holds, since they are
/// compressed; tinygltf refuses those.
template <class Take>
void for_each_unheld_index(const Json& json, const Take& take) {
  const Json& meshes = member(json, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m)
    for (std::size_t p = 0; p < meshes[m]["primitives"].size(); ++p) {
      const Json& primitive = meshes[m]["primitives"][p];
      if (!primitive.contains("indices") ||
          !member(primitive, "extensions").contains("KHR_draco_mesh_compression"))
        continue;
      const auto accessor = primitive["indices"].get<std::size_t>();
      if (!json["accessors"][accessor].contains("bufferView")) take(m, p, accessor);
    }
}

/// The part of the JSON that is read through tinygltf's types.
Json for_tinygltf(const Json& json) {
  Json kept = {{"asset", json["asset"]}};
  for (const char* key :
       {"bufferViews", "accessors", "meshes", "nodes", "materials", "textures", "samplers"}) {
    const auto found = json.find(key);
    if (found == json.end()) continue;
    for (Json& element : kept[key] = *found) {
      element.erase("extras");
      element.erase("extensions");
    }
  }
  for_each_unheld_index(json, [&kept](std::size_t mesh, std::size_t primitive, std::size_t) {
    kept["meshes"][mesh]["primitives"][primitive].erase("indices");
  });
  return kept;
}

}  // namespace

const Json& member(const Json& json, const char* key) {
  static const Json nothing = Json::object();
  const auto found = json.find(key);
  return found == json.end() ? nothing : *found;
}

const Json& extension(const Json& json, const char* name) { return member(member(json, "extensions"), name); }

std::string place(const char* kind, std::size_t index, const std::string& name) {
  return std::string(kind) + " " + std::to_string(index) + (name.empty() ? "" : " (" + shown(name) + ")");
}

Document parse(Container parts, const std::string& file) {
  constexpr int deepest = 64;
  if (!nests_at_most(parts.json, deepest))
    throw BadScene(file, "JSON", "nested more than " + std::to_string(deepest) + " deep");
  Document document{file, false, {}, {}, std::move(parts.binary)};
  document.json = Json::parse(parts.json, nullptr, false);
  if (document.json.is_discarded()) throw BadScene(file, "JSON", "no glTF: " + json_fault(parts.json));
  if (const auto twice = twice_named(parts.json))
    throw BadScene(file, shown(*twice), "an object has two members of this name; which of them is meant?");
  check_json(document.json, file);
  check_version(document.json, file);
  const std::string text = for_tinygltf(document.json).dump();
  std::string error, warning;
  tinygltf::TinyGLTF reader;
  if (!reader.LoadASCIIFromString(&document.model, &error, &warning, text.data(),
                                  static_cast<unsigned>(text.size()), "") ||
      !error.empty())
    throw BadScene(file, "JSON", "tinygltf: " + shown(error));
  for_each_unheld_index(document.json, [&](std::size_t mesh, std::size_t primitive, std::size_t accessor) {
    document.model.meshes[mesh].primitives[primitive].indices = static_cast<int>(accessor);
  });
  return document;
}

Document open_document(const std::string& file) {
  return parse(split(read_file(file, file, ""), file), file);
}

Document open_document(const std::string& name, std::span<const unsigned char> bytes) {
  if (bytes.empty()) throw BadScene(name, "", "no bytes");
  if (bytes.size() > largest_file)
    throw BadScene(name, "", std::to_string(bytes.size()) + " bytes; at most 2^31 - 1 are read");
  Document document = parse(split(bytes, name), name);
  document.in_memory = true;
  return document;
}

}  // namespace mmverify::scene
