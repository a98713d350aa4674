#include "scene/read/shading.hpp"

#include <cmath>

#include "scene/read/accessor.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/draco.hpp"
#include "scene/read/materials.hpp"
#include "scene/read/primitives.hpp"

namespace mmverify::scene {
namespace {

class Reader {
 public:
  explicit Reader(const Document& document) : document_(document), buffers_(document) {}

  std::vector<PrimitiveShading> all() const {
    std::vector<PrimitiveShading> all;
    for (const Primitive& primitive :
         read_primitives(document_, buffers_, read_materials(document_, buffers_)))
      if (!primitive.triangles.empty()) all.push_back(shading(primitive));
    return all;
  }

 private:
  PrimitiveShading shading(const Primitive& primitive) const {
    PrimitiveShading its{.mesh = primitive.mesh, .number = primitive.number};
    const auto& given = document_.model.meshes[primitive.mesh].primitives[primitive.number];
    const std::string at = place("mesh", primitive.mesh) + " " + place("primitive", primitive.number);
    if (const auto found = given.attributes.find("NORMAL"); found != given.attributes.end()) {
      const auto draco = draco_mesh(
          document_, buffers_, document_.json["meshes"][primitive.mesh]["primitives"][primitive.number], at);
      const std::vector<float> values =
          read_floats(document_, buffers_, static_cast<std::size_t>(found->second), 3, Integers::any,
                      at + " NORMAL", draco ? draco->attribute("NORMAL") : nullptr);
      if (values.size() != 3 * primitive.positions.size())
        throw BadScene(document_.file, at + " NORMAL",
                       std::to_string(values.size() / 3) + " elements, of " +
                           std::to_string(primitive.positions.size()) + " vertices");
      for (std::size_t k = 0; k < values.size(); k += 3)
        its.normals.push_back({values[k], values[k + 1], values[k + 2]});
    }
    if (!primitive.material) return its;
    const nlohmann::json& json = document_.json["materials"][*primitive.material];
    const std::string material = place("material", *primitive.material);
    const nlohmann::json& rough = member(json, "pbrMetallicRoughness");
    if (rough.is_object() && rough.contains("baseColorFactor"))
      for (std::size_t c = 0; c < 3; ++c)
        its.colour[c] = number(rough["baseColorFactor"][c], material + " baseColorFactor", true);
    const auto take = [&](const nlohmann::json& of, const char* name, bool share, float& factor) {
      if (of.is_object() && of.contains(name)) factor = number(of[name], material + " " + name, share);
    };
    take(rough, "metallicFactor", true, its.metallic);
    take(rough, "roughnessFactor", true, its.roughness);
    take(member(json, "normalTexture"), "scale", false, its.normal_scale);
    take(member(json, "occlusionTexture"), "strength", true, its.occlusion);
    return its;
  }

  /// A finite number of magnitude 10^6 at most; a share is from 0 to 1.
  float number(const nlohmann::json& json, const std::string& at, bool share) const {
    const double x = json.is_number() ? json.get<double>() : std::nan("");
    if (!std::isfinite(x) || std::fabs(x) > 1e6 || (share && !(x >= 0 && x <= 1)))
      throw BadScene(document_.file, at,
                     share ? "a number from 0 to 1 is due" : "a number of up to a million is due");
    return static_cast<float>(x);
  }

  const Document& document_;
  Buffers buffers_;
};

}  // namespace

std::vector<PrimitiveShading> load_shading(const std::string& file) {
  const Document document = open_document(file);
  return Reader(document).all();
}

std::vector<PrimitiveShading> load_shading(const std::string& name, std::span<const unsigned char> bytes) {
  const Document document = open_document(name, bytes);
  return Reader(document).all();
}

}  // namespace mmverify::scene
