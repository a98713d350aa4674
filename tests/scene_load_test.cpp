// scene/: what is read of a glTF file, and what is said of one that cannot be read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/read/triangles.hpp"
#include "tests/folder.hpp"
#include "tests/gltf_file.hpp"

namespace {

using namespace mmverify::scene;
using namespace mmverify::tests;
using testing::ElementsAre;
using testing::HasSubstr;

/// Writes the content as a file and loads it.
Scene load_text(const std::string& content, const std::string& name = "leaf.gltf") {
  const Folder folder;
  GltfFile::write(folder / name, content);
  return load(folder / name);
}

Scene load_glb(GltfFile file) {
  file.set_buffer_length();
  return load_text(file.glb(), "leaf.glb");
}

/// What the error says, after the folder; the loading must fail.
std::string complaint(const std::string& content, const std::string& name = "leaf.glb") {
  const Folder folder;
  GltfFile::write(folder / name, content);
  try {
    load(folder / name);
  } catch (const BadScene& bad) {
    const std::string what = bad.what(), start = folder.path().string() + "/";
    EXPECT_TRUE(what.starts_with(start + name + ": ")) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    return what.substr(start.size());
  }
  ADD_FAILURE() << "loaded";
  return "";
}

std::string complaint(const GltfFile& file) { return complaint(file.glb()); }

std::vector<std::uint8_t> alpha8(const Image& image) { return std::get<0>(image.alpha); }
std::vector<std::uint16_t> alpha16(const Image& image) { return std::get<1>(image.alpha); }

GltfFile with_image(const std::string& bytes) {
  GltfFile file = square();
  file.json["images"][0]["bufferView"] = file.add_view(bytes);
  file.set_buffer_length();
  return file;
}

void expect_square(const Scene& scene) {
  ASSERT_EQ(scene.primitives.size(), 1u);
  const Primitive& primitive = scene.primitives[0];
  EXPECT_THAT(primitive.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(primitive.positions,
              ElementsAre(Position{0, 0, 0}, Position{1, 0, 0}, Position{1, 1, 0}, Position{0, 1, 0}));
  EXPECT_THAT(primitive.uvs, ElementsAre(Uv{0, 1}, Uv{1, 1}, Uv{1, 0}, Uv{0, 0}));
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].width, 2u);
  EXPECT_EQ(scene.images[0].height, 2u);
  EXPECT_EQ(alpha8(scene.images[0]), (std::vector<std::uint8_t>{0, 85, 170, 255}));
  EXPECT_EQ(scene.meshes.at(0).uses, 1u);
  const Material& material = scene.material_of(primitive);
  EXPECT_EQ(material.name, "leaf");
  EXPECT_EQ(material.mode, AlphaMode::mask);
  EXPECT_EQ(material.cutoff, 0.5f);
  EXPECT_EQ(material.base_color_alpha, 1);
}

TEST(SceneLoad, Glb) { expect_square(load_glb(square())); }

TEST(SceneLoad, DataUris) {
  GltfFile file = square();
  file.json["images"][0] = {{"uri", "data:image/png;base64," + base64(small_png())}};
  expect_square(load_text(file.gltf_with_data_uri()));
}

TEST(SceneLoad, FilesBeside) {
  const Folder folder;
  fs::create_directory(folder / "a b");
  GltfFile file = square();
  file.json["images"][0] = {{"uri", "a%20b/leaf.png"}};
  file.json["buffers"][0]["uri"] = "leaf.bin";
  GltfFile::write(folder / "a b/leaf.png", small_png());
  GltfFile::write(folder / "leaf.bin", file.bytes + "more than byteLength");
  GltfFile::write(folder / "leaf.gltf", file.json.dump());
  expect_square(load(folder / "leaf.gltf"));
}

