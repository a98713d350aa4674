// scene/: the GLB that is written says what its source said, and the micromaps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/validate/micromaps.hpp"
#include "scene/write/container.hpp"
#include "scene/write/glb.hpp"
#include "tests/complaint.hpp"
#include "tests/folder.hpp"
#include "tests/scene/gltf_file.hpp"

namespace {

using namespace mmverify::scene;
using namespace mmverify::tests;
using mmverify::impl::micromap::Array;
using mmverify::impl::micromap::Encoding;
using testing::ElementsAre;
using testing::HasSubstr;

const char* const written_name = "EXT_mesh_opacity_micromap";

/// Records of levels 1 and 2.
const Array& array() {
  static const Array some{{{0, 2, 2}, {4, 1, 1}, {5, 2, 2}},
                          {0xe4, 0x1b, 0, 1, 0x05, 0xff, 0xff, 0xff, 0xfd}};
  return some;
}

/// Indices for the first primitive, one 16-bit code a triangle.
struct Chosen {
  std::vector<std::uint16_t> codes;
  std::vector<unsigned char> bytes = as_bytes(bytes_of(codes));
  PrimitiveMicromaps primitive{0, 0, 0, Encoding::u16, bytes, 0};
  Micromaps micromaps{std::span(&array(), 1), std::span(&primitive, 1)};
};

Bytes written(const GltfFile& file, const Micromaps& micromaps = {}) {
  return to_glb("leaf.glb", as_bytes(file.glb()), micromaps);
}

std::string view_of(const GltfFile& file, std::size_t number) {
  const Json& view = file.json["bufferViews"].at(number);
  return file.bytes.substr(view.value("byteOffset", std::size_t{0}), view["byteLength"].get<std::size_t>());
}

std::string text(std::span<const unsigned char> bytes) { return {bytes.begin(), bytes.end()}; }

void expect_clean(const Bytes& glb) {
  for (const FileViolation& violation : validate_micromaps("written.glb", glb))
    ADD_FAILURE() << describe(violation);
}

/// All that a scene says of triangles and alpha.
void expect_same(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.primitives.size(), b.primitives.size());
  for (std::size_t k = 0; k < a.primitives.size(); ++k) {
    EXPECT_EQ(a.primitives[k].triangles, b.primitives[k].triangles);
    EXPECT_EQ(a.primitives[k].positions, b.primitives[k].positions);
    EXPECT_EQ(a.primitives[k].uvs, b.primitives[k].uvs);
    EXPECT_EQ(a.primitives[k].material, b.primitives[k].material);
  }
  ASSERT_EQ(a.images.size(), b.images.size());
  for (std::size_t k = 0; k < a.images.size(); ++k) {
    EXPECT_EQ(a.images[k].width, b.images[k].width);
    EXPECT_EQ(a.images[k].alpha, b.images[k].alpha);
  }
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (std::size_t k = 0; k < a.meshes.size(); ++k) EXPECT_EQ(a.meshes[k].uses, b.meshes[k].uses);
}

TEST(SceneWrite, TheContainer) {
  GltfFile file = square();
  for (std::size_t more = 0; more < 4; ++more) {
    file.json["asset"]["generator"] = std::string(more, 'x');
    file.bytes += "!";
    file.set_buffer_length();
    const Bytes glb = written(file);
    const auto word = [&](std::size_t at) {
      return glb.at(at) | glb.at(at + 1) << 8 | glb.at(at + 2) << 16 | glb.at(at + 3) << 24;
    };
    EXPECT_EQ(text(std::span(glb).first(4)), "glTF");
    EXPECT_EQ(word(4), 2);
    EXPECT_EQ(word(8), static_cast<int>(glb.size()));
    const auto json = static_cast<std::size_t>(word(12));
    EXPECT_EQ(json % 4, 0u);
    EXPECT_EQ(text(std::span(glb).subspan(16, 4)), "JSON");
    const auto binary = static_cast<std::size_t>(word(20 + json));
    EXPECT_EQ(binary % 4, 0u);
    EXPECT_EQ(text(std::span(glb).subspan(24 + json, 4)), std::string("BIN\0", 4));
    EXPECT_EQ(glb.size(), 28 + json + binary);
    const GltfFile parts = taken_apart(glb);
    const auto due = parts.json["buffers"][0]["byteLength"].get<std::size_t>();
    EXPECT_EQ(due, file.bytes.size());
    EXPECT_EQ(parts.bytes.substr(due), std::string(binary - due, '\0'));
    const auto end = text(std::span(glb).subspan(20, json)).find_last_not_of(' ');
    EXPECT_GE(end + 4, json);
    EXPECT_EQ(glb, written(file));
  }
}

