// scene/attribute/: which textures of a glTF file are colours, normals and the rest, and on which triangles they lie.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/attribute/measure.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "scene/write/png.hpp"
#include "tests/complaint.hpp"
#include "tests/scene/gltf_file.hpp"

namespace scene_attribute_read_test {

using namespace mmverify::scene;
using namespace mmverify::tests;

/// The square of gltf_file.hpp with textures of every attribute; those of roughness and occlusion are one image.
GltfFile textured_square() {
  GltfFile file = square();
  const auto image = [&](std::uint8_t red) {
    std::vector<std::uint8_t> rgb(12, 50);
    rgb[0] = red;
    const auto bytes = mmverify::scene::png(2, 2, rgb);
    return file.add("images",
                    {{"bufferView", file.add_view({bytes.begin(), bytes.end()})}, {"mimeType", "image/png"}});
  };
  const auto texture = [&](std::size_t source) { return file.add("textures", {{"source", source}}); };
  const std::size_t rough = texture(image(11)), normal = texture(image(12)), emissive = texture(image(13));
  Json& material = file.json["materials"][0];
  material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", rough}};
  material["occlusionTexture"] = {{"index", rough}};
  material["normalTexture"] = {{"index", normal}};
  material["emissiveTexture"] = {{"index", emissive}};
  file.set_buffer_length();
  return file;
}

AttributeScene read(const GltfFile& file) { return load_attributes("square.glb", as_bytes(file.glb())); }

std::vector<std::string> names_of(const AttributeScene& scene) {
  std::vector<std::string> names;
  for (const AttributeTexture& texture : scene.textures) names.push_back(name(texture.set));
  return names;
}

TEST(AttributeRead, FindsEveryTextureAndJoinsThoseSeenAlike) {
  const AttributeScene scene = read(textured_square());
  EXPECT_THAT(names_of(scene),
              testing::ElementsAre("baseColor", "metallicRoughness+occlusion", "normal", "emissive"));
  ASSERT_EQ(scene.primitives.size(), 1u);
  EXPECT_EQ(scene.primitives[0].triangles.size(), 2u);
  EXPECT_EQ(scene.primitives[0].uses.size(), 4u);
  EXPECT_EQ(scene.triangles, 2u);
  EXPECT_EQ(scene.images[scene.textures[2].image].rgba[0], 12);
  EXPECT_TRUE(is_srgb(scene.textures[0].set));
  EXPECT_FALSE(is_srgb(scene.textures[1].set));
  EXPECT_FALSE(is_srgb(scene.textures[2].set));
  EXPECT_TRUE(is_srgb(scene.textures[3].set));
}

TEST(AttributeRead, OcclusionSeenByItselfHasItsOwnMaps) {
  GltfFile file = textured_square();
  file.json["materials"][0]["occlusionTexture"]["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.5, 0.25}}};
  const AttributeScene scene = read(file);
  EXPECT_THAT(names_of(scene),
              testing::ElementsAre("baseColor", "metallicRoughness", "normal", "occlusion", "emissive"));
  const auto& uses = scene.primitives[0].uses;
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(uses[3].uvs[k][0], uses[1].uvs[k][0] + 0.5f);
    EXPECT_EQ(uses[3].uvs[k][1], uses[1].uvs[k][1] + 0.25f);
  }
}

TEST(AttributeRead, AnImageOfColourAndOfDataIsTwo) {
  GltfFile file = textured_square();
  file.json["materials"][0]["normalTexture"] = file.base_color()["baseColorTexture"];
  EXPECT_THAT(names_of(read(file)),
              testing::ElementsAre("baseColor", "metallicRoughness+occlusion", "normal", "emissive"));
}

TEST(AttributeRead, SaysWhatGetsNoMaps) {
  GltfFile file = textured_square();
  file.json["materials"][0]["normalTexture"]["texCoord"] = 3;
  file.json["textures"][file.json["materials"][0]["emissiveTexture"]["index"].get<std::size_t>()].erase(
      "source");
  const AttributeScene scene = read(file);
  ASSERT_EQ(scene.left_out.size(), 2u);
  EXPECT_EQ(scene.left_out[0].why, "normal: no TEXCOORD_3");
  EXPECT_EQ(scene.left_out[1].why, "emissive: no image that is read");
  EXPECT_EQ(scene.left_out[1].triangles, 2u);
  GltfFile bare = square();
  bare.primitive().erase("material");
  EXPECT_EQ(read(bare).left_out.at(0).why, "no material");
  GltfFile untextured = square();
  untextured.base_color().erase("baseColorTexture");
  EXPECT_EQ(read(untextured).left_out.at(0).why, "no texture");
  EXPECT_TRUE(read(untextured).textures.empty());
}

TEST(AttributeRead, RefusesWhatOpacityNeedNotRead) {
  GltfFile file = textured_square();
  file.json["materials"][0]["normalTexture"]["index"] = 99;
  EXPECT_NO_THROW(load("square.glb", as_bytes(file.glb())));
  EXPECT_THAT(complaint_of<BadScene>([&] { read(file); }),
              testing::HasSubstr("/materials/0/normalTexture/index"));
  file.json["materials"][0]["normalTexture"] = {{"index", 0}, {"texCoord", -1}};
  EXPECT_THROW(read(file), BadScene);
}

TEST(AttributeRead, TheSuitesOwnSceneHasColours) {
  const AttributeScene scene = load_attributes("sample", sample_scene());
  EXPECT_FALSE(scene.textures.empty());
  const AttributeFigures figures = measure(scene, {.first = 0, .last = 1});
  EXPECT_GT(figures.sets.at(0).triangles, 0u);
}

}  // namespace scene_attribute_read_test