TEST(SceneLoad, StripsAndFans) {
  const std::vector<std::uint32_t> v{7, 3, 5, 2, 9};
  EXPECT_THAT(triangles(Topology::list, v), ElementsAre(Triangle{7, 3, 5}));
  // glTF 2.0, 3.7.2.1: p_i = {v_i, v_i+1+i%2, v_i+2-i%2} and p_i = {v_i+1, v_i+2, v_0}.
  EXPECT_THAT(triangles(Topology::strip, v),
              ElementsAre(Triangle{7, 3, 5}, Triangle{3, 2, 5}, Triangle{5, 2, 9}));
  EXPECT_THAT(triangles(Topology::fan, v),
              ElementsAre(Triangle{3, 5, 7}, Triangle{5, 2, 7}, Triangle{2, 9, 7}));
  for (const Topology topology : {Topology::list, Topology::strip, Topology::fan})
    EXPECT_TRUE(triangles(topology, std::span(v).first(2)).empty());

  GltfFile file = square();
  file.primitive()["mode"] = 5;
  EXPECT_THAT(load_glb(file).primitives[0].triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{1, 0, 2}, Triangle{2, 0, 2}, Triangle{0, 3, 2}));
  file.primitive()["mode"] = 6;
  file.primitive().erase("indices");
  EXPECT_THAT(load_glb(file).primitives[0].triangles, ElementsAre(Triangle{1, 2, 0}, Triangle{2, 3, 0}));
  file.primitive()["mode"] = 5;
  EXPECT_THAT(load_glb(file).primitives[0].triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2}));
  file.primitive()["mode"] = 4;
  EXPECT_THAT(load_glb(file).primitives[0].triangles, ElementsAre(Triangle{0, 1, 2}));
  file.primitive()["mode"] = 1;
  EXPECT_FALSE(load_glb(file).primitives[0].drawn_as_triangles);
  EXPECT_TRUE(load_glb(file).primitives[0].triangles.empty());
}

TEST(SceneLoad, NormalisedUvs) {
  GltfFile file = square();
  Json& uvs = file.primitive()["attributes"]["TEXCOORD_0"];
  uvs = file.add_accessor<std::uint8_t>({0, 255, 1, 128, 254, 85, 3, 7}, 5121, "VEC2", 2, true);
  EXPECT_THAT(load_glb(file).primitives[0].uvs,
              ElementsAre(Uv{0, 1}, Uv{1 / 255.f, 128 / 255.f}, Uv{254 / 255.f, 85 / 255.f},
                          Uv{3 / 255.f, 7 / 255.f}));
  uvs = file.add_accessor<std::uint16_t>({0, 65535, 1, 32768, 9, 9, 9, 9}, 5123, "VEC2", 2, true);
  const auto read = load_glb(file).primitives[0].uvs;
  EXPECT_EQ(read[0], (Uv{0, 1}));
  EXPECT_EQ(read[1], (Uv{1 / 65535.f, 32768 / 65535.f}));
  uvs = file.add_accessor<std::int16_t>({-32768, 32767, -32767, 1, 0, 0, 0, 0}, 5122, "VEC2", 2, true);
  EXPECT_THAT(complaint(file), HasSubstr("component type 5122, normalized, is not allowed"));
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto quantised = load_glb(file).primitives[0].uvs;
  EXPECT_EQ(quantised[0], (Uv{-1, 1}));
  EXPECT_EQ(quantised[1], (Uv{-1, 1 / 32767.f}));
}

TEST(SceneLoad, TheUvSetThatTheTextureNamesAndItsTransform) {
  GltfFile file = square();
  file.primitive()["attributes"]["TEXCOORD_3"] =
      file.add_accessor<float>({1, 0, 0, 1, 0.25f, 0.5f, -3, 7}, 5126, "VEC2", 2);
  file.base_color()["baseColorTexture"]["texCoord"] = 3;
  EXPECT_EQ(load_glb(file).primitives[0].uvs[3], (Uv{-3, 7}));
  Json& transform = file.base_color()["baseColorTexture"]["extensions"]["KHR_texture_transform"];
  // Not through nulls and empty objects, which tinygltf drops.
  transform = Json::object();
  EXPECT_EQ(load_glb(file).primitives[0].uvs[3], (Uv{-3, 7}));
  // The extension's own example: the lower left quadrant.
  transform = {{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}};
  const auto uvs = load_glb(file).primitives[0].uvs;
  EXPECT_NEAR(uvs[0][0], 0, 1e-6);
  EXPECT_NEAR(uvs[0][1], 0.5, 1e-6);
  EXPECT_NEAR(uvs[1][0], 0.5, 1e-6);
  EXPECT_NEAR(uvs[1][1], 1, 1e-6);
  transform = {{"offset", {0, 1}}, {"scale", {1, -1}}, {"texCoord", 0}};
  EXPECT_THAT(load_glb(file).primitives[0].uvs, ElementsAre(Uv{0, 0}, Uv{1, 0}, Uv{1, 1}, Uv{0, 1}));
  transform["scale"] = {1e38, 1e300};
  EXPECT_THAT(complaint(file), HasSubstr("not finite after KHR_texture_transform"));
}

