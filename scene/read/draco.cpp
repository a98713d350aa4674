#include "scene/read/draco.hpp"

#ifdef MMVERIFY_HAS_DRACO
#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>
#endif

#include <new>

#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

#ifdef MMVERIFY_HAS_DRACO

class DracoDecoder {
 public:
  DracoDecoder(const Document& document, const Json& primitive, const std::string& at)
      : document_(document), primitive_(primitive), at_(at + ": " + draco_extension) {}

  DracoMesh decoded(std::span<const unsigned char> bytes, const Json& ids) {
    decode(bytes);
    DracoMesh result;
    if (primitive_.contains("indices")) result.indices = indices();
    for (const auto& [name, accessor] : primitive_["attributes"].items()) {
      const auto id = ids.find(name);
      // An attribute that the mesh lacks stands in its accessor.
      if (id == ids.end()) continue;
      if (!id->is_number_unsigned() || id->get<std::uint64_t>() > largest_file)
        bad("the attribute " + shown(name) + " has no whole number");
      result.attributes[name] = attribute(id->get<std::uint32_t>(), name, accessor.get<std::size_t>());
    }
    return result;
  }

 private:
  [[noreturn]] void bad(const std::string& what) const { throw BadScene(document_.file, at_, what); }
  [[noreturn]] void damaged(const std::string& what) const { throw DamagedData(document_.file, at_, what); }

  void decode(std::span<const unsigned char> bytes) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    try {
      const auto type = draco::Decoder::GetEncodedGeometryType(&buffer);
      if (!type.ok() || type.value() != draco::TRIANGULAR_MESH) damaged("no mesh of Draco; damaged file?");
      draco::Decoder decoder;
      auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
      if (!mesh.ok())
        damaged("it cannot be decoded (" + shown(mesh.status().error_msg_string()) + "); damaged file?");
      mesh_ = std::move(mesh).value();
    } catch (const std::bad_alloc&) {
      damaged("it asks for more memory than there is; damaged file?");
    } catch (const std::length_error&) {
      damaged("it asks for more memory than there is; damaged file?");
    }
  }

  const Json& accessor(std::size_t index, const std::string& name, std::uint64_t due) const {
    const Json& json = document_.json["accessors"][index];
    if (const auto count = json["count"].get<std::uint64_t>(); count != due)
      bad(place("accessor", index) + " has " + std::to_string(count) + " elements, " + name +
          " of the mesh " + std::to_string(due));
    return json;
  }

  Bytes indices() const {
    const std::size_t index = primitive_["indices"].get<std::size_t>();
    const Json& json = accessor(index, "the list of corners", std::uint64_t{3} * mesh_->num_faces());
    const auto type = json["componentType"].get<int>();
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type));
    if (size <= 0 || size > 4) bad("component type " + std::to_string(type) + " of indices");
    Bytes bytes;
    for (std::uint32_t f = 0; f < mesh_->num_faces(); ++f)
      for (const draco::PointIndex& point : mesh_->face(draco::FaceIndex(f))) {
        if (point.value() >= mesh_->num_points()) damaged("a corner beyond its points; damaged file?");
        for (int k = 0; k < size; ++k) bytes.push_back(static_cast<unsigned char>(point.value() >> (8 * k)));
      }
    return bytes;
  }

  Bytes attribute(std::uint32_t id, const std::string& name, std::size_t index) const {
    const draco::PointAttribute* const its = mesh_->GetAttributeByUniqueId(id);
    if (its == nullptr) bad("the mesh has no attribute " + std::to_string(id) + ", " + shown(name));
    const Json& json = accessor(index, shown(name), mesh_->num_points());
    const int components =
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(document_.model.accessors[index].type));
    if (its->num_components() != components)
      bad(shown(name) + " has " + std::to_string(its->num_components()) +
          " components in the mesh, its accessor " + std::to_string(components));
    switch (json["componentType"].get<int>()) {
      case TINYGLTF_COMPONENT_TYPE_BYTE: return values<std::int8_t>(*its, draco::DT_INT8, name);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return values<std::uint8_t>(*its, draco::DT_UINT8, name);
      case TINYGLTF_COMPONENT_TYPE_SHORT: return values<std::int16_t>(*its, draco::DT_INT16, name);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return values<std::uint16_t>(*its, draco::DT_UINT16, name);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return values<std::uint32_t>(*its, draco::DT_UINT32, name);
      default: return values<float>(*its, draco::DT_FLOAT32, name);
    }
  }

  template <class T>
  Bytes values(const draco::PointAttribute& its, draco::DataType due, const std::string& name) const {
    if (its.data_type() != due)
      bad(shown(name) + " has another component type in the mesh than in its accessor");
    const auto components = static_cast<std::size_t>(its.num_components());
    Bytes bytes(mesh_->num_points() * components * sizeof(T));
    for (std::uint32_t p = 0; p < mesh_->num_points(); ++p) {
      const draco::AttributeValueIndex value = its.mapped_index(draco::PointIndex(p));
      if (value.value() >= its.size()) damaged("a point without " + shown(name) + "; damaged file?");
      its.GetValue(value, bytes.data() + p * components * sizeof(T));
    }
    return bytes;
  }

  const Document& document_;
  const Json& primitive_;
  std::string at_;
  std::unique_ptr<draco::Mesh> mesh_;
};

#else

/// Whether each accessor of a primitive has its elements in a view, uncompressed.
bool is_uncompressed_too(const Document& document, const Json& primitive) {
  const auto held = [&](const Json& accessor) {
    return document.json["accessors"][accessor.get<std::size_t>()].contains("bufferView");
  };
  for (const Json& accessor : primitive["attributes"])
    if (!held(accessor)) return false;
  return !primitive.contains("indices") || held(primitive["indices"]);
}

#endif

}  // namespace

bool has_draco() noexcept {
#ifdef MMVERIFY_HAS_DRACO
  return true;
#else
  return false;
#endif
}

std::optional<DracoMesh> draco_mesh(const Document& document, [[maybe_unused]] const Buffers& buffers,
                                    const Json& primitive, const std::string& at) {
  const auto& extensions = member(primitive, "extensions");
  const auto given = extensions.find(draco_extension);
  if (given == extensions.end()) return {};
  const std::string of = at + ": " + draco_extension;
  const auto view = member(*given, "bufferView");
  const std::size_t views = member(document.json, "bufferViews").size();
  if (!view.is_number_unsigned() || view.get<std::uint64_t>() >= views ||
      !member(*given, "attributes").is_object())
    throw BadScene(document.file, of, "a bufferView that is there and an object of attributes are due");
#ifdef MMVERIFY_HAS_DRACO
  if (primitive.value("mode", TINYGLTF_MODE_TRIANGLES) != TINYGLTF_MODE_TRIANGLES)
    throw UnreadExtension(document.file, of, "a strip is not read here; store a list, mode 4");
  return DracoDecoder(document, primitive, at)
      .decoded(buffers.view(view.get<std::size_t>()), member(*given, "attributes"));
#else
  if (is_uncompressed_too(document, primitive)) return {};
  throw UnreadExtension(document.file, at,
                        std::string("compressed with ") + draco_extension +
                            ", and this program was built without Draco (Debian: libdraco-dev)");
#endif
}

}  // namespace mmverify::scene
