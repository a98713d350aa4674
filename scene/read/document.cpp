#include "scene/read/document.hpp"

#include <algorithm>
#include <string_view>

#include "scene/read/bad_scene.hpp"
#include "scene/read/check_json.hpp"
#include "scene/read/unique_names.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

/// Extensions that are read, or that change nothing that is read here: shading, lights, metadata.
bool is_read(std::string_view extension) {
  constexpr std::string_view others[] = {"KHR_texture_transform",     "KHR_mesh_quantization",
                                         "KHR_animation_pointer",     "KHR_lights_punctual",
                                         "EXT_mesh_gpu_instancing",   "KHR_xmp",
                                         "KHR_xmp_json_ld",           "EXT_lights_image_based",
                                         "KHR_node_visibility",       "MSFT_lod",
                                         "EXT_mesh_opacity_micromap", "KHR_mesh_opacity_micromap"};
  return extension.starts_with("KHR_materials_") ||
         std::find(std::begin(others), std::end(others), extension) != std::end(others);
}

void check_required(const Json& json, const std::string& file) {
  for (const Json& required : member(json, "extensionsRequired")) {
    const std::string& name = required.get_ref<const std::string&>();
    if (is_read(name)) continue;
    const bool compressed = name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression";
    throw BadScene(
        file, "extensionsRequired",
        shown(name) + " is not read here" +
            (compressed ? ": the geometry is compressed; decompress it first (gltf-transform copy)" : ""));
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
  try {
    document.json = Json::parse(parts.json);
  } catch (const Json::exception& error) {
    throw BadScene(file, "JSON", "no glTF: " + shown(error.what()) + "; truncated file?");
  }
  if (const auto twice = twice_named(parts.json))
    throw BadScene(file, shown(*twice), "an object has two members of this name; which of them is meant?");
  check_json(document.json, file);
  const std::string& version = document.json["asset"]["version"].get_ref<const std::string&>();
  if (!version.starts_with("2."))
    throw BadScene(file, "/asset/version", "glTF " + shown(version) + "; only 2.x is read");
  check_required(document.json, file);
  const std::string text = for_tinygltf(document.json).dump();
  std::string error, warning;
  tinygltf::TinyGLTF reader;
  if (!reader.LoadASCIIFromString(&document.model, &error, &warning, text.data(),
                                  static_cast<unsigned>(text.size()), "") ||
      !error.empty())
    throw BadScene(file, "JSON", "tinygltf: " + shown(error));
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