TEST(SceneLoad, SparseAccessors) {
  GltfFile file = square();
  const auto where = file.add_view(bytes_of<std::uint8_t>({3}));
  const auto what = file.add_view(bytes_of<float>({8, 9}));
  Json& sparse = file.accessor("TEXCOORD_0")["sparse"];
  sparse = {{"count", 1},
            {"indices", {{"bufferView", where}, {"componentType", 5121}}},
            {"values", {{"bufferView", what}}}};
  EXPECT_THAT(load_glb(file).primitives[0].uvs, ElementsAre(Uv{0, 1}, Uv{1, 1}, Uv{1, 0}, Uv{8, 9}));
  file.accessor("TEXCOORD_0").erase("bufferView");
  EXPECT_THAT(load_glb(file).primitives[0].uvs, ElementsAre(Uv{0, 0}, Uv{0, 0}, Uv{0, 0}, Uv{8, 9}));
  file.set_buffer_length();
  sparse["indices"]["componentType"] = 5126;
  EXPECT_THAT(complaint(file), HasSubstr("unsigned integers are due, not component type 5126"));
  sparse["indices"]["componentType"] = 5121;
  sparse["count"] = 2;
  EXPECT_THAT(complaint(file), HasSubstr("TEXCOORD_0: accessor 1: bytes 0..16 of bufferView 5, which has 8"));
  sparse["count"] = 1;
  file.bytes[file.json["bufferViews"][where]["byteOffset"].get<std::size_t>()] = 4;
  EXPECT_THAT(complaint(file), HasSubstr("sparse index 0 is 4 of 4 elements"));
}

TEST(SceneLoad, MaterialsAndSamplers) {
  GltfFile file = square();
  file.json["materials"][0]["alphaCutoff"] = 0.369287167;
  file.base_color()["baseColorFactor"] = {1, 1, 1, 0.7};
  file.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}});
  file.json["textures"][0]["sampler"] = 0;
  const Material material = load_glb(file).materials[0];
  EXPECT_EQ(material.cutoff, 0.369287167f);
  EXPECT_EQ(material.base_color_alpha, 0.7f);
  const Sampler& sampler = material.texture->sampler;
  EXPECT_EQ(sampler.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(sampler.wrap_v, Wrap::mirrored_repeat);
  EXPECT_EQ(sampler.magnification, Filter::nearest);
  EXPECT_EQ(sampler.minification, Filter::linear);
  EXPECT_EQ(sampler.between_mips, Filter::nearest);
  const Material plain = load_glb(square()).materials[0];
  EXPECT_EQ(plain.texture->sampler, Sampler{});
  EXPECT_FALSE(plain.texture->sampler.magnification);

  file.json["samplers"][0]["wrapS"] = 33069;
  EXPECT_THAT(complaint(file), HasSubstr("material 0 (leaf): sampler 0: wrap mode 33069"));
  file.json["samplers"][0] = {{"minFilter", 9983}};
  EXPECT_THAT(complaint(file), HasSubstr("minFilter 9983"));
  file.json["samplers"][0] = {{"magFilter", 9984}};
  EXPECT_THAT(complaint(file), HasSubstr("magFilter 9984"));
  file = square();
  file.json["materials"][0]["alphaMode"] = "SOFT";
  EXPECT_THAT(complaint(file), HasSubstr("alphaMode 'SOFT'"));
  file.json["materials"][0]["alphaMode"] = "BLEND";
  EXPECT_EQ(load_glb(file).materials[0].mode, AlphaMode::blend);
  file.json["materials"][0]["alphaCutoff"] = -0.25;
  EXPECT_THAT(complaint(file), HasSubstr("alphaCutoff -0.25"));
  file.json["materials"][0]["alphaCutoff"] = 2;
  EXPECT_EQ(load_glb(file).materials[0].cutoff, 2);
  file.base_color()["baseColorFactor"] = {1, 1, 1, 1.5};
  EXPECT_THAT(complaint(file), HasSubstr("baseColorFactor's alpha 1.5"));
}

