// scene/: files judged for an API and a device; the VUIDs of findings; the null micromap.
#include "scene/validate/target.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "scene/read/bad_scene.hpp"
#include "scene/read/json_fault.hpp"
#include "scene/validate/folder.hpp"
#include "scene/validate/issues.hpp"
#include "scene/validate/vuids.hpp"
#include "tests/folder.hpp"
#include "tests/scene/array_files.hpp"

namespace scene_target_test {

using namespace mmverify::scene;
using namespace mmverify::tests;
namespace micromap = mmverify::impl::micromap;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

using Strings = std::vector<std::string>;

/// The findings as "code" or, with VUIDs, "code: number number", where a number is the last part of a VUID.
Strings codes(const Judged& judged) {
  Strings all;
  for (const FileViolation& finding : judged.findings) {
    all.push_back(std::string(finding.rule) + (finding.vuids.empty() ? "" : ":"));
    for (const std::string_view vuid : finding.vuids)
      all.back() += " " + std::string(vuid.substr(vuid.rfind('-') + 1));
  }
  return all;
}

Target target(micromap::Sets apis, const Device& device = {}) { return {apis, device}; }

/// A raw array for one API, without the arrays' own counts of the geometry.
struct ForApi : RawArray {
  explicit ForApi(const char* api) {
    json["apis"] = {api};
    geometry().erase("usageCounts");
  }
  Strings findings() const { return codes(file().judged()); }
};

/// The null micromap: no records, no data, no counts.
struct NullMicromap : ForApi {
  NullMicromap(const char* api, bool as_null) : ForApi(api) {
    records.clear();
    data.clear();
    json["usageCounts"] = Json::array();
    if (as_null) json["records"] = json["data"] = nullptr;
  }
};

TEST(SceneTarget, TheNullMicromapHasSpecialIndicesAlone) {
  for (const bool as_null : {false, true})
    for (const char* api : {"ext", "khr", "dxr"}) {
      NullMicromap array(api, as_null);
      array.indices = {0xff, 0xff, 0xfe, 0xff, 0xfc, 0xff};
      EXPECT_THAT(array.findings(), IsEmpty()) << api << as_null;
    }
  // VkAccelerationStructureTrianglesOpacityMicromapKHR: each index is a special one; NONE has a micromap.
  NullMicromap plain("khr", true);
  plain.indices = {0xff, 0xff, 7, 0, 0xfc, 0xff};
  EXPECT_THAT(plain.findings(), ElementsAre("index.range: 11578"));
  NullMicromap none("khr", true);
  none.geometry()["indices"] = nullptr;
  EXPECT_THAT(none.findings(), ElementsAre("index.range: 11579"));
}

TEST(SceneTarget, EmptyFilesAreEmptyBuffers) {
  NullMicromap array("khr", false);
  array.indices = {0xff, 0xff, 0xfe, 0xff, 0xfc, 0xff};
  const Folder folder;
  const MadeFile made = array.file();
  GltfFile::write(folder / "array.json", {made.bytes.begin(), made.bytes.end()});
  for (const auto& [name, bytes] : made.beside) GltfFile::write(folder / name, {bytes.begin(), bytes.end()});
  EXPECT_THAT(codes(validate_file((folder / "array.json").string())), IsEmpty());
}

TEST(SceneTarget, VuidsOfRecordsAndCountsDependOnTheFormat) {
  ForApi ext("ext");
  ext.json["limits"]["fourStateLevel"] = 1;
  EXPECT_THAT(ext.findings(), ElementsAre("record.level: 11660", "counts.level: 11655"));
  ext.json["limits"]["twoStateLevel"] = 0;
  EXPECT_THAT(ext.findings(), ElementsAre("record.level: 11660", "record.level: 11659", "counts.level: 11655",
                                          "counts.level: 11654"));
  ForApi khr("khr");
  khr.json["limits"]["twoStateLevel"] = 0;
  EXPECT_THAT(khr.findings(), ElementsAre("record.level: 11556", "counts.level: 11645"));
  khr.json["limits"] = {{"fourStateLevel", 1}};
  EXPECT_THAT(khr.findings(), ElementsAre("record.level: 11566", "counts.level: 11564"));
  khr.json["limits"]["triangles"] = 1;
  EXPECT_THAT(khr.findings(),
              ElementsAre("record.level: 11566", "counts.level: 11564", "counts.limit: 11643"));
}

TEST(SceneTarget, VuidsOfIndicesDependOnTheBuffer) {
  ForApi array("khr");
  array.indices[2] = 2;
  EXPECT_THAT(array.findings(), ElementsAre("index.range: 11575"));
  array.geometry()["indices"] = nullptr;
  EXPECT_THAT(array.findings(), ElementsAre("index.range: 11576"));
  array.geometry()["triangles"] = 2;
  EXPECT_THAT(array.findings(), IsEmpty());
  array.geometry()["indices"] = {{"type", "none"}};
  EXPECT_THAT(array.findings(), IsEmpty());
  array.geometry()["indices"]["file"] = "indices.bin";
  EXPECT_THAT(array.findings(), ElementsAre("index.none: 11571"));
  array.json["apis"] = {"ext"};
  EXPECT_THAT(array.findings(), ElementsAre("index.none: 10904"));
  array.json["apis"] = {"dxr"};
  EXPECT_THAT(array.findings(), IsEmpty());
}

TEST(SceneTarget, MixedIndicesAreAnAdviceUnlessPipelinesForbidThem) {
  ForApi array("khr");
  array.indices = {0, 0, 0xfd, 0xff, 1, 0};
  EXPECT_THAT(array.findings(), ElementsAre("index.mixed_khr: 11638 11639"));
  EXPECT_EQ(array.file().judged().findings[0].found, "triangle 0 has a record, triangle 1 a special index");
  array.json["limits"]["disallowMixedSpecialIndex"] = true;
  EXPECT_THAT(array.findings(), ElementsAre("index.mixed: 11638 11639"));
  // One kind of index is no mixture; a stride of 0 gives all triangles the first one.
  array.indices = {0, 0, 0, 0, 1, 0};
  EXPECT_THAT(array.findings(), IsEmpty());
  array.indices = {0xff, 0xff, 0xfd, 0xff, 0xfe, 0xff};
  EXPECT_THAT(array.findings(), IsEmpty());
  array.indices = {0, 0, 0xfd, 0xff, 1, 0};
  array.geometry()["indices"]["stride"] = 0;
  EXPECT_THAT(array.findings(), IsEmpty());
  array.geometry()["indices"].erase("stride");
  array.json["apis"] = {"ext"};
  EXPECT_THAT(array.findings(), IsEmpty());
}

/// The good glTF file, whose two primitives have 16-bit signed indices and none.
struct Gltf : micromap_file::Subject {
  Strings findings(const Target& built) const {
    return codes(MadeFile{as_bytes(file.glb())}.judged({}, built));
  }
};

TEST(SceneTarget, AGltfIsJudgedByTheRulesOfItsApi) {
  Gltf gltf;
  for (const micromap::Sets api : {micromap::EXT, micromap::DXR})
    EXPECT_THAT(gltf.findings(target(api)), IsEmpty()) << int{api};
  EXPECT_THAT(gltf.findings(target(micromap::KHR)), ElementsAre("index.mixed_khr: 11638 11639"));
  Device device;
  device.disallow_mixed = true;
  device.limits.four_state_level = 1;
  device.limits.triangles = 1;
  EXPECT_THAT(gltf.findings(target(micromap::KHR, device)),
              ElementsAre("record.level: 11566", "counts.level: 11564", "counts.limit: 11643",
                          "index.mixed: 11638 11639"));
  EXPECT_THAT(gltf.findings(target(micromap::EXT, device)),
              ElementsAre("record.level: 11660", "counts.level: 11655"));
  // glTF's own rules have no limits.
  EXPECT_THAT(gltf.findings(target(0, device)), IsEmpty());
}

TEST(SceneTarget, AGltfWithBytesAsIndices) {
  Gltf gltf;
  gltf.accessor()["componentType"] = 5121;
  gltf.byte_of(gltf.indices_view(), 0) = 1;
  gltf.byte_of(gltf.indices_view(), 1) = 0;
  EXPECT_THAT(gltf.findings({}), IsEmpty());
  EXPECT_THAT(gltf.findings(target(micromap::EXT)), ElementsAre("index.encoding: 10719"));
  EXPECT_THAT(gltf.findings(target(micromap::KHR)), IsEmpty());
  Device device;
  device.index_uint8 = false;
  EXPECT_THAT(gltf.findings(target(micromap::KHR, device)), ElementsAre("index.uint8: 11570"));
  EXPECT_THAT(gltf.findings(target(micromap::DXR, device)), IsEmpty());
}

// A file for no API may be built for either, and has the VUIDs of both.
TEST(SceneTarget, AGltfForNoApiHasTheVuidsOfBoth) {
  Gltf gltf;
  gltf.byte_of(gltf.records_view(), 6) = 3;
  EXPECT_EQ(gltf.findings({}).at(0), "record.format: 11657 11555");
  EXPECT_EQ(gltf.findings(target(micromap::EXT)).at(0), "record.format: 11657");
  EXPECT_EQ(gltf.findings(target(micromap::DXR)).at(0), "record.format");
}

TEST(SceneTarget, ATargetTakesThePlaceOfASidecarsOwn) {
  ForApi array("dxr");
  array.json["limits"] = {{"fourStateLevel", 3}};
  EXPECT_THAT(array.findings(), IsEmpty());
  Device device;
  device.limits.four_state_level = 1;
  EXPECT_THAT(codes(array.file().judged({}, target(micromap::EXT, device))),
              ElementsAre("record.level: 11660", "counts.level: 11655"));
}

TEST(SceneTarget, EachVuidIsOfAnIssueAndOfItsApi) {
  const std::regex shape("VUID-(Vk|vkCmd)[A-Za-z]+-[A-Za-z]+-([0-9]{5}|parameter)");
  std::set<std::pair<std::string_view, std::string_view>> once;
  for (const Vuid& one : vuids()) {
    EXPECT_NO_THROW(issue_of(one.code)) << one.code;
    EXPECT_TRUE(std::regex_match(std::string(one.name), shape)) << one.name;
    EXPECT_TRUE(one.api == micromap::EXT || one.api == micromap::KHR) << one.name;
    EXPECT_TRUE(once.insert({one.code, one.name}).second) << one.code << " " << one.name;
    // A rule of arrays has VUIDs of those APIs alone that have the rule.
    for (const micromap::RuleText& rule : micromap::rules)
      EXPECT_TRUE(rule.id != one.code || (rule.sets & one.api) != 0) << one.code << " " << one.name;
  }
}

TEST(SceneTarget, LimitsOfAFile) {
  const Folder folder;
  const std::string file = (folder / "limits.json").string();
  GltfFile::write(file, R"({"twoStateLevel": 5, "indexTypeUint8": false})");
  const Device device = read_device(file);
  EXPECT_EQ(device.limits.two_state_level, 5u);
  EXPECT_EQ(device.limits.four_state_level, 12u);
  EXPECT_FALSE(device.index_uint8);
  EXPECT_FALSE(device.disallow_mixed);
  for (const auto& [text, says] : {std::pair{"{", "the JSON ends at byte 1, within a value; truncated file?"},
                                   {"[1]", "the limits: an object is due, not an array"},
                                   {R"({"levels": 1})", "no member is called levels"},
                                   {R"({"triangles": -1})", "/triangles: a whole number from 0"},
                                   {R"({"triangles": 1, "triangles": 2})", "two members of this name"},
                                   {R"({"indexTypeUint8": 1})", "true or false is due, not 1"}}) {
    GltfFile::write(file, text);
    try {
      read_device(file);
      FAIL() << text;
    } catch (const BadScene& bad) {
      EXPECT_THAT(bad.what(), ::testing::HasSubstr(says)) << text;
    }
  }
}

TEST(SceneTarget, AFaultOfJsonHasItsLineAndColumn) {
  EXPECT_EQ(json_fault("{\"a\": [1, 2]}"), "");
  EXPECT_EQ(json_fault("{\"a\": [1, 2"), "the JSON ends at byte 11, within a value; truncated file?");
  EXPECT_EQ(json_fault("{\n \"a\" = 1}"), "line 2, column 6: no JSON from here on");
  EXPECT_EQ(json_fault("x"), "line 1, column 1: no JSON from here on");
  EXPECT_EQ(json_fault("{} {}"), "line 1, column 4: no JSON from here on");
  EXPECT_EQ(json_fault("[1e999]"), "line 1, column 6: the number that ends here is too large");
  EXPECT_EQ(json_fault(""), "the JSON ends at byte 0, within a value; truncated file?");
}

TEST(SceneTarget, FilesOfAFolder) {
  const Folder folder;
  std::filesystem::create_directory(folder / "within");
  GltfFile::write(folder / "within/b.GLB", "any");
  GltfFile::write(folder / "a.gltf", "{}");
  GltfFile::write(folder / "c.json", R"({"schema": "mmverify.array/1"})");
  GltfFile::write(folder / "package.json", R"({"name": "mine"})");
  GltfFile::write(folder / "empty.json", "");
  GltfFile::write(folder / "tree", std::string("mmtr") + std::string(20, '\0'));
  GltfFile::write(folder / "picture.png", "mm");
  Strings names;
  for (const std::string& path : micromap_files((folder / ".").string()))
    names.push_back(std::filesystem::path(path).filename().string());
  EXPECT_THAT(names, ElementsAre("a.gltf", "c.json", "tree", "b.GLB"));
  EXPECT_THROW(micromap_files((folder / "no").string()), BadScene);
  std::filesystem::remove(folder / "within/b.GLB");
  EXPECT_THROW(micromap_files((folder / "within").string()), BadScene);
}

}  // namespace scene_target_test