TEST(SceneWrite, LessThan2To32Bytes) {
  EXPECT_EQ(glb_size(1, 0), 24u);
  EXPECT_EQ(glb_size(4, 1), 36u);
  // 12 + 8 + 100 + 8 + binary, a multiple of four, in 32 bits.
  EXPECT_EQ(glb_size(100, 4294967164), 4294967292u);
  EXPECT_THROW(glb_size(100, 4294967165), std::length_error);
  EXPECT_THROW(glb_size(4294967295, 0), std::length_error);
  EXPECT_THROW(glb_size(~std::uint64_t{0}, ~std::uint64_t{0}), std::length_error);
  EXPECT_THROW(glb_size(4, ~std::uint64_t{0} - 2), std::length_error);
}

TEST(SceneWrite, AllElseStays) {
  GltfFile file = square();
  Json& json = file.json;
  const Json unknown = {{"ACME_things", {{"numbers", {1, 2.5, -3e-7, 16777217, 1e300}}, {"text", "grün\n"}}}};
  json["extensions"] = unknown;
  json["extensionsUsed"] = {"ACME_things", "KHR_texture_transform"};
  json["extras"] = {{"deep", {{"deeper", nullptr}}}};
  json["nodes"][0]["extras"] = true;
  json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0.2, 0.3, 1};
  json["materials"][0]["extensions"] = unknown;
  file.base_color()["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {{"scale", {3, 0.1}}};
  file.primitive()["extensions"] = unknown;
  file.primitive()["extras"] = 7;
  json["buffers"][0]["name"] = "bytes";
  json["buffers"][0]["extras"] = "kept";
  json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1.5}, {"znear", 0.01}}}}};
  Chosen chosen{{2, 65534}};
  const Bytes glb = written(file, chosen.micromaps);
  expect_clean(glb);
  GltfFile parts = taken_apart(glb);
  EXPECT_EQ(parts.json["extensionsUsed"], (Json{"ACME_things", "KHR_texture_transform", written_name}));
  parts.json["extensionsUsed"].erase(2);
  parts.json["extensions"].erase(written_name);
  parts.primitive()["extensions"].erase(written_name);
  EXPECT_EQ(parts.json["accessors"].size(), json["accessors"].size() + 1);
  parts.json["accessors"].erase(json["accessors"].size());
  for (std::size_t k = 0; k < 3; ++k) parts.json["bufferViews"].erase(json["bufferViews"].size());
  parts.json["buffers"][0]["byteLength"] = json["buffers"][0]["byteLength"];
  EXPECT_EQ(parts.json, json);
  EXPECT_TRUE(parts.bytes.starts_with(file.bytes));
  expect_same(load("a.glb", glb), load("b.glb", as_bytes(file.glb())));
}