TEST(SceneLoad, VertexAlphaVariantsAnimationsAndInstances) {
  GltfFile file = square();
  Json& attributes = file.primitive()["attributes"];
  EXPECT_FALSE(load_glb(file).primitives[0].vertex_alpha);
  attributes["COLOR_0"] = file.add_accessor<float>(std::vector<float>(12, 0.5f), 5126, "VEC3", 3);
  EXPECT_FALSE(load_glb(file).primitives[0].vertex_alpha);
  std::vector<std::uint8_t> colours(16, 255);
  colours[7] = 51;
  attributes["COLOR_0"] = file.add_accessor(colours, 5121, "VEC4", 4, true);
  const auto alpha = load_glb(file).primitives[0].vertex_alpha;
  ASSERT_TRUE(alpha);
  EXPECT_EQ(alpha->least, 0.2f);
  EXPECT_EQ(alpha->greatest, 1);

  file.add("materials", {{"name", "bare"}});
  file.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "summer"}},
                                                                   {{"name", "winter"}}};
  file.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 1}, {"variants", {1}}}};
  file.add(
      "animations",
      {{"channels",
        {{{"sampler", 0}, {"target", {{"path", "translation"}, {"node", 0}}}},
         {{"sampler", 0},
          {"target",
           {{"path", "pointer"},
            {"extensions",
             {{"KHR_animation_pointer",
               {{"pointer", "/materials/0/pbrMetallicRoughness/baseColorFactor"}}}}}}}},
         {{"sampler", 0},
          {"target",
           {{"path", "pointer"},
            {"extensions", {{"KHR_animation_pointer", {{"pointer", "/materials/1/emissiveFactor"}}}}}}}}}},
       {"samplers", {{{"input", 0}, {"output", 0}}}}});
  file.add("nodes", {{"mesh", 0}, {"children", {0}}});
  file.add("nodes", {{"mesh", 0},
                     {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", 0}}}}}}}});
  const Scene scene = load_glb(file);
  EXPECT_EQ(scene.meshes[0].uses, 6u);  // two nodes, and four instances
  EXPECT_EQ(count_triangles(scene).unique, 2u);
  EXPECT_EQ(count_triangles(scene).placed, 12u);
  ASSERT_EQ(scene.primitives[0].variants.size(), 1u);
  EXPECT_EQ(scene.primitives[0].variants[0].material, 1u);
  EXPECT_THAT(scene.primitives[0].variants[0].variants, ElementsAre("winter"));
  EXPECT_THAT(scene.materials[0].animated, ElementsAre("/materials/0/pbrMetallicRoughness/baseColorFactor"));
  EXPECT_TRUE(scene.materials[1].animated.empty());

  file.primitive()["extensions"]["KHR_materials_variants"]["mappings"][0]["variants"] = {2};
  EXPECT_THAT(complaint(file), HasSubstr("variant 2 of KHR_materials_variants, of which there are 2"));
}

TEST(SceneLoad, Images) {
  const std::string sixteen =
      png(1, 2, 16, 6, {std::string("\0\0\0\0\0\0\x12\x34", 8), "\1\1\1\1\1\1\xff\xfe"});
  const Scene deep = load_glb(with_image(sixteen));
  EXPECT_EQ(deep.images[0].bits(), 16);
  EXPECT_EQ(alpha16(deep.images[0]), (std::vector<std::uint16_t>{0x1234, 0xfffe}));
  const std::string palette = png(2, 1, 8, 3, {std::string("\1\0", 2)},
                                  big_endian(6) + "PLTEabcdef" + std::string(4, '\0') + big_endian(1) +
                                      "tRNS\x21" + std::string(4, '\0'));
  EXPECT_EQ(alpha8(load_glb(with_image(palette)).images[0]), (std::vector<std::uint8_t>{255, 0x21}));
  const std::string grey = png(2, 1, 8, 4, {"\1\2\3\4"});
  EXPECT_EQ(alpha8(load_glb(with_image(grey)).images[0]), (std::vector<std::uint8_t>{2, 4}));
  const std::string rgb = png(1, 1, 8, 2, {"abc"});
  EXPECT_EQ(alpha8(load_glb(with_image(rgb)).images[0]), (std::vector<std::uint8_t>{255}));

  std::string jpeg;
  const std::vector<unsigned char> pixels(5 * 3 * 3, 99);
  stbi_write_jpg_to_func(
      [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<char*>(data), static_cast<std::size_t>(size));
      },
      &jpeg, 5, 3, 3, pixels.data(), 90);
  const Scene opaque = load_glb(with_image(jpeg));
  EXPECT_EQ(opaque.images[0].width, 5u);
  EXPECT_EQ(alpha8(opaque.images[0]), std::vector<std::uint8_t>(15, 255));

  // Nobody looks into a picture that no alpha test reads.
  GltfFile unread = with_image("no picture at all");
  unread.json["materials"][0]["alphaMode"] = "OPAQUE";
  EXPECT_FALSE(load_glb(unread).images[0].decoded());
}

TEST(SceneLoad, BadImages) {
  const std::string good = small_png();
  EXPECT_THAT(complaint(with_image("GIF89a......................................")),
              HasSubstr("image 0 (leaf): neither PNG nor JPEG"));
  for (const std::size_t size : {9u, 30u, 40u, 60u})
    EXPECT_THAT(complaint(with_image(good.substr(0, size))), HasSubstr("truncated file?")) << size;
  EXPECT_THAT(complaint(with_image(png(0, 2, 8, 6, {""}))), HasSubstr("a PNG of 0 x 2 texels"));
  EXPECT_THAT(complaint(with_image(png(2, 0, 8, 6, {""}))), HasSubstr("a PNG of 2 x 0 texels"));
  EXPECT_THAT(complaint(with_image(png(16385, 1, 8, 6, {""}))), HasSubstr("1 to 16384 a side"));
  EXPECT_THAT(complaint(with_image(png(0xffffffff, 1, 8, 6, {""}))), HasSubstr("1 to 16384 a side"));
  EXPECT_THAT(complaint(with_image(png(16384, 16384, 8, 6, {""}))), HasSubstr("cannot be in"));
  EXPECT_THAT(complaint(with_image(png(2, 2, 8, 6, {"ab"}))), HasSubstr("cannot be decoded"));
  EXPECT_THAT(complaint(with_image("\xff\xd8\xff\xe0 and no more")), HasSubstr("truncated file?"));
  GltfFile nowhere = square();
  nowhere.json["images"][0] = {{"name", "leaf"}};
  EXPECT_THAT(complaint(nowhere), HasSubstr("image 0 (leaf): neither a URI nor a bufferView"));
  nowhere.json["images"][0] = {{"uri", "data:image/png;base64,"}};
  EXPECT_THAT(complaint(nowhere), HasSubstr("no base64 data URI"));
  nowhere.json["images"][0] = {{"bufferView", 9}};
  EXPECT_THAT(complaint(nowhere),
              HasSubstr("/images/0/bufferView: 9 is due to be an index into bufferViews"));
}

TEST(SceneLoad, MissingFilesWhicheverMaterialWantsThem) {
  GltfFile file = square();
  for (const char* mode : {"MASK", "OPAQUE"}) {
    file.json["materials"][0]["alphaMode"] = mode;
    file.json["images"][0] = {{"uri", "lost.png"}};
    EXPECT_EQ(complaint(file),
              "leaf.glb: image 0 (lost.png): there is no file 'lost.png' beside it; is the folder complete?");
    file.json["images"][0] = {{"uri", "https://example.org/leaf.png"}};
    EXPECT_THAT(complaint(file), HasSubstr("only files beside it and base64 data URIs are read"));
    file.json["images"][0] = {{"uri", "/etc/hostname"}};
    EXPECT_THAT(complaint(file), HasSubstr("no relative path"));
    file.json["images"][0] = {{"uri", "."}};
    EXPECT_THAT(complaint(file), HasSubstr("no regular file"));
    file.json["images"][0] = {{"uri", "two\nlines.png"}};
    EXPECT_THAT(complaint(file), HasSubstr("two?lines.png"));
  }
  file = square();
  for (const char* lost : {"a.png", "b%20c.png"}) file.json["images"].push_back({{"uri", lost}});
  EXPECT_EQ(complaint(file),
            "leaf.glb: images: there are no files 'a.png', 'b%20c.png' beside it; is the folder complete?");
  for (int k = 0; k < 20; ++k) file.json["images"].push_back({{"uri", "d.png"}});
  EXPECT_THAT(complaint(file), HasSubstr("'d.png' and 2 more beside it"));
  file = square();
  file.json["buffers"][0]["uri"] = "lost.bin";
  EXPECT_THAT(complaint(file.json.dump(), "leaf.gltf"), HasSubstr("buffer 0: there is no file 'lost.bin'"));
  EXPECT_THROW(load("no/such/file.glb"), BadScene);
  EXPECT_EQ(complaint("", "leaf.gltf"), "leaf.gltf: an empty file; truncated?");
}

TEST(SceneLoad, NoGltf) {
  EXPECT_THAT(complaint("{\"asset\": {\"version\": \"2.0\"", "leaf.gltf"), HasSubstr("JSON: no glTF"));
  EXPECT_THAT(complaint("\xff\xfe{}", "leaf.gltf"), HasSubstr("JSON: no glTF"));
  EXPECT_THAT(complaint("[1, 2]", "leaf.gltf"), HasSubstr("an object is due"));
  EXPECT_THAT(complaint("{\"asset\": {}}", "leaf.gltf"), HasSubstr("/asset/version: missing"));
  EXPECT_THAT(complaint("{\"asset\": {\"version\": \"1.0\"}}", "leaf.gltf"), HasSubstr("glTF 1.0"));
  EXPECT_TRUE(load_text("{\"asset\": {\"version\": \"2.0\"}}").primitives.empty());
  const std::string deep(100000, '['), deeper(100000, ']');
  EXPECT_THAT(
      complaint("{\"asset\": {\"version\": \"2.0\"}, \"extras\": " + deep + deeper + "}", "leaf.gltf"),
      HasSubstr("nested more than 64 deep"));
}

TEST(SceneLoad, BrokenContainers) {
  const std::string sound = square().glb();
  for (const std::size_t size : {5u, 11u, 12u, 19u, 100u})
    EXPECT_THAT(complaint(sound.substr(0, size)), HasSubstr("leaf.glb: GLB: ")) << size;
  EXPECT_THAT(complaint(sound.substr(0, sound.size() - 1)), HasSubstr("truncated file?"));
  const auto patched = [&](std::size_t at, std::uint32_t word) {
    std::string bytes = sound;
    return bytes.replace(at, 4, little_endian(word));
  };
  EXPECT_THAT(complaint(patched(4, 1)), HasSubstr("container version 1"));
  EXPECT_THAT(complaint(patched(12, 0xffffffff)), HasSubstr("chunk 0: bytes 20..4294967315 of a"));
  EXPECT_THAT(complaint(patched(12, 8)), HasSubstr("GLB"));
  EXPECT_THAT(complaint(patched(16, 0x004E4942)), HasSubstr("the JSON chunk must be the first"));
  EXPECT_THAT(complaint(sound + std::string(4, '\0')), HasSubstr("truncated file?"));
  // Any one byte of the container and of the JSON's start: whatever it says, an error or a scene.
  for (std::size_t at = 0; at < 200; ++at) {
    std::string bytes = sound;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x41);
    const Folder folder;
    GltfFile::write(folder / "leaf.glb", bytes);
    try {
      load(folder / "leaf.glb");
    } catch (const BadScene&) {
    }
  }
}

