// scene/: meshes that meshoptimizer and Draco have compressed.
#include <algorithm>
#include <cmath>

#ifdef MMVERIFY_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include "scene/read/buffers.hpp"
#include "scene/read/draco.hpp"
#include "scene/read/meshopt.hpp"
#include "scene/validate/stored_maps.hpp"
#include "scene/write/glb.hpp"
#include "tests/complaint.hpp"
#include "tests/scene/loaded_scene.hpp"
#include "tests/scene/micromap_breaches.hpp"

namespace scene_compressed_test {

using namespace mmverify::scene;
using namespace mmverify::tests;
using testing::HasSubstr;

/// A file of another tool: a leaf of two triangles with micromaps.
std::string made(const char* name) { return std::string(MMVERIFY_MADE_FILES) + "/" + name; }

/// The corners of a scene's triangles, in their order, as UVs.
std::vector<std::array<Uv, 3>> corners(const Scene& scene) {
  std::vector<std::array<Uv, 3>> all;
  for (const Primitive& primitive : scene.primitives)
    for (const Triangle& t : primitive.triangles)
      all.push_back({primitive.uvs.at(t[0]), primitive.uvs.at(t[1]), primitive.uvs.at(t[2])});
  return all;
}

/// Whether two triangles have the same corners from some corner on; tools quantize by 12 bits or more.
bool alike(const std::array<Uv, 3>& a, const std::array<Uv, 3>& b) {
  for (std::size_t turn = 0; turn < 3; ++turn) {
    float apart = 0;
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t axis = 0; axis < 2; ++axis)
        apart = std::max(apart, std::fabs(a[c][axis] - b[(c + turn) % 3][axis]));
    if (apart < 1.0f / 2048) return true;
  }
  return false;
}

// gltf-transform 4.5's own output: the same two triangles, turned and in any order.
TEST(SceneCompressed, FilesOfAnotherTool) {
  const Scene plain = load(made("leaf.glb"));
  for (const auto& [name, there] :
       {std::pair{"leaf_meshopt.glb", has_meshopt()}, std::pair{"leaf_draco.glb", has_draco()}}) {
    if (!there) {
      EXPECT_THAT(complaint_of<UnreadExtension>([&, file = made(name)] { load(file); }),
                  HasSubstr("this program was built without"));
      EXPECT_TRUE(validate_micromaps(made(name)).empty());
      continue;
    }
    const Scene scene = load(made(name));
    ASSERT_EQ(scene.primitives.size(), 1u);
    EXPECT_EQ(scene.primitives[0].triangles.size(), 2u);
    for (const auto& triangle : corners(plain))
      EXPECT_EQ(
          std::ranges::count_if(corners(scene), [&](const auto& other) { return alike(triangle, other); }), 1)
          << name;
    EXPECT_TRUE(validate_micromaps(made(name)).empty()) << name;
    EXPECT_EQ(stored_maps(made(name), scene).links.size(), 2u);
  }
}

// A file stays compressed when it is written again, with the same triangles.
TEST(SceneCompressed, WrittenAgainItIsTheSame) {
  for (const auto& [name, there] :
       {std::pair{"leaf_meshopt.glb", has_meshopt()}, std::pair{"leaf_draco.glb", has_draco()}}) {
    if (!there) continue;
    const std::vector<unsigned char> again = to_glb(made(name), {});
    const Scene scene = load("again.glb", again), before = load(made(name));
    EXPECT_EQ(corners(scene), corners(before)) << name;
    EXPECT_EQ(alpha8(scene.images[0]), alpha8(before.images[0]));
  }
}

// No view lies in a buffer that has no bytes.
TEST(SceneCompressed, AFallbackThatIsLeftOutStaysOne) {
  GltfFile parts = taken_apart(to_glb(made("leaf_meshopt.glb"), {}));
  ASSERT_EQ(parts.json["buffers"].size(), 2u);
  EXPECT_EQ(parts.json["buffers"][0]["byteLength"], parts.bytes.size());
  EXPECT_FALSE(parts.json["buffers"][0].contains("extensions"));
  EXPECT_EQ(parts.json["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"], true);
  // It may also name a file that nobody has copied.
  parts.json["buffers"][1]["uri"] = "leaf.fallback.bin";
  if (has_meshopt()) {
    EXPECT_EQ(corners(load_text(parts.glb(), "f.glb")), corners(load(made("leaf_meshopt.glb"))));
  }
  parts.json["buffers"][1].erase("extensions");
  EXPECT_THAT(complaint(parts.glb()), HasSubstr("there is no file 'leaf.fallback.bin'"));
}

