// scene/: what is said of a glTF file that cannot be read.
#include <limits>

#include "tests/scene/loaded_scene.hpp"

namespace {

using namespace mmverify::scene;
using namespace mmverify::tests;
using testing::HasSubstr;

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

TEST(SceneLoad, OfSeveralFaultyImagesTheFirstIsNamed) {
  GltfFile file = square();
  for (int k = 1; k <= 3; ++k) {
    file.json["images"].push_back({{"uri", "data:image/png;base64,AAAA"}});
    file.json["textures"].push_back({{"source", k}});
    Json material = file.json["materials"][0], primitive = file.json["meshes"][0]["primitives"][0];
    material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = k;
    primitive["material"] = k;
    file.json["materials"].push_back(material);
    file.json["meshes"][0]["primitives"].push_back(primitive);
  }
  EXPECT_THAT(complaint(file), HasSubstr("image 1"));
  // The bytes of image 3 are nowhere, which shows before any image is decoded.
  file.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 0x7fffffff}, {"byteLength", 4}});
  const std::size_t view = file.json["bufferViews"].size() - 1;
  file.json["images"][3] = {{"bufferView", view}, {"mimeType", "image/png"}};
  EXPECT_THAT(complaint(file), HasSubstr("image 1"));
  file.json["images"][1] = file.json["images"][2] = file.json["images"][0];
  EXPECT_THAT(complaint(file), HasSubstr("bufferView " + std::to_string(view)));
}

TEST(SceneLoad, LyingAccessors) {
  const auto with = [](const char* property, const Json& value) {
    GltfFile file = square();
    file.accessor("TEXCOORD_0")[property] = value;
    return complaint(file);
  };
  EXPECT_THAT(with("count", 5), HasSubstr("mesh 0 primitive 0 TEXCOORD_0: accessor 1: bytes 0..40 of "
                                          "bufferView 1, which has 32; truncated file?"));
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

}  // namespace
