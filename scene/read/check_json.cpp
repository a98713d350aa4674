#include "scene/read/check_json.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

enum class Kind { object, array, text, flag, number, numbers_2, numbers_4, whole, index };

/// A property of the JSON: in its path * is each element of an array and {} each member of an object.
struct Property {
  const char* path;
  Kind kind;
  bool required = false;   ///< if the object that contains it is there
  const char* array = "";  ///< for an index: the array at the root that it refers to
};

constexpr bool required = true;

constexpr Property properties[] = {
    {"asset", Kind::object, required},
    {"asset/version", Kind::text, required},
    {"asset/minVersion", Kind::text},
    {"extensionsUsed/*", Kind::text},
    {"extensionsRequired/*", Kind::text},
    {"buffers/*/byteLength", Kind::whole, required},
    {"buffers/*/uri", Kind::text},
    {"bufferViews/*/buffer", Kind::index, required, "buffers"},
    {"bufferViews/*/byteOffset", Kind::whole},
    {"bufferViews/*/byteLength", Kind::whole, required},
    {"bufferViews/*/byteStride", Kind::whole},
    {"accessors/*/bufferView", Kind::index, false, "bufferViews"},
    {"accessors/*/byteOffset", Kind::whole},
    {"accessors/*/componentType", Kind::whole, required},
    {"accessors/*/normalized", Kind::flag},
    {"accessors/*/count", Kind::whole, required},
    {"accessors/*/type", Kind::text, required},
    {"accessors/*/sparse/count", Kind::whole, required},
    {"accessors/*/sparse/indices", Kind::object, required},
    {"accessors/*/sparse/indices/bufferView", Kind::index, required, "bufferViews"},
    {"accessors/*/sparse/indices/byteOffset", Kind::whole},
    {"accessors/*/sparse/indices/componentType", Kind::whole, required},
    {"accessors/*/sparse/values", Kind::object, required},
    {"accessors/*/sparse/values/bufferView", Kind::index, required, "bufferViews"},
    {"accessors/*/sparse/values/byteOffset", Kind::whole},
    {"meshes/*/name", Kind::text},
    {"meshes/*/primitives", Kind::array, required},
    {"meshes/*/primitives/*/attributes", Kind::object, required},
    {"meshes/*/primitives/*/attributes/{}", Kind::index, required, "accessors"},
    {"meshes/*/primitives/*/indices", Kind::index, false, "accessors"},
    {"meshes/*/primitives/*/material", Kind::index, false, "materials"},
    {"meshes/*/primitives/*/mode", Kind::whole},
    {"meshes/*/primitives/*/targets/*/{}", Kind::index, required, "accessors"},
    {"meshes/*/primitives/*/extensions/KHR_materials_variants/mappings", Kind::array, required},
    {"meshes/*/primitives/*/extensions/KHR_materials_variants/mappings/*/material", Kind::index, required,
     "materials"},
    {"meshes/*/primitives/*/extensions/KHR_materials_variants/mappings/*/variants", Kind::array, required},
    {"meshes/*/primitives/*/extensions/KHR_materials_variants/mappings/*/variants/*", Kind::whole},
    {"extensions/KHR_materials_variants/variants", Kind::array, required},
    {"extensions/KHR_materials_variants/variants/*/name", Kind::text, required},
    {"materials/*/name", Kind::text},
    {"materials/*/alphaMode", Kind::text},
    {"materials/*/alphaCutoff", Kind::number},
    {"materials/*/pbrMetallicRoughness/baseColorFactor", Kind::numbers_4},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/index", Kind::index, required, "textures"},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/texCoord", Kind::whole},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset",
     Kind::numbers_2},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/scale",
     Kind::numbers_2},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/rotation",
     Kind::number},
    {"materials/*/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/texCoord",
     Kind::whole},
    {"textures/*/sampler", Kind::index, false, "samplers"},
    {"textures/*/source", Kind::index, false, "images"},
    {"textures/*/extensions/EXT_texture_webp/source", Kind::index, false, "images"},
    {"textures/*/extensions/EXT_texture_avif/source", Kind::index, false, "images"},
    {"textures/*/extensions/MSFT_texture_dds/source", Kind::index, false, "images"},
    {"textures/*/extensions/KHR_texture_basisu/source", Kind::index, false, "images"},
    {"samplers/*/magFilter", Kind::whole},
    {"samplers/*/minFilter", Kind::whole},
    {"samplers/*/wrapS", Kind::whole},
    {"samplers/*/wrapT", Kind::whole},
    {"images/*/name", Kind::text},
    {"images/*/uri", Kind::text},
    {"images/*/mimeType", Kind::text},
    {"images/*/bufferView", Kind::index, false, "bufferViews"},
    {"nodes/*/name", Kind::text},
    {"nodes/*/mesh", Kind::index, false, "meshes"},
    {"nodes/*/children/*", Kind::index, false, "nodes"},
    {"nodes/*/extensions/EXT_mesh_gpu_instancing/attributes", Kind::object, required},
    {"nodes/*/extensions/EXT_mesh_gpu_instancing/attributes/{}", Kind::index, required, "accessors"},
    {"scenes/*/nodes/*", Kind::index, false, "nodes"},
    {"animations/*/channels/*/target", Kind::object, required},
    {"animations/*/channels/*/target/path", Kind::text, required},
    {"animations/*/channels/*/target/extensions/KHR_animation_pointer/pointer", Kind::text, required},
};