TEST(SceneCompressed, DamagedDraco) {
  if (!has_draco()) GTEST_SKIP() << "built without Draco";
  const GltfFile whole = [] {
    const Bytes bytes = read_file(made("leaf_draco.glb"), "leaf", "");
    return taken_apart(bytes);
  }();
  const Json& draco = whole.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
  const Json& view = whole.json["bufferViews"][draco["bufferView"].get<std::size_t>()];
  const auto at = view["byteOffset"].get<std::size_t>(), size = view["byteLength"].get<std::size_t>();
  GltfFile file = whole;
  file.bytes[at] = 'X';
  EXPECT_THAT(complaint(file.glb()), HasSubstr("KHR_draco_mesh_compression: "));
  file = whole;
  file.json["accessors"][file.primitive()["attributes"]["TEXCOORD_0"].get<std::size_t>()]["count"] = 5;
  EXPECT_THAT(complaint(file.glb()), HasSubstr("has 5 elements, TEXCOORD_0 of the mesh 4"));
  file = whole;
  file.primitive()["mode"] = 5;
  EXPECT_THAT(complaint(file.glb()), HasSubstr("a strip is not read here"));
  file = whole;
  file.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 9;
  EXPECT_THAT(complaint(file.glb()), HasSubstr("the mesh has no attribute 9, POSITION"));
  // Whatever bytes there are: an error that names the place, or a scene.
  for (std::size_t k = 0; k < size; ++k) {
    file = whole;
    file.bytes[at + k] = static_cast<char>(file.bytes[at + k] ^ (1 << k % 8));
    try {
      load("f.glb", as_bytes(file.glb()));
    } catch (const BadScene& bad) {
      EXPECT_THAT(bad.what(), HasSubstr("f.glb: ")) << k;
    }
  }
}

#ifdef MMVERIFY_HAS_MESHOPT

/// The bytes of a view that are stored as `code`, decoded by the reader.
Bytes decoded(const std::string& code, const char* mode, const char* filter, std::size_t count,
              std::size_t stride, const char* extension = "EXT_meshopt_compression") {
  MeshoptView view{extension, 0, 0, code.size(), stride, count, mode, filter};
  return decode_meshopt(view, as_bytes(code), "f.glb", "bufferView 0");
}

std::string encoded_vertices(const void* data, std::size_t count, std::size_t stride) {
  std::string code(meshopt_encodeVertexBufferBound(count, stride), '\0');
  code.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(code.data()), code.size(), data,
                                         count, stride));
  return code;
}

std::string encoded_indices(const std::vector<unsigned>& indices, bool triangles) {
  std::string code(1 << 16, '\0');
  auto* const to = reinterpret_cast<unsigned char*>(code.data());
  code.resize(triangles ? meshopt_encodeIndexBuffer(to, code.size(), indices.data(), indices.size())
                        : meshopt_encodeIndexSequence(to, code.size(), indices.data(), indices.size()));
  return code;
}

TEST(SceneCompressed, MeshoptModes) {
  std::vector<unsigned char> values(300 * 12);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = static_cast<unsigned char>(k * k / 7);
  for (const std::size_t stride : {4u, 8u, 12u})
    for (const std::size_t count : {0u, 1u, 15u, 16u, 17u, 300u})
      EXPECT_EQ(decoded(encoded_vertices(values.data(), count, stride), "ATTRIBUTES", "NONE", count, stride),
                Bytes(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count * stride)));
  const std::vector<unsigned> indices{0, 1, 2, 2, 1, 3, 3, 1, 4};
  for (const std::size_t size : {2u, 4u}) {
    Bytes due;
    for (const unsigned index : indices)
      for (std::size_t k = 0; k < size; ++k) due.push_back(static_cast<unsigned char>(index >> (8 * k)));
    EXPECT_EQ(decoded(encoded_indices(indices, false), "INDICES", "NONE", 9, size), due);
    EXPECT_EQ(decoded(encoded_indices(indices, true), "TRIANGLES", "NONE", 9, size).size(), 9 * size);
  }
}

// Each filter against numbers that its specification gives, to within the bits that it stores.
TEST(SceneCompressed, MeshoptFilters) {
  constexpr std::size_t count = 32;
  std::vector<float> normals, turns, values;
  for (std::size_t k = 0; k < count; ++k) {
    const float a = static_cast<float>(k) * 0.7f, b = static_cast<float>(k) * 0.3f;
    normals.insert(normals.end(), {std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b), 1});
    turns.insert(turns.end(), {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), 0, std::cos(a)});
    values.insert(values.end(), {a * 100, -b, 0.001f * a, 1e5f * b});
  }
  std::vector<std::int16_t> packed(4 * count);
  const auto close = [&](const Bytes& bytes, const std::vector<float>& due, bool either_sign) {
    std::vector<std::int16_t> got(4 * count);
    std::memcpy(got.data(), bytes.data(), bytes.size());
    for (std::size_t k = 0; k < count; ++k) {
      double dot = 0;
      for (std::size_t c = 0; c < (either_sign ? 4u : 3u); ++c)
        dot += got[4 * k + c] / 32767.0 * due[4 * k + c];
      EXPECT_NEAR(either_sign ? std::fabs(dot) : dot, 1, 1e-4) << k;
    }
  };
  meshopt_encodeFilterOct(packed.data(), count, 8, 16, normals.data());
  close(decoded(encoded_vertices(packed.data(), count, 8), "ATTRIBUTES", "OCTAHEDRAL", count, 8), normals,
        false);
  meshopt_encodeFilterQuat(packed.data(), count, 8, 16, turns.data());
  close(decoded(encoded_vertices(packed.data(), count, 8), "ATTRIBUTES", "QUATERNION", count, 8), turns,
        true);
  std::vector<std::uint32_t> exponents(4 * count);
  meshopt_encodeFilterExp(exponents.data(), count, 16, 24, values.data());
  const Bytes bytes =
      decoded(encoded_vertices(exponents.data(), count, 16), "ATTRIBUTES", "EXPONENTIAL", count, 16);
  std::vector<float> got(4 * count);
  std::memcpy(got.data(), bytes.data(), bytes.size());
  for (std::size_t k = 0; k < got.size(); ++k)
    EXPECT_NEAR(got[k], values[k], std::fabs(values[k]) * 1e-5f + 0.2f) << k;
}

