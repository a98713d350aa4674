#include "scene/read/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/read/accessor.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/draco.hpp"
#include "scene/read/extensions.hpp"
#include "scene/read/moving_textures.hpp"
#include "scene/read/triangles.hpp"

namespace mmverify::scene {
namespace {

std::optional<Topology> topology(int mode, const std::string& file, const std::string& at) {
  switch (mode) {
    case TINYGLTF_MODE_TRIANGLES: return Topology::list;
    case TINYGLTF_MODE_TRIANGLE_STRIP: return Topology::strip;
    case TINYGLTF_MODE_TRIANGLE_FAN: return Topology::fan;
    case TINYGLTF_MODE_POINTS:
    case TINYGLTF_MODE_LINE:
    case TINYGLTF_MODE_LINE_LOOP:
    case TINYGLTF_MODE_LINE_STRIP: return {};
    default: throw BadScene(file, at, "mode " + std::to_string(mode) + " is none of 0..6");
  }
}

class PrimitiveReader {
 public:
  PrimitiveReader(const Document& document, const Buffers& buffers, const std::vector<Material>& materials)
      : document_(document), buffers_(buffers), materials_(materials) {
    for (const char* list : {"extensionsUsed", "extensionsRequired"})
      for (const nlohmann::json& name : member(document.json, list))
        quantised_ |= name == "KHR_mesh_quantization";
  }

  std::vector<Uv> uvs_of(const Primitive& primitive, const BaseColorTexture& texture) {
    name(primitive.mesh, primitive.number);
    draco_ = draco_mesh(document_, buffers_,
                        document_.json["meshes"][primitive.mesh]["primitives"][primitive.number], at_);
    return uvs(primitive, texture);
  }

  Primitive primitive(std::size_t mesh, std::size_t number) {
    name(mesh, number);
    const nlohmann::json& json = document_.json["meshes"][mesh]["primitives"][number];
    check_extensions(document_, json, at_);
    Primitive primitive;
    primitive.mesh = mesh;
    primitive.number = number;
    if (given_->material >= 0) primitive.material = static_cast<std::size_t>(given_->material);
    primitive.variants = variants(json);
    primitive.morphs_uvs =
        std::any_of(given_->targets.begin(), given_->targets.end(), [](const auto& target) {
          return std::any_of(target.begin(), target.end(), [](const auto& attribute) {
            return attribute.first.starts_with("TEXCOORD_") || attribute.first.starts_with("COLOR_");
          });
        });
    const std::optional<Topology> drawn = topology(given_->mode, document_.file, at_);
    primitive.drawn_as_triangles = drawn.has_value();
    // Nothing is drawn without positions (glTF 2.0, 3.7.2.1).
    if (!drawn || !given_->attributes.contains("POSITION")) return primitive;
    draco_ = draco_mesh(document_, buffers_, json, at_);
    primitive.positions = positions();
    const std::vector<std::uint32_t> vertices = indices(primitive.positions.size());
    primitive.triangles = triangles(*drawn, vertices);
    primitive.uvs = uvs(primitive);
    primitive.moving_uvs = moving_uvs_of(primitive);
    primitive.vertex_alpha = vertex_alpha(primitive);
    count_unheld();
    count(primitive.positions.size() + primitive.triangles.size());
    return primitive;
  }

 private:
  void name(std::size_t mesh, std::size_t number) {
    given_ = &document_.model.meshes[mesh].primitives[number];
    at_ = place("mesh", mesh, document_.model.meshes[mesh].name) + " " + place("primitive", number);
    draco_.reset();
  }

  const int* attribute(const std::string& name) const {
    const auto found = given_->attributes.find(name);
    return found == given_->attributes.end() ? nullptr : &found->second;
  }

  std::vector<float> floats(const char* name, int accessor, int components, Integers unquantised) const {
    return read_floats(document_, buffers_, static_cast<std::size_t>(accessor), components,
                       quantised_ ? Integers::any : unquantised, at_ + " " + name, decoded(name));
  }

  /// The elements of an attribute that stands compressed in the file; null of another one.
  const Bytes* decoded(const std::string& name) const { return draco_ ? draco_->attribute(name) : nullptr; }

  std::vector<Position> positions() const {
    const std::vector<float> values = floats("POSITION", *attribute("POSITION"), 3, Integers::none);
    std::vector<Position> positions(values.size() / 3);
    for (std::size_t k = 0; k < positions.size(); ++k)
      positions[k] = {values[3 * k], values[3 * k + 1], values[3 * k + 2]};
    return positions;
  }

  std::vector<std::uint32_t> indices(std::size_t vertices) const {
    std::vector<std::uint32_t> indices;
    if (given_->indices < 0) {
      indices.resize(vertices);
      std::iota(indices.begin(), indices.end(), 0u);
      return indices;
    }
    indices = read_indices(document_, buffers_, static_cast<std::size_t>(given_->indices), at_ + " indices",
                           draco_ ? &draco_->indices : nullptr);
    const auto beyond =
        std::find_if(indices.begin(), indices.end(), [&](std::uint32_t i) { return i >= vertices; });
    if (beyond != indices.end())
      throw BadScene(document_.file, at_,
                     "index " + std::to_string(beyond - indices.begin()) + " is " + std::to_string(*beyond) +
                         ", of " + std::to_string(vertices) + " vertices");
    return indices;
  }

  std::vector<Uv> uvs(const Primitive& primitive) const {
    if (!primitive.material || !materials_[*primitive.material].texture) return {};
    return uvs(primitive, *materials_[*primitive.material].texture);
  }