TEST(SceneLoad, LyingBuffersAndViews) {
  GltfFile file = square();
  file.json["buffers"][0]["byteLength"] = 100000;
  EXPECT_THAT(complaint(file), HasSubstr("buffer 0: byteLength is 100000, there are "));
  file = square();
  file.json["buffers"].push_back({{"byteLength", 4}});
  EXPECT_THAT(complaint(file), HasSubstr("buffer 1: no URI, and no BIN chunk"));
  file = square();
  file.view("TEXCOORD_0")["byteLength"] = 4000;
  const auto size = std::to_string(file.json["buffers"][0]["byteLength"].get<std::size_t>());
  EXPECT_EQ(complaint(file),
            "leaf.glb: bufferView 1: bytes 48..4048 of a " + size + "-byte buffer; truncated file?");
  file = square();
  file.json["bufferViews"].back()["byteOffset"] = 0x7fffffff;  // the image's
  EXPECT_THAT(complaint(file), HasSubstr("bufferView 3: bytes 2147483647.."));
  for (const Json& wrong : {Json(-4), Json(4294967296), Json(0.5), Json("0"), Json(nullptr), Json(1e300)}) {
    file = square();
    file.view("TEXCOORD_0")["byteOffset"] = wrong;
    EXPECT_THAT(complaint(file),
                HasSubstr("/bufferViews/1/byteOffset: a whole number from 0 to 2^31 - 1 is due"));
  }
}