TEST(SceneCompressed, MeshoptThatIsRefused) {
  const std::vector<unsigned char> values(64, 7);
  const std::string good = encoded_vertices(values.data(), 16, 4);
  const auto says = [](const std::string& code, const char* mode, const char* filter, std::size_t count,
                       std::size_t stride) {
    return complaint_of<BadScene>([&] { decoded(code, mode, filter, count, stride); });
  };
  EXPECT_EQ(says(good, "ATTRIBUTES", "NONE", 16, 4), "none");
  for (const auto& [mode, filter, count, stride] : {std::tuple{"ATTRIBUTES", "NONE", 16, 6},
                                                    {"ATTRIBUTES", "QUATERNION", 16, 4},
                                                    {"VERTICES", "NONE", 16, 4},
                                                    {"TRIANGLES", "NONE", 16, 4},
                                                    {"TRIANGLES", "NONE", 15, 8},
                                                    {"INDICES", "OCTAHEDRAL", 16, 4},
                                                    {"ATTRIBUTES", "OCTAHEDRAL", 16, 12},
                                                    {"ATTRIBUTES", "SOME", 16, 4},
                                                    {"ATTRIBUTES", "NONE", 16, 260}})
    EXPECT_THAT(says(good, mode, filter, static_cast<std::size_t>(count), static_cast<std::size_t>(stride)),
                HasSubstr("do not go together"))
        << mode << filter << stride;
  EXPECT_THAT(says(good.substr(0, good.size() - 1), "ATTRIBUTES", "NONE", 16, 4), HasSubstr("damaged file?"));
  EXPECT_THAT(says(good, "ATTRIBUTES", "NONE", 1 << 28, 4), HasSubstr("cannot be in"));
  std::string newer = good;
  newer[0] = '\xa1';
  EXPECT_THAT(complaint_of<UnreadExtension>([&] { decoded(newer, "ATTRIBUTES", "NONE", 16, 4); }),
              HasSubstr("version 1 of the code of ATTRIBUTES is newer"));
  EXPECT_THAT(complaint_of<UnreadExtension>([&] { decoded(good, "ATTRIBUTES", "COLOR", 16, 4); }),
              HasSubstr("the filter COLOR is not read here"));
}

// A file of both: geometry and micromaps in compressed views, under either name.
TEST(SceneCompressed, MicromapsInCompressedViews) {
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    micromap_file::Subject plain, s;
    const Json view = s.records_view();
    const std::string records = s.file.bytes.substr(view["byteOffset"].get<std::size_t>(), 16);
    const std::string code = encoded_vertices(records.data(), 2, 8);
    micromap_file::compress(s.file, s.records_view(), code);
    Json& packed = s.records_view()["extensions"]["EXT_meshopt_compression"];
    packed["byteStride"] = 8;
    s.records_view()["byteLength"] = 16;
    const Json kept = packed;
    s.records_view()["extensions"] = {{name, kept}};
    EXPECT_TRUE(s.found().empty()) << name << micromap_file::lines(s.found());
    const Scene scene = load("f.glb", as_bytes(s.file.glb()));
    // A breach in the compressed records is found as in plain ones.
    std::string spoilt = records;
    spoilt[14] = 3;
    micromap_file::compress(s.file, s.records_view(), encoded_vertices(spoilt.data(), 2, 8));
    s.records_view()["extensions"]["EXT_meshopt_compression"]["byteStride"] = 8;
    s.records_view()["byteLength"] = 16;
    EXPECT_THAT(micromap_file::lines(s.found()), HasSubstr("record.format"));
    s.records_view()["byteLength"] = 24;
    EXPECT_THAT(micromap_file::lines(s.found()), HasSubstr("2 elements of 8 bytes for a view of 24"));
  }
}

#endif

}  // namespace scene_compressed_test