TEST(SceneWrite, TheMicromaps) {
  const Array other{{{0, 0, 2}}, {3}};
  const Array arrays[] = {array(), other};
  GltfFile file = square();
  file.json["meshes"].push_back(file.json["meshes"][0]);
  file.add("nodes", {{"mesh", 1}});
  const std::vector<unsigned char> words = as_bytes(bytes_of<std::int32_t>({0, -3}));
  const std::vector<unsigned char> bytes{1, 0xfe};
  const PrimitiveMicromaps primitives[] = {{1, 0, 0, Encoding::u8, bytes, 1},
                                           {0, 0, 1, Encoding::i32, words, 0}};
  const Bytes glb = written(file, {arrays, primitives});
  expect_clean(glb);
  const GltfFile parts = taken_apart(glb);
  const Json& micromaps = parts.json["extensions"][written_name]["micromaps"];
  ASSERT_EQ(micromaps.size(), 2u);
  // Counts are sorted by level, then format.
  EXPECT_EQ(micromaps[0]["usageCounts"], (Json{1, 2}));
  EXPECT_EQ(micromaps[0]["usageLevels"], (Json{1, 2}));
  EXPECT_EQ(micromaps[0]["usageFormats"], (Json{1, 2}));
  EXPECT_EQ(view_of(parts, micromaps[0]["data"]), text(array().data));
  EXPECT_EQ(view_of(parts, micromaps[0]["triangles"]), std::string("\0\0\0\0\2\0\2\0"
                                                                   "\4\0\0\0\1\0\1\0"
                                                                   "\5\0\0\0\2\0\2\0",
                                                                   24));
  EXPECT_EQ(view_of(parts, micromaps[1]["data"]), "\3");
  const auto of_primitive = [&](std::size_t mesh) {
    return parts.json["meshes"][mesh]["primitives"][0]["extensions"][written_name];
  };
  EXPECT_EQ(of_primitive(0)["micromap"], 1);
  EXPECT_EQ(of_primitive(1)["micromap"], 0);
  EXPECT_FALSE(of_primitive(0).contains("micromapBaseTriangle"));
  EXPECT_EQ(of_primitive(1)["micromapBaseTriangle"], 1);
  const auto accessor_of = [&](std::size_t mesh) {
    return parts.json["accessors"][of_primitive(mesh)["micromapIndices"].get<std::size_t>()];
  };
  EXPECT_EQ(accessor_of(0)["componentType"], 5124);
  EXPECT_EQ(accessor_of(1)["componentType"], 5121);
  EXPECT_EQ(accessor_of(1)["count"], 2);
  EXPECT_EQ(accessor_of(1)["type"], "SCALAR");
  EXPECT_EQ(view_of(parts, accessor_of(1)["bufferView"]), "\x01\xfe");
  EXPECT_EQ(view_of(parts, accessor_of(0)["bufferView"]), text(words));
  for (const Json& view : parts.json["bufferViews"]) EXPECT_EQ(view.value("byteOffset", 0) % 4, 0);
}

// The unsigned and 16-bit signed codes have component types of their own, too.
TEST(SceneWrite, EachEncoding) {
  const std::pair<Encoding, int> types[] = {{Encoding::u8, 5121},
                                            {Encoding::u16, 5123},
                                            {Encoding::u32, 5125},
                                            {Encoding::i16, 5122},
                                            {Encoding::i32, 5124}};
  for (const auto& [encoding, type] : types) {
    const std::vector<unsigned char> indices(2 * (mmverify::impl::micromap::width(encoding) / 8), 0xff);
    const PrimitiveMicromaps primitive{0, 0, 0, encoding, indices, 0};
    const Bytes glb = written(square(), {std::span(&array(), 1), std::span(&primitive, 1)});
    expect_clean(glb);
    EXPECT_EQ(taken_apart(glb).json["accessors"].back()["componentType"], type);
  }
}

TEST(SceneWrite, WithoutMicromaps) {
  const Bytes glb = written(square());
  EXPECT_FALSE(taken_apart(glb).json.contains("extensionsUsed"));
  EXPECT_FALSE(taken_apart(glb).json.contains("extensions"));
  // No bytes, no chunk for them.
  const Bytes bare = to_glb("bare.gltf", as_bytes(R"({"asset": {"version": "2.0"}})"), {});
  EXPECT_EQ(bare.size(), 20 + 28u);  // {"asset":{"version":"2.0"}} is 27
  EXPECT_TRUE(load("bare.glb", bare).primitives.empty());
}

TEST(SceneWrite, AnArrayOfSpecialIndicesAlone) {
  const Array none;
  const std::vector<unsigned char> codes(2, 0xff);
  const PrimitiveMicromaps primitive{0, 0, 0, Encoding::u8, codes, 0};
  const Bytes glb = written(square(), {std::span(&none, 1), std::span(&primitive, 1)});
  expect_clean(glb);
  EXPECT_EQ(taken_apart(glb).json["extensions"][written_name]["micromaps"][0]["usageCounts"], Json{1});
}