  std::optional<MovingUvs> moving_uvs_of(const Primitive& primitive) const {
    if (primitive.uvs.empty() || !materials_[*primitive.material].moving) return std::nullopt;
    const Material& material = materials_[*primitive.material];
    BaseColorTexture untransformed = *material.texture;
    untransformed.transform = {};
    return moving_uvs(*material.moving, uvs(primitive, untransformed));
  }

  std::vector<Uv> uvs(const Primitive& primitive, const BaseColorTexture& texture) const {
    const std::string name = "TEXCOORD_" + std::to_string(texture.uv_set);
    const int* const accessor = attribute(name);
    if (accessor == nullptr) return {};
    const std::vector<float> values = floats(name.c_str(), *accessor, 2, Integers::unsigned_normalised);
    check_count(name, values.size() / 2, primitive);
    std::vector<Uv> uvs(values.size() / 2);
    for (std::size_t k = 0; k < uvs.size(); ++k) {
      uvs[k] = transformed(texture.transform, {values[2 * k], values[2 * k + 1]});
      if (!std::isfinite(uvs[k][0]) || !std::isfinite(uvs[k][1]))
        throw BadScene(document_.file, at_ + " " + name,
                       "element " + std::to_string(k) + " is not finite after KHR_texture_transform");
    }
    return uvs;
  }

  std::optional<VertexAlpha> vertex_alpha(const Primitive& primitive) const {
    const int* const accessor = attribute("COLOR_0");
    if (accessor == nullptr || primitive.triangles.empty() ||
        document_.model.accessors[static_cast<std::size_t>(*accessor)].type != TINYGLTF_TYPE_VEC4)
      return {};
    const std::vector<float> values = floats("COLOR_0", *accessor, 4, Integers::unsigned_normalised);
    check_count("COLOR_0", values.size() / 4, primitive);
    VertexAlpha alpha{values[4 * std::size_t{primitive.triangles[0][0]} + 3],
                      values[4 * std::size_t{primitive.triangles[0][0]} + 3]};
    for (const Triangle& triangle : primitive.triangles)
      for (const std::size_t vertex : triangle) {
        alpha.least = std::min(alpha.least, values[4 * vertex + 3]);
        alpha.greatest = std::max(alpha.greatest, values[4 * vertex + 3]);
      }
    if (alpha.least != alpha.greatest)
      for (std::size_t k = 3; k < values.size(); k += 4) alpha.of_vertices.push_back(values[k]);
    return alpha;
  }

  void check_count(const std::string& name, std::size_t elements, const Primitive& primitive) const {
    if (elements != primitive.positions.size())
      throw BadScene(document_.file, at_ + " " + name,
                     std::to_string(elements) + " elements for " +
                         std::to_string(primitive.positions.size()) + " vertices");
  }

  std::vector<VariantMaterial> variants(const nlohmann::json& json) const {
    const nlohmann::json& names = member(extension(document_.json, "KHR_materials_variants"), "variants");
    std::vector<VariantMaterial> all;
    for (const nlohmann::json& mapping : member(extension(json, "KHR_materials_variants"), "mappings")) {
      VariantMaterial variant{mapping["material"].get<std::size_t>(), {}};
      for (const nlohmann::json& index : mapping["variants"]) {
        if (index.get<std::size_t>() >= names.size())
          throw BadScene(document_.file, at_,
                         "variant " + index.dump() + " of KHR_materials_variants, of which there are " +
                             std::to_string(names.size()));
        variant.variants.push_back(names[index.get<std::size_t>()]["name"].get<std::string>());
      }
      all.push_back(std::move(variant));
    }
    return all;
  }

  /// Counts elements of accessors without a view: zeros that cost the file nothing.
  void count_unheld() {
    constexpr std::size_t most = std::size_t{1} << 22;
    const auto add = [&](int accessor) {
      const tinygltf::Accessor& its = document_.model.accessors[static_cast<std::size_t>(accessor)];
      if (its.bufferView >= 0) return;
      if (its.count > most - unheld_)
        throw BadScene(document_.file, at_,
                       "more than 2^22 elements in all that no bufferView holds; that much is not read");
      unheld_ += its.count;
    };
    if (given_->indices >= 0 && !draco_) add(given_->indices);
    for (const auto& [name, accessor] : given_->attributes)
      if (decoded(name) == nullptr) add(accessor);
  }

  /// Counts vertices and triangles.  Many primitives may share one accessor, so a small file may describe a
  /// large scene.
  void count(std::size_t more) {
    constexpr std::size_t most = std::size_t{1} << 26;
    if (more > most - counted_)
      throw BadScene(document_.file, at_,
                     "more than 2^26 vertices and triangles in all; that much is not read");
    counted_ += more;
  }

  const Document& document_;
  const Buffers& buffers_;
  const std::vector<Material>& materials_;
  bool quantised_ = false;
  std::size_t counted_ = 0, unheld_ = 0;
  const tinygltf::Primitive* given_ = nullptr;
  std::optional<DracoMesh> draco_;
  std::string at_;
};

}  // namespace

std::vector<Primitive> read_primitives(const Document& document, const Buffers& buffers,
                                       const std::vector<Material>& materials) {
  PrimitiveReader reader(document, buffers, materials);
  std::vector<Primitive> primitives;
  for (std::size_t mesh = 0; mesh < document.model.meshes.size(); ++mesh)
    for (std::size_t number = 0; number < document.model.meshes[mesh].primitives.size(); ++number)
      primitives.push_back(reader.primitive(mesh, number));
  return primitives;
}

std::vector<Uv> read_uvs(const Document& document, const Buffers& buffers, const Primitive& primitive,
                         const BaseColorTexture& texture) {
  return PrimitiveReader(document, buffers, {}).uvs_of(primitive, texture);
}

}  // namespace mmverify::scene
