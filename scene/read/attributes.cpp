#include "scene/read/attributes.hpp"

#include <algorithm>
#include <map>

#include "scene/read/bad_scene.hpp"
#include "scene/read/check_json.hpp"
#include "scene/read/materials.hpp"
#include "scene/read/primitives.hpp"
#include "scene/read/resource.hpp"

namespace mmverify::scene {
namespace {

constexpr std::array<std::string_view, attributes> names{"baseColor", "metallicRoughness", "normal",
                                                         "occlusion", "emissive"};

/// A texture of a material, with the attributes that read it in the same way.
struct MaterialTexture {
  AttributeSet set = 0;
  BaseColorTexture texture;
};

bool seen_alike(const BaseColorTexture& a, const BaseColorTexture& b) {
  return a.image == b.image && a.uv_set == b.uv_set && a.sampler == b.sampler && a.transform == b.transform;
}

std::vector<MaterialTexture> textures_of(const Document& document, const Buffers& buffers,
                                         std::size_t material) {
  const nlohmann::json& json = document.json["materials"][material];
  const nlohmann::json& rough = member(json, "pbrMetallicRoughness");
  const std::array<const nlohmann::json*, attributes> given{
      &member(rough, "baseColorTexture"), &member(rough, "metallicRoughnessTexture"),
      &member(json, "normalTexture"), &member(json, "occlusionTexture"), &member(json, "emissiveTexture")};
  std::vector<MaterialTexture> all;
  for (std::size_t k = 0; k < attributes; ++k) {
    if (given[k]->empty()) continue;
    const std::string at = place("material", material, json.value("name", std::string())) + " " +
                           std::string(names[k]) + "Texture";
    const AttributeSet set = set_of(static_cast<Attribute>(k));
    const BaseColorTexture texture = read_texture(document, buffers, *given[k], PictureUse::colour, at);
    const auto alike = std::find_if(all.begin(), all.end(), [&](const MaterialTexture& other) {
      return is_srgb(other.set) == is_srgb(set) && seen_alike(other.texture, texture);
    });
    if (alike == all.end())
      all.push_back({set, texture});
    else
      alike->set |= set;
  }
  return all;
}

/// The number of a texture; equal textures have one number.
std::size_t number_of(std::vector<AttributeTexture>& textures, const AttributeTexture& texture) {
  const auto found = std::find(textures.begin(), textures.end(), texture);
  if (found != textures.end()) return static_cast<std::size_t>(found - textures.begin());
  textures.push_back(texture);
  return textures.size() - 1;
}

AttributeScene attributes_of(const Document& document) {
  check_texture_json(document.json, document.file);
  const Buffers buffers(document);
  check_images_there(document);
  AttributeScene scene;
  scene.file = document.file;
  std::map<std::size_t, std::vector<MaterialTexture>> of_materials;
  for (Primitive& primitive : read_primitives(document, buffers, read_materials(document, buffers))) {
    const std::size_t count = primitive.triangles.size();
    scene.triangles += count;
    const auto leave_out = [&](const std::string& why) {
      scene.left_out.push_back({primitive.mesh, primitive.number, count, why});
    };
    if (count == 0) continue;
    if (!primitive.material) {
      leave_out("no material");
      continue;
    }
    auto& of_material = of_materials[*primitive.material];
    if (of_material.empty()) of_material = textures_of(document, buffers, *primitive.material);
    if (of_material.empty()) leave_out("no texture");
    AttributePrimitive its{primitive.mesh, primitive.number, {}, {}};
    for (const auto& [set, texture] : of_material) {
      if (!texture.image) {
        leave_out(name(set) + ": no image that is read");
        continue;
      }
      std::vector<Uv> uvs = read_uvs(document, buffers, primitive, texture);
      if (uvs.empty())
        leave_out(name(set) + ": no TEXCOORD_" + std::to_string(texture.uv_set));
      else
        its.uses.push_back(
            {number_of(scene.textures, {set, *texture.image, texture.sampler}), std::move(uvs)});
    }
    if (its.uses.empty()) continue;
    its.triangles = std::move(primitive.triangles);
    scene.primitives.push_back(std::move(its));
  }
  scene.images.resize(member(document.json, "images").size());
  for (std::size_t k = 0; k < scene.images.size(); ++k) {
    scene.images[k].name = image_name(document, k);
    if (std::none_of(scene.textures.begin(), scene.textures.end(),
                     [k](const AttributeTexture& texture) { return texture.image == k; }))
      continue;
    const std::string at = place("image", k, scene.images[k].name);
    decode_colour(image_bytes(document, buffers, k, at), scene.images[k], document.file, at);
  }
  return scene;
}

}  // namespace

std::string_view name(Attribute attribute) { return names[static_cast<std::size_t>(attribute)]; }

std::string name(AttributeSet set) {
  std::string all;
  for (std::size_t k = 0; k < attributes; ++k)
    if (has(set, static_cast<Attribute>(k))) all += (all.empty() ? "" : "+") + std::string(names[k]);
  return all;
}

std::uint8_t channels_of(AttributeSet set) {
  constexpr std::array<std::uint8_t, attributes> of{7, 6, 7, 1, 7};
  std::uint8_t channels = 0;
  for (std::size_t k = 0; k < attributes; ++k)
    if (has(set, static_cast<Attribute>(k))) channels |= of[k];
  return channels;
}

bool is_srgb(AttributeSet set) { return has(set, Attribute::base_color) || has(set, Attribute::emissive); }

AttributeScene load_attributes(const std::string& file) { return attributes_of(open_document(file)); }

AttributeScene load_attributes(const std::string& name, std::span<const unsigned char> bytes) {
  return attributes_of(open_document(name, bytes));
}

}  // namespace mmverify::scene
