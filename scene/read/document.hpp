// The JSON of a glTF file, checked, and as tinygltf's types.  Only scene/ includes this.
#pragma once

#include <tiny_gltf.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "scene/read/file.hpp"

namespace mmverify::scene {

struct Document {
  std::string file;
  bool in_memory = false;       ///< then there are no files beside it
  nlohmann::json json;          ///< all of it, checked
  tinygltf::Model model;        ///< the part that is read through it; without buffers, images and animations
  std::optional<Bytes> binary;  ///< GLB's BIN chunk
  std::map<std::string, Bytes> files = {};  ///< by URI: bytes in the place of those of a file beside it
};

/// Parses and checks: nesting, types, whole numbers below 2^31, references, the version.
/// tinygltf gets only JSON that has passed.  By itself it takes 2^32 for 0 and -4 for "not there", reads
/// images beyond their buffer, recurses as deep as `extras` nests, and drops animations without a node.  So
/// buffers.hpp reads buffers and images, and extensions are read from the JSON.
/// Errors: BadScene.
Document parse(Container parts, const std::string& file);

/// The document of a file, or of a file's bytes, which messages call `name`.  Errors: BadScene.
Document open_document(const std::string& file);
Document open_document(const std::string& name, std::span<const unsigned char> bytes);

/// The place in messages: "material 3 (leaf)".
std::string place(const char* kind, std::size_t index, const std::string& name = {});

/// json[key] if it exists, else an empty object.
const nlohmann::json& member(const nlohmann::json& json, const char* key);

/// An extension's object on a JSON object; an empty one if it is missing.
const nlohmann::json& extension(const nlohmann::json& json, const char* name);

}  // namespace mmverify::scene
