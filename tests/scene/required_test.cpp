// scene/: names in extensionsRequired, versions and other names: what matters to micromaps, and what does not.
#include "scene/read/document.hpp"
#include "scene/validate/file.hpp"
#include "tests/scene/loaded_scene.hpp"
#include "tests/scene/micromap_breaches.hpp"

namespace scene_required_test {

using namespace mmverify::scene;
using namespace mmverify::tests;
using micromap_file::Subject;
using testing::HasSubstr;

Judged judged(const GltfFile& file) {
  return validate_file("f.glb", as_bytes(file.glb()), {}, [](const std::string&) { return Bytes(); });
}

TEST(SceneRequired, ANameThatNoRuleNeedsDoesNotMatter) {
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression", "KHR_draco_mesh_compression",
                           "EXT_texture_webp", "EXT_structural_metadata", "ACME_anything"}) {
    Subject s;
    s.file.json["extensionsUsed"].push_back(name);
    s.file.json["extensionsRequired"] = {name};
    EXPECT_TRUE(s.found().empty()) << name << micromap_file::lines(s.found());
    GltfFile file = square();
    file.json["extensionsRequired"] = {name};
    expect_square(load_glb(file));
    // Nor does it matter on an object that is not read.
    file.json["nodes"][0]["extensions"][name] = Json::object();
    file.json["extensions"][name] = Json::object();
    expect_square(load_glb(file));
  }
}

TEST(SceneRequired, OnAnObjectThatIsReadItIsNamed) {
  const std::pair<const char*, const char*> places[] = {
      {"/meshes/0/primitives/0", "mesh 0 primitive 0"},
      {"/accessors/0", "accessor 0"},
      {"/accessors/2", "accessor 2"},
      {"/bufferViews/1", "bufferView 1"},
      {"/materials/0", "material 0 (leaf)"},
      {"/textures/0", "texture 0"},
      {"/images/0", "image 0 (leaf)"},
      {"/buffers/0", "buffer 0"},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture", "material 0 (leaf)"}};
  for (const auto& [pointer, place] : places) {
    GltfFile file = square();
    file.json[Json::json_pointer(pointer)]["extensions"]["ACME_other"] = Json::object();
    expect_square(load_glb(file));  // not required, so it may be ignored
    file.json["extensionsRequired"] = {"ACME_other"};
    EXPECT_THAT(complaint(file), testing::AllOf(HasSubstr(place), HasSubstr("it has ACME_other"))) << pointer;
    file.json["extensionsRequired"] = {"EXT_mesh_features"};
    file.json[Json::json_pointer(pointer)]["extensions"] = {{"EXT_mesh_features", Json::object()}};
    expect_square(load_glb(file));
  }
}

TEST(SceneRequired, AVersionThatIsNeededIsRefused) {
  GltfFile file = square();
  file.json["asset"]["version"] = "2.1";
  expect_square(load_glb(file));
  for (const char* none : {"2.j0", "2.", ".0", "2", "2.0.1", " 2.0"}) {
    file.json["asset"]["version"] = none;
    EXPECT_THAT(complaint(file), HasSubstr(std::string("/asset/version: '") + none + "' is no version"))
        << none;
  }
  file.json["asset"]["version"] = "2.1";
  for (const char* least : {"2.0", "1.0"}) {
    file.json["asset"]["minVersion"] = least;
    expect_square(load_glb(file));
  }
  file.json["asset"]["minVersion"] = "2.1";
  EXPECT_THAT(complaint(file), HasSubstr("/asset/minVersion: the file needs glTF 2.1; 2.0 is read here"));
  file.json["asset"]["minVersion"] = 2;
  EXPECT_THAT(complaint(file), HasSubstr("/asset/minVersion: a string is due"));
}

// A breach is found in a file of a later minor version, too, and its version is said beside it.
TEST(SceneRequired, ALaterMinorVersionIsJudged) {
  Subject s;
  s.file.json["asset"]["version"] = "2.7";
  s.micromap()["data"] = 99;
  const auto found = s.found();
  ASSERT_EQ(found.size(), 2u) << micromap_file::lines(found);
  EXPECT_EQ(found[0].rule, "file.newer");
  EXPECT_EQ(found[1].rule, "micromap.view");
}

TEST(SceneRequired, AnotherNameIsSaid) {
  for (const char* name : {"NV_opacity_micromap", "NV_mesh_opacityMicromap", "ACME_OPACITY_MICROMAP_2"}) {
    GltfFile listed = square(), on_root = square(), on_primitive = square();
    listed.json["extensionsUsed"] = {name};
    on_root.json["extensions"][name] = Json::object();
    on_primitive.primitive()["extensions"][name] = Json::object();
    for (const GltfFile& file : {listed, on_root, on_primitive}) {
      const Judged found = judged(file);
      ASSERT_EQ(found.findings.size(), 1u);
      EXPECT_EQ(found.findings[0].rule, "file.no_micromaps");
      EXPECT_EQ(found.findings[0].found,
                std::string("the file has ") + name +
                    "; EXT_mesh_opacity_micromap and KHR_mesh_opacity_micromap are read");
    }
  }
  GltfFile other = square();
  other.json["extensionsUsed"] = {"NV_micromap_of_displacement"};
  EXPECT_EQ(judged(other).findings.at(0).found, "no object has the extension");
}

// A tool that renumbers views and does not know the extension: the cause comes before what follows from it.
TEST(SceneRequired, ViewsOfOthersAreNamedFirst) {
  Subject s;
  const std::size_t positions = s.file.accessor("POSITION")["bufferView"].get<std::size_t>();
  s.micromap()["data"] = positions;
  s.micromap()["triangles"] = s.file.json["images"][0]["bufferView"];
  const auto found = s.found();
  ASSERT_GE(found.size(), 3u);
  EXPECT_EQ(describe(found[0]), "view.shared: " + micromap_file::micromap_at + "/data: bufferView " +
                                    std::to_string(positions) + " is accessor 0's, too");
  EXPECT_EQ(found[1].rule, "view.shared");
  EXPECT_THAT(found[1].found, HasSubstr("is image 0's, too"));
  Subject indices;
  indices.extension()["micromapIndices"] = indices.file.primitive()["indices"];
  EXPECT_THAT(micromap_file::lines(indices.found()),
              HasSubstr("accessor 2 is the indices of mesh 0 primitive 0, too"));
}

}  // namespace scene_required_test