TEST(SceneLoad, LyingAccessors) {
  const auto with = [](const char* property, const Json& value) {
    GltfFile file = square();
    file.accessor("TEXCOORD_0")[property] = value;
    return complaint(file);
  };
  EXPECT_THAT(with("count", 5),
              HasSubstr("mesh 0 primitive 0 TEXCOORD_0: accessor 1: bytes 0..40 of bufferView 1, "
                        "which has 32; truncated file?"));
  EXPECT_THAT(with("count", 3), HasSubstr("3 elements for 4 vertices"));
  EXPECT_THAT(with("count", 0), HasSubstr("no elements"));
  EXPECT_THAT(with("count", 2147483647), HasSubstr("more than 2^26"));
  EXPECT_THAT(with("count", 1 << 26), HasSubstr("truncated file?"));
  EXPECT_THAT(with("byteOffset", 4), HasSubstr("bytes 4..36 of bufferView 1"));
  EXPECT_THAT(with("byteOffset", 2147483647), HasSubstr("truncated file?"));
  EXPECT_THAT(with("bufferView", 99), HasSubstr("/accessors/1/bufferView: 99 is due to be an index"));
  EXPECT_THAT(with("componentType", 5125), HasSubstr("component type 5125 is not allowed"));
  EXPECT_THAT(with("componentType", 5130), HasSubstr("component type 5130"));
  EXPECT_THAT(with("componentType", 77), HasSubstr("tinygltf"));
  EXPECT_THAT(with("type", "VEC3"), HasSubstr("elements of 2 component(s) are due"));
  EXPECT_THAT(with("type", "MAT4"), HasSubstr("elements of 2 component(s) are due"));
  EXPECT_THAT(with("type", "VEC9"), HasSubstr("tinygltf"));
  EXPECT_THAT(with("normalized", 1), HasSubstr("true or false is due"));
  for (const int stride : {4, 12, 252}) {
    GltfFile file = square();
    file.view("TEXCOORD_0")["byteStride"] = stride;
    EXPECT_THAT(complaint(file),
                HasSubstr(stride == 4 ? "less than an element's 8 bytes" : "truncated file?"));
  }
  GltfFile file = square();
  file.accessor("POSITION").erase("bufferView");
  file.accessor("POSITION")["count"] = 1 << 23;
  EXPECT_THAT(complaint(file), HasSubstr("8388608 elements that no bufferView holds; more than 2^22"));
  // Nor of several together.
  file.accessor("POSITION")["count"] = 1 << 20;
  Json bare = file.primitive();
  bare["attributes"].erase("TEXCOORD_0");
  bare.erase("indices");
  file.json["meshes"][0]["primitives"] = Json(5, bare);
  EXPECT_THAT(complaint(file),
              HasSubstr("primitive 4: more than 2^22 elements in all that no bufferView holds"));
}