TEST(SceneWrite, OldMicromapsAreReplaced) {
  Chosen first{{0, 1}}, second{{65533, 2}};
  GltfFile old = taken_apart(written(square(), first.micromaps));
  old.json["extensionsRequired"] = {written_name};
  const Bytes glb = to_glb("old.glb", as_bytes(old.glb()), second.micromaps);
  expect_clean(glb);
  const GltfFile parts = taken_apart(glb);
  EXPECT_EQ(parts.json["extensionsUsed"], Json{written_name});
  EXPECT_FALSE(parts.json.contains("extensionsRequired"));
  EXPECT_EQ(parts.json["extensions"][written_name]["micromaps"].size(), 1u);
  const Bytes without = to_glb("old.glb", as_bytes(old.glb()), {});
  EXPECT_FALSE(taken_apart(without).json.contains("extensions"));
  EXPECT_FALSE(taken_apart(without).primitive().contains("extensions"));
}

TEST(SceneWrite, BytesOfOldMicromaps) {
  const Folder folder;
  const std::string path = (folder / "old.glb").string();
  const auto bytes_in = [&](const GltfFile& file) {
    GltfFile::write(path, file.glb());
    return old_micromap_bytes(path);
  };
  EXPECT_EQ(bytes_in(square()), 0u);
  Chosen chosen{{0, 1}};
  GltfFile old = taken_apart(written(square(), chosen.micromaps));
  const auto length = [&](const Json& view) {
    return old.json["bufferViews"][view.get<std::size_t>()]["byteLength"].get<std::size_t>();
  };
  const Json& micromap = old.json["extensions"][written_name]["micromaps"][0];
  const Json& indices =
      old.json["accessors"]
              [old.primitive()["extensions"][written_name]["micromapIndices"].get<std::size_t>()];
  const std::size_t maps = length(micromap["data"]) + length(micromap["triangles"]);
  EXPECT_EQ(bytes_in(old), maps + length(indices["bufferView"]));
  const Json shared = indices;
  old.add("accessors", shared);
  EXPECT_EQ(bytes_in(old), maps) << "another accessor reads the view of the indices, too";
}

const std::string webp = "RIFF....WEBPVP8 .", ktx2 = "\xabKTX 20\xbb\r\n\x1a\n.";

/// A square whose buffers and images lie in files of the folder and in data URIs; leaf.gltf is the file itself.
GltfFile square_from_everywhere(const Folder& folder, const std::string& uvs) {
  GltfFile file = square();
  // The UVs in a buffer of their own, of an odd size, in a data URI; the rest in a file.
  file.json["buffers"][0]["uri"] = "leaf.bin";
  file.json["buffers"].push_back(
      {{"byteLength", uvs.size() + 7},
       {"uri", "data:application/octet-stream;base64," + base64("abcd" + uvs + "xyz")}});
  file.view("TEXCOORD_0") = {{"buffer", 1}, {"byteOffset", 4}, {"byteLength", uvs.size()}};
  // No code, in a view that nothing reads.
  const Json code = {{"buffer", 1}, {"byteOffset", 1}, {"byteLength", 3}, {"byteStride", 4}, {"count", 1}};
  file.add("bufferViews",
           {{"buffer", 0}, {"byteLength", 4}, {"extensions", {{"EXT_meshopt_compression", code}}}});
  file.json["images"] = {{{"uri", "leaf%201.png"}},
                         {{"uri", "data:image/jpeg;base64," + base64("\xff\xd8\xff\xe0!")}},
                         {{"uri", "photo.jpg"}, {"name", "photo"}, {"extras", 5}},
                         {{"uri", "w"}},
                         {{"uri", "k"}, {"mimeType", "image/png"}},  // no PNG
                         {{"uri", "strange"}, {"mimeType", "image/strange"}},
                         {{"uri", "data:image/gif;base64," + base64("GIF89a")}}};
  GltfFile::write(folder / "leaf.bin", file.bytes);
  GltfFile::write(folder / "leaf 1.png", small_png());
  GltfFile::write(folder / "photo.jpg", "\xff\xd8\xff\xe1?");
  GltfFile::write(folder / "w", webp);
  GltfFile::write(folder / "k", ktx2);
  GltfFile::write(folder / "strange", "?");
  GltfFile::write(folder / "leaf.gltf", file.json.dump());
  return file;
}

