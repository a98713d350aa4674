#include "scene/read/materials.hpp"

#include <charconv>
#include <cmath>

#include "scene/read/bad_scene.hpp"
#include "scene/read/extensions.hpp"
#include "scene/read/moving_textures.hpp"
#include "scene/read/texture_source.hpp"

namespace mmverify::scene {
namespace {

Wrap wrap(int mode, const std::string& file, const std::string& at) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT: return Wrap::repeat;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT: return Wrap::mirrored_repeat;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE: return Wrap::clamp_to_edge;
    default:
      throw BadScene(file, at, "wrap mode " + std::to_string(mode) + " is none of 10497, 33071, 33648");
  }
}

Sampler read_sampler(const tinygltf::Sampler& given, const std::string& file, const std::string& at) {
  Sampler sampler;
  sampler.wrap_u = wrap(given.wrapS, file, at);
  sampler.wrap_v = wrap(given.wrapT, file, at);
  switch (given.magFilter) {
    case -1: break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST: sampler.magnification = Filter::nearest; break;
    case TINYGLTF_TEXTURE_FILTER_LINEAR: sampler.magnification = Filter::linear; break;
    default:
      throw BadScene(file, at, "magFilter " + std::to_string(given.magFilter) + " is none of 9728, 9729");
  }
  const auto minify = [&](Filter within, std::optional<Filter> between) {
    sampler.minification = within;
    sampler.between_mips = between;
  };
  switch (given.minFilter) {
    case -1: break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST: minify(Filter::nearest, {}); break;
    case TINYGLTF_TEXTURE_FILTER_LINEAR: minify(Filter::linear, {}); break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST: minify(Filter::nearest, Filter::nearest); break;
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST: minify(Filter::linear, Filter::nearest); break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR: minify(Filter::nearest, Filter::linear); break;
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR: minify(Filter::linear, Filter::linear); break;
    default:
      throw BadScene(file, at,
                     "minFilter " + std::to_string(given.minFilter) + " is none of 9728, 9729, 9984..9987");
  }
  return sampler;
}

class MaterialReader {
 public:
  MaterialReader(const Document& document, const Buffers& buffers) : document_(document), buffers_(buffers) {}

  Material material(std::size_t index) const {
    const tinygltf::Material& given = document_.model.materials[index];
    const nlohmann::json& json = document_.json["materials"][index];
    const std::string at = place("material", index, given.name);
    check_extensions(document_, json, at);
    Material material;
    material.name = given.name;
    if (given.alphaMode == "MASK")
      material.mode = AlphaMode::mask;
    else if (given.alphaMode == "BLEND")
      material.mode = AlphaMode::blend;
    else if (given.alphaMode != "OPAQUE")
      throw BadScene(document_.file, at,
                     "alphaMode '" + shown(given.alphaMode) + "' is none of OPAQUE, MASK, BLEND");
    material.cutoff = static_cast<float>(given.alphaCutoff);
    if (!(material.cutoff >= 0) || !std::isfinite(material.cutoff))
      throw BadScene(document_.file, at,
                     "alphaCutoff " + std::to_string(given.alphaCutoff) + " is not from 0 up");
    material.base_color_alpha = static_cast<float>(given.pbrMetallicRoughness.baseColorFactor.at(3));
    if (!(material.base_color_alpha >= 0 && material.base_color_alpha <= 1))
      throw BadScene(
          document_.file, at,
          "baseColorFactor's alpha " + std::to_string(material.base_color_alpha) + " is not from 0 to 1");
    const nlohmann::json& texture = member(member(json, "pbrMetallicRoughness"), "baseColorTexture");
    if (!texture.empty())
      material.texture = read_texture(document_, buffers_, texture, PictureUse::alpha, at);
    material.specular_glossiness = member(json, "extensions").contains("KHR_materials_pbrSpecularGlossiness");
    return material;
  }

 private:
  const Document& document_;
  const Buffers& buffers_;
};

/// Records a pointer such as
/// /materials/3/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform/offset
/// if it changes alpha or UVs: everything of the base colour below pbrMetallicRoughness, and the cutoff.
void note_animation(const std::string& pointer, std::vector<Material>& materials) {
  constexpr std::string_view root = "/materials/";
  if (!pointer.starts_with(root)) return;
  std::size_t index = 0;
  const auto [end, error] =
      std::from_chars(pointer.data() + root.size(), pointer.data() + pointer.size(), index);
  if (error != std::errc() || index >= materials.size()) return;
  const std::string_view property(end, static_cast<std::size_t>(pointer.data() + pointer.size() - end));
  if (property.empty() || property.starts_with("/alphaCutoff") ||
      property.find("/baseColor") != property.npos)
    materials[index].animated.push_back(shown(pointer));
}

}  // namespace

BaseColorTexture read_texture(const Document& document, const Buffers& buffers, const nlohmann::json& info,
                              PictureUse use, const std::string& at) {
  check_extensions(document, info, at);
  BaseColorTexture result;
  const auto index = info["index"].get<std::size_t>();
  const tinygltf::Texture& texture = document.model.textures[index];
  const TextureSource source = texture_source(document, buffers, index, use);
  result.image = source.image;
  result.note = source.note;
  if (texture.sampler >= 0) {
    const auto sampler = static_cast<std::size_t>(texture.sampler);
    result.sampler =
        read_sampler(document.model.samplers[sampler], document.file, at + ": " + place("sampler", sampler));
  }
  result.uv_set = info.value("texCoord", 0u);
  const nlohmann::json& transform = extension(info, "KHR_texture_transform");
  result.uv_set = transform.value("texCoord", result.uv_set);
  result.transform.offset = transform.value("offset", result.transform.offset);
  result.transform.scale = transform.value("scale", result.transform.scale);
  result.transform.rotation = transform.value("rotation", result.transform.rotation);
  return result;
}

std::vector<Material> read_materials(const Document& document, const Buffers& buffers) {
  std::vector<Material> materials;
  for (std::size_t k = 0; k < document.model.materials.size(); ++k)
    materials.push_back(MaterialReader(document, buffers).material(k));
  for (const nlohmann::json& animation : member(document.json, "animations"))
    for (const nlohmann::json& channel : member(animation, "channels")) {
      const nlohmann::json& pointer = extension(channel["target"], "KHR_animation_pointer");
      if (pointer.contains("pointer")) note_animation(pointer["pointer"].get<std::string>(), materials);
    }
  read_moving_textures(document, buffers, materials);
  return materials;
}

}  // namespace mmverify::scene