TEST(SceneLoad, BadNumbersAndIndices) {
  for (const float wrong :
       {std::nanf(""), std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()})
    for (const char* attribute : {"TEXCOORD_0", "POSITION"}) {
      GltfFile file = square();
      std::memcpy(file.bytes.data() + file.view(attribute)["byteOffset"].get<std::size_t>() + 12, &wrong, 4);
      EXPECT_THAT(complaint(file), testing::AllOf(HasSubstr(attribute), HasSubstr("not finite")));
    }
  GltfFile file = square();
  file.primitive()["indices"] = file.add_accessor<std::uint8_t>({0, 1, 4}, 5121, "SCALAR", 1);
  file.set_buffer_length();
  EXPECT_THAT(complaint(file), HasSubstr("mesh 0 primitive 0: index 2 is 4, of 4 vertices"));
  file.primitive()["indices"] = file.add_accessor<std::uint32_t>({0, 1, 0xffffffff}, 5125, "SCALAR", 1);
  file.set_buffer_length();
  EXPECT_THAT(complaint(file), HasSubstr("primitive restart"));
  file.primitive()["indices"] = file.add_accessor<float>({0, 1, 2}, 5126, "SCALAR", 1);
  file.set_buffer_length();
  EXPECT_THAT(complaint(file), HasSubstr("unsigned integers are due"));
  file.primitive()["indices"] = 55;
  EXPECT_THAT(complaint(file),
              HasSubstr("/meshes/0/primitives/0/indices: 55 is due to be an index into accessors"));
  file = square();
  file.primitive()["material"] = -1;
  EXPECT_THAT(complaint(file), HasSubstr("/meshes/0/primitives/0/material"));
  file = square();
  file.primitive()["mode"] = 7;
  EXPECT_THAT(complaint(file), HasSubstr("mode 7"));
  file = square();
  file.json["textures"][0]["source"] = 1;
  EXPECT_THAT(complaint(file), HasSubstr("/textures/0/source"));
  file = square();
  file.base_color()["baseColorTexture"]["index"] = 4294967296;  // 0, had one but 32 bits
  EXPECT_THAT(complaint(file),
              HasSubstr("/materials/0/pbrMetallicRoughness/baseColorTexture/index: 4294967296"));
  file = square();
  file.json["meshes"][0]["primitives"] = 3;
  EXPECT_THAT(complaint(file), HasSubstr("/meshes/0/primitives: an array is due"));
}