TEST(SceneWrite, BuffersAndImagesFromEverywhere) {
  const Folder folder;
  GltfFile whole = square();
  const std::string uvs = view_of(whole, whole.accessor("TEXCOORD_0")["bufferView"]);
  GltfFile file = square_from_everywhere(folder, uvs);
  Chosen chosen{{0, 65535}};
  const Bytes glb = to_glb(folder / "leaf.gltf", chosen.micromaps);
  expect_clean(glb);
  expect_same(load("written.glb", glb), load(folder / "leaf.gltf"));
  const GltfFile parts = taken_apart(glb);
  ASSERT_EQ(parts.json["buffers"].size(), 1u);
  EXPECT_FALSE(parts.json["buffers"][0].contains("uri"));
  EXPECT_EQ(view_of(parts, 1), uvs);
  const Json& compressed =
      parts.json["bufferViews"][file.json["bufferViews"].size() - 1]["extensions"]["EXT_meshopt_compression"];
  EXPECT_EQ(compressed["buffer"], 0);
  EXPECT_EQ(parts.bytes.substr(compressed["byteOffset"].get<std::size_t>(), 3), ("abcd" + uvs).substr(1, 3));
  const std::pair<std::string, const char*> due[] = {{small_png(), "image/png"},
                                                     {"\xff\xd8\xff\xe0!", "image/jpeg"},
                                                     {"\xff\xd8\xff\xe1?", "image/jpeg"},
                                                     {webp, "image/webp"},
                                                     {ktx2, "image/ktx2"},
                                                     {"?", "image/strange"},
                                                     {"GIF89a", "image/gif"}};
  for (std::size_t k = 0; k < std::size(due); ++k) {
    const Json& image = parts.json["images"][k];
    EXPECT_FALSE(image.contains("uri"));
    EXPECT_EQ(image["mimeType"], due[k].second);
    EXPECT_EQ(view_of(parts, image["bufferView"]), due[k].first);
  }
  EXPECT_EQ(parts.json["images"][0]["name"], "leaf%201.png");
  EXPECT_FALSE(parts.json["images"][1].contains("name"));
  EXPECT_EQ(parts.json["images"][2]["name"], "photo");
  EXPECT_EQ(parts.json["images"][2]["extras"], 5);

  file.json["images"][5].erase("mimeType");
  GltfFile::write(folder / "leaf.gltf", file.json.dump());
  EXPECT_THAT(complaint_of<BadScene>([&] { to_glb(folder / "leaf.gltf", {}); }),
              HasSubstr("leaf.gltf: image 5 (strange): of no known type"));
}

TEST(SceneWrite, StripsAndFansBecomeLists) {
  for (const int mode : {5, 6})
    for (const bool indexed : {false, true}) {
      GltfFile file = square();
      file.primitive()["mode"] = mode;
      if (!indexed) file.primitive().erase("indices");
      file.json["meshes"][0]["primitives"].push_back(file.primitive());  // of no micromap
      const Scene source = load("source.glb", as_bytes(file.glb()));
      Chosen chosen{std::vector<std::uint16_t>(source.primitives[0].triangles.size(), 1)};
      const Bytes glb = written(file, chosen.micromaps);
      expect_clean(glb);
      expect_same(load("written.glb", glb), source);
      const GltfFile parts = taken_apart(glb);
      const Json& primitives = parts.json["meshes"][0]["primitives"];
      EXPECT_EQ(primitives[0]["mode"], 4);
      EXPECT_EQ(primitives[1]["mode"], mode);
      EXPECT_EQ(primitives[1].contains("indices"), indexed);
      const Json& accessor = parts.json["accessors"][primitives[0]["indices"].get<std::size_t>()];
      EXPECT_EQ(accessor["componentType"], 5123);
      EXPECT_EQ(accessor["count"], 3 * source.primitives[0].triangles.size());
      EXPECT_EQ(parts.json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["target"], 34963);
    }
}

// 65,535 is no index of 16 bits: it restarts a primitive.
TEST(SceneWrite, IndicesOfALongStrip) {
  for (const std::size_t vertices : {65535u, 65536u}) {
    GltfFile file;
    file.add_accessor(std::vector<float>(3 * vertices, 1.0f), 5126, "VEC3", 3);
    file.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"mode", 5}}}}});
    file.add("buffers", {{"byteLength", file.bytes.size()}});
    const PrimitiveMicromaps primitive{0, 0, 0, Encoding::u8, {}, 0};
    const Bytes glb = written(file, {std::span(&array(), 1), std::span(&primitive, 1)});
    EXPECT_EQ(taken_apart(glb).json["accessors"].back()["componentType"], vertices == 65535 ? 5123 : 5125);
    EXPECT_EQ(load("long.glb", glb).primitives[0].triangles.back(),
              vertices == 65535 ? (Triangle{65532, 65533, 65534}) : (Triangle{65533, 65535, 65534}));
  }
}

