// [sanitized] scene/: what is read of a glTF file.
#include <stb/stb_image_write.h>

#include "tests/complaint.hpp"
#include "tests/scene/loaded_scene.hpp"

namespace {

using namespace mmverify::scene;
using namespace mmverify::tests;
using testing::ElementsAre;
using testing::HasSubstr;

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
  EXPECT_EQ(alpha->of_vertices, (std::vector<float>{1, 0.2f, 1, 1}));
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
  const std::string palette =
      png(2, 1, 8, 3, {std::string("\1\0", 2)}, png_chunk("PLTE", "abcdef") + png_chunk("tRNS", "\x21"));
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
              HasSubstr("image 0 (leaf): no picture that is read here"));
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

// The decoder looks at no CRC, and takes what lies behind a palette for colours.
TEST(SceneLoad, DamagedImages) {
  const std::string good = small_png();
  EXPECT_NO_THROW(load_glb(with_image(good)));
  for (const char* type : {"IHDR", "IDAT", "IEND"}) {
    std::string damaged = good;
    // The fourth byte of the data; IEND has none: that one is of its CRC.
    damaged[good.find(type) + 7] ^= 1;
    EXPECT_THAT(complaint(with_image(damaged)), HasSubstr("another CRC than its bytes")) << type;
  }
  EXPECT_THAT(complaint(with_image(good.substr(0, good.find("IEND") - 4))),
              HasSubstr("before its IEND chunk"));
  // A damaged chunk that decides no texel is accepted: viewers show the picture.
  const std::string text = big_endian(1) + "tEXt!" + std::string(4, '\0');
  EXPECT_NO_THROW(load_glb(with_image(png(1, 1, 8, 2, {"abc"}, text))));
  // Transparency does decide.
  const std::string transparent = big_endian(6) + "tRNS" + std::string(6, '\0') + std::string(4, '\0');
  EXPECT_THAT(complaint(with_image(png(1, 1, 8, 2, {"abc"}, transparent))),
              HasSubstr("another CRC than its bytes"));

  const std::string two = png_chunk("PLTE", "abcdef");
  EXPECT_NO_THROW(load_glb(with_image(png(2, 1, 8, 3, {std::string("\1\0", 2)}, two))));
  EXPECT_THAT(complaint(with_image(png(2, 1, 8, 3, {std::string("\0\2", 2)}, two))),
              HasSubstr("beyond the end of the palette"));
  EXPECT_THAT(complaint(with_image(png(2, 1, 4, 3, {"\x13"}, two))),
              HasSubstr("beyond the end of the palette"));
  EXPECT_NO_THROW(load_glb(with_image(png(2, 1, 1, 3, {"\x40"}, two))));
}

// A file that is read may end up in a file that is written: it must lie in the scene's folder, as a sidecar's files do.
TEST(SceneLoad, FilesOutOfTheFolder) {
  const Folder outer;
  const fs::path folder = outer / "scene";
  fs::create_directory(folder);
  GltfFile::write(outer / "secret", square().bytes + small_png());
  GltfFile::write(outer / "secret.png", small_png());
  const auto says = [&](const char* kind, const std::string& uri) -> std::string {
    GltfFile file = square();
    file.set_buffer_length();
    if (std::string_view(kind) == "buffers")
      file.json["buffers"][0]["uri"] = uri;
    else
      file.json["images"][0] = {{"uri", uri}};
    const bool buffer = std::string_view(kind) == "buffers";
    const fs::path path = folder / (buffer ? "leaf.gltf" : "leaf.glb");
    GltfFile::write(path, buffer ? file.json.dump() : file.glb());
    return complaint_of<BadScene>([&] { load(path); }, "loaded");
  };
  for (const char* kind : {"buffers", "images"}) {
    const std::string name = kind == std::string_view("buffers") ? "secret" : "secret.png";
    for (const std::string& uri :
         std::vector<std::string>{"../" + name, "./../" + name, "a/../../" + name, "%2e%2e/" + name,
                                  "%2E%2E%2f" + name, (outer / name).string(), "..", "a/../.."})
      EXPECT_THAT(says(kind, uri), HasSubstr("is no relative path in the file's folder"))
          << kind << ' ' << uri;
    EXPECT_THAT(says(kind, "file://" + (outer / name).string()),
                HasSubstr("only files beside it and base64 data URIs are read"));
    // A link out of the folder, one to a folder outside, and one that stays.
    fs::create_symlink("../" + name, folder / ("link_" + name));
    EXPECT_THAT(says(kind, "link_" + name), HasSubstr("is a link out of the file's folder")) << kind;
    fs::remove(folder / "outside");
    fs::create_symlink(outer.path(), folder / "outside");
    EXPECT_THAT(says(kind, "outside/" + name), HasSubstr("is a link out of the file's folder")) << kind;
    fs::copy_file(outer / name, folder / name);
    fs::create_symlink(name, folder / ("own_" + name));
    EXPECT_EQ(says(kind, "own_" + name), "loaded") << kind;
    EXPECT_EQ(says(kind, "a/.././" + name), "loaded") << kind;
  }
  // The file itself may be a link to where all of it lies.
  GltfFile file = square();
  file.set_buffer_length();
  file.json["images"][0] = {{"uri", "secret.png"}};
  GltfFile::write(folder / "leaf.glb", file.glb());
  fs::create_directory(outer / "links");
  fs::create_symlink(folder / "leaf.glb", outer / "links/leaf.glb");
  fs::create_symlink(folder / "secret.png", outer / "links/secret.png");
  EXPECT_NO_THROW(load(outer / "links/leaf.glb"));
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
    EXPECT_THAT(complaint(file), HasSubstr("no relative path"));
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

}  // namespace