TEST(SceneLoad, NodesThatAreNoTrees) {
  GltfFile file = square();
  file.json["nodes"][0]["children"] = {0};
  EXPECT_THAT(complaint(file), HasSubstr("node 0: its ancestors form a circle"));
  file.json["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}, {"mesh", 0}}};
  EXPECT_THAT(complaint(file), HasSubstr("node 1: a child of node 0 and of node 2"));
  file.json["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"children", {1}}}};
  EXPECT_THAT(complaint(file), HasSubstr("node 1: its ancestors form a circle"));
  file.json["nodes"][1]["children"] = {7};
  EXPECT_THAT(complaint(file), HasSubstr("/nodes/1/children/0: 7 is due to be an index into nodes"));
  // A long chain is a tree.
  Json nodes = Json::array();
  for (int k = 1; k < 20000; ++k) nodes.push_back({{"children", {k}}});
  nodes.push_back({{"mesh", 0}});
  file.json["nodes"] = nodes;
  EXPECT_EQ(load_glb(file).meshes[0].uses, 1u);
}

TEST(SceneLoad, CompressedGeometry) {
  GltfFile file = square();
  Json& draco = file.primitive()["extensions"]["KHR_draco_mesh_compression"];
  draco = {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  expect_square(load_glb(file));  // not required, and there is the uncompressed form
  file.accessor("POSITION").erase("bufferView");
  EXPECT_THAT(complaint(file), HasSubstr("mesh 0 primitive 0: Draco-compressed"));
  for (const char* extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    file.json["extensionsRequired"] = {extension};
    EXPECT_THAT(complaint(file), testing::AllOf(HasSubstr(extension), HasSubstr("compressed")));
  }
  file.json["extensionsRequired"] = {"ACME_triangles"};
  EXPECT_THAT(complaint(file), HasSubstr("extensionsRequired: ACME_triangles is not read here"));
}

/// A line of the table in the folder's README.
struct RealScene {
  const char* file;
  TriangleCounts all, masked;
  std::size_t mask_materials, alpha_textures;

  friend void PrintTo(const RealScene& s, std::ostream* out) { *out << s.file; }
};

class RealScenes : public testing::TestWithParam<RealScene> {};

TEST_P(RealScenes, ReadAsTheirTableSays) {
  const RealScene& due = GetParam();
  const std::string file = std::string(MMVERIFY_SCENES "/") + due.file;
  if (!fs::exists(file)) GTEST_SKIP() << "there is no " << file;
  const Scene scene = load(file);
  TriangleCounts masked;
  std::set<std::size_t> textures;
  for (const Primitive& primitive : scene.primitives) {
    const Material& material = scene.material_of(primitive);
    if (material.mode != AlphaMode::mask) continue;
    masked.unique += primitive.triangles.size();
    masked.placed += primitive.triangles.size() * scene.meshes[primitive.mesh].uses;
    textures.insert(material.texture.value().image.value());
  }
  EXPECT_EQ(count_triangles(scene).unique, due.all.unique);
  EXPECT_EQ(count_triangles(scene).placed, due.all.placed);
  EXPECT_EQ(masked.unique, due.masked.unique);
  EXPECT_EQ(masked.placed, due.masked.placed);
  EXPECT_EQ(textures.size(), due.alpha_textures);
  EXPECT_EQ(std::count_if(scene.materials.begin(), scene.materials.end(),
                          [](const Material& material) { return material.mode == AlphaMode::mask; }),
            static_cast<std::ptrdiff_t>(due.mask_materials));
  for (const std::size_t texture : textures) EXPECT_TRUE(scene.images[texture].decoded());
}

INSTANTIATE_TEST_SUITE_P(
    SceneLoad, RealScenes,
    testing::Values(RealScene{"avocado/Avocado.gltf", {682, 682}, {}, 0, 0},
                    RealScene{"materials_variants_shoe/MaterialsVariantsShoe.gltf", {22700, 22700}, {}, 0, 0},
                    RealScene{"flight_helmet/FlightHelmet_noleather.gltf", {94722, 94722}, {}, 0, 0},
                    RealScene{"littlest_tokyo/littlest_tokyo.gltf", {141802, 141802}, {6741, 6741}, 3, 1},
                    RealScene{"lattice_fence/lattice_fence.gltf", {892, 8336}, {878, 7902}, 1, 1},
                    RealScene{
                        "shapespark_garden/shapespark_garden.gltf", {7667, 15070}, {5398, 10534}, 21, 21},
                    RealScene{"scatter_grove/scatter_grove.gltf", {8420, 149970}, {4138, 78020}, 5, 5},
                    RealScene{"ez_forest/ez_forest.gltf", {59640, 630910}, {30032, 304160}, 5, 3}),
    [](const auto& info) { return fs::path(info.param.file).stem().string(); });

TEST(SceneLoad, TheTwoBadScenes) {
  const std::string folder = MMVERIFY_SCENES "/";
  const std::string helmet = folder + "flight_helmet/FlightHelmet.gltf";
  const std::string tokyo = folder + "littlest_tokyo/LittlestTokyo_original_draco.glb";
  if (!fs::exists(helmet) || !fs::exists(tokyo))
    GTEST_SKIP() << "there is no " << helmet << " or no " << tokyo;
  const auto message = [](const std::string& file) -> std::string {
    try {
      load(file);
    } catch (const BadScene& bad) {
      return bad.what();
    }
    return "loaded";
  };
  EXPECT_EQ(message(helmet),
            helmet +
                ": images: there are no files 'FlightHelmet_Materials_LeatherPartsMat_Normal.png', "
                "'FlightHelmet_Materials_LeatherPartsMat_OcclusionRoughMetal.png', "
                "'FlightHelmet_Materials_LeatherPartsMat_BaseColor.png' beside it; is the folder complete?");
  EXPECT_EQ(message(tokyo),
            tokyo +
                ": extensionsRequired: KHR_draco_mesh_compression is not read here: the geometry is "
                "compressed; decompress it first (gltf-transform copy)");
}

}  // namespace