TEST(SceneWrite, MicromapsThatDoNotFit) {
  const auto complaint = [](GltfFile file, const PrimitiveMicromaps& primitive, std::size_t times = 1) {
    const std::vector<PrimitiveMicromaps> all(times, primitive);
    return complaint_of<std::invalid_argument>([&] { written(file, {std::span(&array(), 1), all}); });
  };
  const std::vector<unsigned char> two{0, 1}, three{0, 1, 2};
  const PrimitiveMicromaps fits{0, 0, 0, Encoding::u8, two, 0};
  EXPECT_EQ(complaint(square(), fits), "none");
  EXPECT_EQ(complaint(square(), fits, 2), "to_glb: meshes[0].primitives[0]: comes twice");
  EXPECT_THAT(complaint(square(), {1, 0, 0, Encoding::u8, two, 0}),
              HasSubstr("meshes[1].primitives[0]: is not there"));
  EXPECT_THAT(complaint(square(), {0, 1, 0, Encoding::u8, two, 0}), HasSubstr("is not there"));
  EXPECT_THAT(complaint(square(), {0, 0, 1, Encoding::u8, two, 0}), HasSubstr("its array is not there"));
  EXPECT_THAT(complaint(square(), {0, 0, 0, Encoding::u8, three, 0}),
              HasSubstr("3 bytes of indices for 2 triangles"));
  EXPECT_THAT(complaint(square(), {0, 0, 0, Encoding::u16, two, 0}),
              HasSubstr("2 bytes of indices for 2 triangles"));
  GltfFile lines = square();
  lines.primitive()["mode"] = 1;
  EXPECT_THAT(complaint(lines, fits), HasSubstr("draws no triangles"));
  lines.primitive()["mode"] = 4;
  lines.primitive()["attributes"].erase("POSITION");
  EXPECT_THAT(complaint(lines, fits), HasSubstr("has no triangles"));
}

TEST(SceneWrite, ViewsBeyondTheirBuffers) {
  GltfFile file = square();
  file.json["buffers"].push_back(
      {{"byteLength", 4}, {"uri", "data:application/octet-stream;base64,AAAAAA=="}});
  // The view would reach into the next buffer if the buffers were one.
  file.json["bufferViews"][2]["byteLength"] = 400;
  EXPECT_THAT(complaint_of<BadScene>([&] { written(file); }), HasSubstr("bufferView 2: bytes 80..480 of a"));
}

TEST(SceneWrite, InMemoryThereIsNoFolder) {
  GltfFile file = square();
  file.json["images"][0] = {{"uri", "leaf.png"}};
  for (const bool write : {false, true}) try {
      write ? (void)written(file) : (void)load("leaf.glb", as_bytes(file.glb()));
      ADD_FAILURE() << "read";
    } catch (const BadScene& bad) {
      EXPECT_THAT(bad.what(), HasSubstr("a scene in memory has no files beside it"));
    }
  EXPECT_THROW(load("nothing.glb", {}), BadScene);
}

TEST(SceneWrite, RealScenes) {
  const fs::path scenes = MMVERIFY_SCENES;
  if (!fs::exists(scenes)) GTEST_SKIP() << "no scenes in " << scenes;
  for (const char* file : {"lattice_fence/lattice_fence.gltf", "scatter_grove/scatter_grove.gltf"}) {
    const Scene source = load(scenes / file);
    std::vector<std::vector<unsigned char>> codes;
    std::vector<PrimitiveMicromaps> primitives;
    codes.reserve(source.primitives.size());
    for (const Primitive& primitive : source.primitives) {
      if (primitive.triangles.empty()) continue;
      codes.emplace_back(primitive.triangles.size(), 0xff);
      for (std::size_t t = 0; t < codes.back().size(); t += 3) codes.back()[t] = t % 2 == 0 ? 1 : 2;
      primitives.push_back({primitive.mesh, primitive.number, 0, Encoding::u8, codes.back(), 0});
    }
    const Bytes glb = to_glb(scenes / file, {std::span(&array(), 1), primitives});
    expect_clean(glb);
    expect_same(load(file, glb), source);
  }
}

}  // namespace
