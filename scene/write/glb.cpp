#include "scene/write/glb.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

#include "scene/read/accessor.hpp"
#include "scene/read/triangles.hpp"
#include "scene/write/resources.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

constexpr const char* extension_name = "EXT_mesh_opacity_micromap";
constexpr int list = 4, strip = 5, fan = 6;
constexpr int element_array_buffer = 34963;

int component_type(impl::micromap::Encoding encoding) {
  switch (encoding) {
    case impl::micromap::Encoding::u8: return TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    case impl::micromap::Encoding::u16: return TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    case impl::micromap::Encoding::u32: return TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    case impl::micromap::Encoding::i16: return TINYGLTF_COMPONENT_TYPE_SHORT;
    case impl::micromap::Encoding::i32: return TINYGLTF_COMPONENT_TYPE_INT;
  }
  throw std::invalid_argument("to_glb: unknown encoding");
}

void erase_extension(Json& object) {
  const auto extensions = object.find("extensions");
  if (extensions != object.end() && extensions->erase(extension_name) != 0 && extensions->empty())
    object.erase("extensions");
}

void erase_name(Json& json, const char* list_of_names) {
  const auto names = json.find(list_of_names);
  if (names == json.end()) return;
  names->erase(std::remove(names->begin(), names->end(), extension_name), names->end());
  if (names->empty()) json.erase(list_of_names);  // glTF has no empty lists
}

/// Removes the micromaps that are there, except for their bytes.
void erase_micromaps(Json& json) {
  erase_name(json, "extensionsUsed");
  erase_name(json, "extensionsRequired");
  erase_extension(json);
  if (const auto meshes = json.find("meshes"); meshes != json.end())
    for (Json& mesh : *meshes)
      for (Json& primitive : mesh["primitives"]) erase_extension(primitive);
}

class Writer {
 public:
  explicit Writer(const Document& document)
      : document_(document), buffers_(document), json_(document.json), binary_(json_) {}

  Bytes written(const Micromaps& micromaps) {
    embed_buffers(document_, buffers_, json_, binary_);
    embed_images(document_, json_, binary_);
    erase_micromaps(json_);
    if (!micromaps.arrays.empty()) {
      json_["extensionsUsed"].push_back(extension_name);
      for (const impl::micromap::Array& array : micromaps.arrays) add(array);
    }
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (const PrimitiveMicromaps& primitive : micromaps.primitives) {
      at_ = "to_glb: meshes[" + std::to_string(primitive.mesh) + "].primitives[" +
            std::to_string(primitive.number) + "]: ";
      if (!seen.insert({primitive.mesh, primitive.number}).second) bad("comes twice");
      if (primitive.micromap >= micromaps.arrays.size()) bad("its array is not there");
      add(primitive);
    }
    // Empty views need a buffer all the same.
    constexpr unsigned char zero = 0;
    if (binary_.bytes().empty() && !member(json_, "bufferViews").empty()) binary_.append({&zero, 1});
    return glb(std::move(json_), binary_);
  }

 private:
  [[noreturn]] void bad(const std::string& what) const { throw std::invalid_argument(at_ + what); }

  void add(const impl::micromap::Array& given) {
    // The draft has no empty view and no empty usageCounts, so an array without records gets one record.
    static const impl::micromap::Array nobody_uses{{{0, 0, 2}}, {0}};
    const impl::micromap::Array& array = given.records.empty() ? nobody_uses : given;
    if (array.data.empty()) throw std::invalid_argument("to_glb: an array of records without data");
    Json counts = Json::array(), levels = Json::array(), formats = Json::array();
    for (const impl::micromap::UsageCount& usage : impl::micromap::usage_counts(array.records)) {
      counts.push_back(usage.count);
      levels.push_back(usage.level);
      formats.push_back(usage.format);
    }
    const std::size_t data = binary_.add_view(array.data);
    const std::size_t triangles = binary_.add_view(impl::micromap::record_buffer(array.records));
    json_["extensions"][extension_name]["micromaps"].push_back({{"data", data},
                                                                {"triangles", triangles},
                                                                {"usageCounts", std::move(counts)},
                                                                {"usageLevels", std::move(levels)},
                                                                {"usageFormats", std::move(formats)}});
  }