bool is_number(const Json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

bool are_numbers(const Json& value, std::size_t count) {
  if (!value.is_array() || value.size() != count) return false;
  for (const Json& element : value)
    if (!is_number(element)) return false;
  return true;
}

/// A whole number.  4.0 is none, since JSON's whole numbers are written without a point.
bool is_whole(const Json& value) {
  return value.is_number_unsigned() && value.get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
}

class Checker {
 public:
  Checker(const Json& root, const std::string& file) : root_(root), file_(file) {}

  void check(const Property& property) const { walk(property, property.path, root_, ""); }

 private:
  [[noreturn]] void bad(const std::string& at, const std::string& what) const {
    throw BadScene(file_, shown(at.empty() ? "/" : at), what);
  }

  /// `path` is the rest of the property's path below `here`, which is at the JSON pointer `at`.
  void walk(const Property& property, std::string_view path, const Json& here, const std::string& at) const {
    if (path.empty()) return judge(property, here, at);
    const std::size_t slash = path.find('/');
    const std::string_view step = path.substr(0, slash);
    const std::string_view rest = slash == std::string_view::npos ? "" : path.substr(slash + 1);
    if (step == "*") {
      if (!here.is_array()) bad(at, "an array is due, not " + found(here));
      for (std::size_t k = 0; k < here.size(); ++k)
        walk(property, rest, here[k], at + "/" + std::to_string(k));
      return;
    }
    if (!here.is_object()) bad(at, "an object is due, not " + found(here));
    if (step == "{}") {
      for (const auto& [key, value] : here.items()) walk(property, rest, value, at + "/" + key);
      return;
    }
    const auto next = here.find(step);
    const std::string there = at + "/" + std::string(step);
    if (next != here.end()) return walk(property, rest, *next, there);
    if (rest.empty() && property.required) bad(there, "missing");
  }

  static std::string found(const Json& value) {
    return value.is_structured() ? std::string("an ") + value.type_name() : shown(value.dump());
  }

  void judge(const Property& property, const Json& value, const std::string& at) const {
    switch (property.kind) {
      case Kind::object:
        if (!value.is_object()) bad(at, "an object is due, not " + found(value));
        return;
      case Kind::array:
        if (!value.is_array()) bad(at, "an array is due, not " + found(value));
        return;
      case Kind::text:
        if (!value.is_string()) bad(at, "a string is due, not " + found(value));
        return;
      case Kind::flag:
        if (!value.is_boolean()) bad(at, "true or false is due, not " + found(value));
        return;
      case Kind::number:
        if (!is_number(value)) bad(at, "a number is due, not " + found(value));
        return;
      case Kind::numbers_2:
        if (!are_numbers(value, 2)) bad(at, "two numbers are due, not " + found(value));
        return;
      case Kind::numbers_4:
        if (!are_numbers(value, 4)) bad(at, "four numbers are due, not " + found(value));
        return;
      case Kind::whole:
        if (!is_whole(value)) bad(at, "a whole number from 0 to 2^31 - 1 is due, not " + found(value));
        return;
      case Kind::index: {
        const auto array = root_.find(property.array);
        const std::size_t size = array != root_.end() && array->is_array() ? array->size() : 0;
        if (!is_whole(value) || value.get<std::uint64_t>() >= size)
          bad(at, found(value) + " is due to be an index into " + property.array + ", of which there are " +
                      std::to_string(size));
        return;
      }
    }
  }

  const Json& root_;
  const std::string& file_;
};

}  // namespace

bool nests_at_most(const std::string& json, int deepest) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const char c = json[k];
    if (in_string) {
      if (c == '\\') ++k;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest) return false;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return true;
}

void check_json(const Json& json, const std::string& file) {
  const Checker checker(json, file);
  for (const Property& property : properties) checker.check(property);
}

void check_texture_json(const Json& json, const std::string& file) {
  const Checker checker(json, file);
  for (const char* texture : {"pbrMetallicRoughness/metallicRoughnessTexture", "normalTexture",
                              "occlusionTexture", "emissiveTexture"}) {
    const std::string at = "materials/*/" + std::string(texture),
                      transform = at + "/extensions/KHR_texture_transform/";
    for (const auto& [path, kind] : {std::pair{at + "/texCoord", Kind::whole},
                                     {transform + "offset", Kind::numbers_2},
                                     {transform + "scale", Kind::numbers_2},
                                     {transform + "rotation", Kind::number},
                                     {transform + "texCoord", Kind::whole}})
      checker.check({path.c_str(), kind});
    checker.check({(at + "/index").c_str(), Kind::index, required, "textures"});
  }
}

}  // namespace mmverify::scene
