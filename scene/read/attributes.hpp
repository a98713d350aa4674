// The textures of a scene with attributes of its surfaces: colours, normals, roughness.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/read/image.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// The attributes that a texture may have, in glTF's order.
enum class Attribute : std::uint8_t { base_color, metallic_roughness, normal, occlusion, emissive };
inline constexpr std::size_t attributes = 5;
std::string_view name(Attribute attribute);  ///< glTF's name: baseColor ...

/// A set of attributes, bit k for the k-th.
using AttributeSet = std::uint8_t;
constexpr AttributeSet set_of(Attribute a) {
  return static_cast<AttributeSet>(1u << static_cast<unsigned>(a));
}
constexpr bool has(AttributeSet set, Attribute a) { return (set & set_of(a)) != 0; }
std::string name(AttributeSet set);  ///< "metallicRoughness+occlusion"

/// The channels of a texel that attributes read: bit 0 red, 1 green, 2 blue.  Alpha is left out: it belongs
/// to the opacity micromap.
///   baseColor, emissive, normal: all three; metallicRoughness: green and blue; occlusion: red
/// Source: glTF 2.0, 3.9.
std::uint8_t channels_of(AttributeSet set);

/// Whether codes are sRGB, as for baseColor and emissive.  No set has attributes of both kinds.
bool is_srgb(AttributeSet set);

/// A texture as attributes read it.  Attributes of a material that read one image in the same way are one
/// set.
struct AttributeTexture {
  AttributeSet set = 0;
  std::size_t image = 0;
  Sampler sampler;
  bool operator==(const AttributeTexture&) const = default;
};

struct AttributeUse {
  std::size_t texture = 0;  ///< number in AttributeScene::textures
  std::vector<Uv> uvs;      ///< by the primitive's vertices, transformed
};

struct AttributePrimitive {
  std::size_t mesh = 0, number = 0;  ///< meshes[mesh].primitives[number]
  std::vector<Triangle> triangles;
  std::vector<AttributeUse> uses;
};

/// A primitive, or a part of its attributes, that gets no maps.
struct AttributeLeftOut {
  std::size_t mesh = 0, primitive = 0, triangles = 0;
  std::string why;
};

struct AttributeScene {
  std::string file;
  std::vector<ColourImage> images;  ///< of the file, by its indices; decoded if a texture names them
  std::vector<AttributeTexture> textures;
  std::vector<AttributePrimitive> primitives;  ///< with at least one use
  std::vector<AttributeLeftOut> left_out;
  std::uint64_t triangles = 0;  ///< of all primitives of the file
};

/// The attributes of a file's primitives in their own materials, without those of KHR_materials_variants.
/// Factors of a material and COLOR_0 are not applied: a map stands for its texture.
/// Errors: BadScene as of load(), and as of decode_colour(), which also defines the treatment of 16 bits.
AttributeScene load_attributes(const std::string& file);
AttributeScene load_attributes(const std::string& name, std::span<const unsigned char> bytes);

}  // namespace mmverify::scene