  void add(const PrimitiveMicromaps& micromaps) {
    const auto& meshes = document_.model.meshes;
    if (micromaps.mesh >= meshes.size() || micromaps.number >= meshes[micromaps.mesh].primitives.size())
      bad("is not there");
    given_ = &meshes[micromaps.mesh].primitives[micromaps.number];
    Json& primitive = json_["meshes"][micromaps.mesh]["primitives"][micromaps.number];
    std::size_t triangles = vertices() / 3;
    const int mode = given_->mode < 0 ? list : given_->mode;
    if (mode == strip || mode == fan)
      triangles = write_list(mode == strip ? Topology::strip : Topology::fan, primitive);
    else if (mode != list)
      bad("draws no triangles");
    if (triangles == 0) bad("has no triangles");
    Json& added = primitive["extensions"][extension_name];
    added = {{"micromap", micromaps.micromap}};
    if (micromaps.base_triangle != 0) added["micromapBaseTriangle"] = micromaps.base_triangle;
    if (!micromaps.extras.empty()) added["extras"] = Json::parse(micromaps.extras);
    if (!micromaps.indices) return;
    const std::span<const std::uint8_t> indices = *micromaps.indices;
    if (indices.size() != triangles * (impl::micromap::width(micromaps.encoding) / 8))
      bad(std::to_string(indices.size()) + " bytes of indices for " + std::to_string(triangles) +
          " triangles");
    added["micromapIndices"] = add_scalars(indices, component_type(micromaps.encoding), triangles, 0);
  }

  /// The number of vertices that the primitive draws from, with or without indices.
  std::size_t vertices() const {
    const auto positions = given_->attributes.find("POSITION");
    if (positions == given_->attributes.end()) return 0;
    const int accessor = given_->indices < 0 ? positions->second : given_->indices;
    return document_.model.accessors[static_cast<std::size_t>(accessor)].count;
  }

  /// Writes a strip or fan as a list, and returns the number of triangles.
  std::size_t write_list(Topology topology, Json& primitive) {
    std::vector<std::uint32_t> in_order;
    int type = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (given_->indices >= 0) {
      const auto accessor = static_cast<std::size_t>(given_->indices);
      in_order = read_indices(document_, buffers_, accessor, "strip or fan");
      type = document_.model.accessors[accessor].componentType;
    } else {
      constexpr std::size_t most_of_16_bits = 0xffff;  // which is a restart itself
      in_order.resize(vertices());
      std::iota(in_order.begin(), in_order.end(), 0u);
      if (in_order.size() <= most_of_16_bits) type = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    }
    const std::vector<Triangle> listed = triangles(topology, in_order);
    const auto size =
        static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)));
    Bytes bytes;
    for (const Triangle& triangle : listed)
      for (const std::uint32_t vertex : triangle)
        for (std::size_t k = 0; k < size; ++k) bytes.push_back(static_cast<unsigned char>(vertex >> (8 * k)));
    if (!listed.empty()) {
      primitive["mode"] = list;
      primitive["indices"] = add_scalars(bytes, type, 3 * listed.size(), element_array_buffer);
    }
    return listed.size();
  }

  std::size_t add_scalars(std::span<const unsigned char> bytes, int type, std::size_t count, int target) {
    Json& accessors = json_["accessors"];
    accessors.push_back({{"bufferView", binary_.add_view(bytes, target)},
                         {"componentType", type},
                         {"count", count},
                         {"type", "SCALAR"}});
    return accessors.size() - 1;
  }

  const Document& document_;
  Buffers buffers_;
  Json json_;
  BinaryChunk binary_;
  const tinygltf::Primitive* given_ = nullptr;
  std::string at_;
};

}  // namespace

Bytes to_glb(const std::string& file, const Micromaps& micromaps) {
  return Writer(open_document(file)).written(micromaps);
}

Bytes to_glb(const std::string& name, std::span<const unsigned char> bytes, const Micromaps& micromaps) {
  return Writer(open_document(name, bytes)).written(micromaps);
}

std::uint64_t old_micromap_bytes(const std::string& file) {
  const Document document = open_document(file);
  const Json& json = document.json;
  std::set<std::size_t> views, accessors;
  const auto add = [](std::set<std::size_t>& to, const Json& number) {
    if (number.is_number_unsigned()) to.insert(number.get<std::size_t>());
  };
  for (const Json& micromap : member(extension(json, extension_name), "micromaps"))
    for (const char* part : {"data", "triangles"}) add(views, member(micromap, part));
  for (const Json& mesh : member(json, "meshes"))
    for (const Json& primitive : mesh["primitives"])
      add(accessors, member(extension(primitive, extension_name), "micromapIndices"));
  const Json& all = member(json, "accessors");
  for (const std::size_t k : accessors)
    if (k < all.size()) add(views, member(all[k], "bufferView"));
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!accessors.contains(k) && all[k].contains("bufferView"))
      views.erase(all[k]["bufferView"].get<std::size_t>());
  std::uint64_t bytes = 0;
  for (const std::size_t view : views)
    if (view < document.model.bufferViews.size()) bytes += document.model.bufferViews[view].byteLength;
  return bytes;
}

}  // namespace mmverify::scene
