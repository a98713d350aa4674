// scene/: the validator of EXT_mesh_opacity_micromap.  A good file, each rule of it broken by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "scene/validate/micromaps.hpp"
#include "tests/folder.hpp"
#include "tests/scene/micromap_breaches.hpp"

namespace {

using namespace mmverify::scene;
using namespace mmverify::tests;
using namespace mmverify::tests::micromap_file;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(SceneValidate, TheGoodFile) {
  EXPECT_THAT(Subject().found(), IsEmpty()) << lines(Subject().found());
  // And it says what it is meant to say.
  Subject s;
  EXPECT_EQ(s.micromap()["usageCounts"], (Json{1, 1}));
  EXPECT_EQ(s.accessor()["componentType"], 5122);
  EXPECT_EQ(s.extension(1)["micromapBaseTriangle"], 1);
  EXPECT_FALSE(s.extension(1).contains("micromapIndices"));
}

TEST(SceneValidate, EachBreachIsFoundWhereItIs) {
  for (const Breach& breach : breaches()) {
    if (!breach.plant) continue;
    Subject s;
    breach.plant(s);
    const auto found = s.found();
    ASSERT_EQ(found.size(), 1u) << breach.rule << " planted:" << lines(found);
    EXPECT_EQ(found[0].rule, breach.rule) << lines(found);
    EXPECT_EQ(found[0].pointer, breach.pointer) << lines(found);
    EXPECT_EQ(describe(found[0]).find('\n'), std::string::npos);
  }
}

// Levels and formats stand twice, in a record and in the counts: where both say the same wrong thing, both
// are named, and nothing else.
TEST(SceneValidate, LevelsAndFormats) {
  const auto rules_of = [](const Subject& s) {
    std::set<std::string> rules;
    for (const FileViolation& violation : s.found()) rules.emplace(violation.rule);
    return rules;
  };
  Subject s;
  s.micromap()["usageLevels"][0] = 13;
  s.byte_of(s.records_view(), 12) = 13;
  EXPECT_EQ(rules_of(s), (std::set<std::string>{"counts.level_12", "record.level_12", "record.region"}));
  s = {};
  s.micromap()["usageFormats"][0] = 3;
  s.byte_of(s.records_view(), 14) = 3;
  EXPECT_EQ(rules_of(s), (std::set<std::string>{"counts.format", "record.format"}));
}

TEST(SceneValidate, EveryRuleHasAPlantedBreach) {
  std::set<std::string> ids, planted;
  for (const FileRule& rule : file_rules()) {
    EXPECT_TRUE(ids.insert(rule.id).second) << rule.id;
    EXPECT_GT(std::string(rule.says).size(), 10u) << rule.id;
    EXPECT_FALSE(std::string(rule.source).empty()) << rule.id;
  }
  for (const Breach& breach : breaches()) planted.insert(breach.rule);
  EXPECT_EQ(planted, ids);
}

TEST(SceneValidate, TheDocumentListsTheRules) {
  const std::string document = text_of(MMVERIFY_DOCUMENT);
  std::size_t from = 0;
  for (const FileRule& rule : file_rules()) {
    const std::string row = std::string("\n| `") + rule.id + "` | " + rule.says + " | " + rule.source + " |";
    const std::size_t at = document.find(row, from);
    ASSERT_NE(at, std::string::npos) << row;
    from = at + row.size();
  }
  EXPECT_EQ(document.find("\n| `", from), std::string::npos);
}

TEST(SceneValidate, WhatIsAllowed) {
  const auto clean = [](const std::function<void(Subject&)>& change) {
    Subject s;
    change(s);
    EXPECT_THAT(s.found(), IsEmpty()) << lines(s.found());
  };
  clean([](Subject& s) { s.micromap()["name"] = "leaves"; });
  clean([](Subject& s) {
    s.micromap()["extras"] = s.root()["extras"] = s.extension()["extras"] = {{"a", 1}};
  });
  clean([](Subject& s) { s.micromap()["unknown"] = 7; });
  // Counts in parts add up.
  clean([](Subject& s) {
    s.byte_of(s.records_view(), 4) = 1;
    s.byte_of(s.records_view(), 6) = 1;
    s.byte_of(s.data_view(), 0) = 0x55;
    s.micromap()["usageLevels"] = {1, 1};
    s.micromap()["usageFormats"] = {1, 1};
  });
  // The four bits after a 2-state map of level 1 are nobody's.
  clean([](Subject& s) { s.byte_of(s.data_view(), 4) = 0x05; });
  for (int code = -4; code < 2; ++code)
    clean([&](Subject& s) {
      s.byte_of(s.indices_view(), 2) = static_cast<char>(code);
      s.byte_of(s.indices_view(), 3) = static_cast<char>(code >> 8);
    });
  clean([](Subject& s) { s.extension()["micromapBaseTriangle"] = 0; });
  clean([](Subject& s) { s.accessor()["componentType"] = 5123; });
  clean([](Subject& s) { s.accessor().erase("bufferView"); });  // zeros
  clean([](Subject& s) { s.accessor()["sparse"] = sparse_of(s, "\1", std::string("\0\0", 2)); });
  clean([](Subject& s) {
    for (Json& primitive : s.file.json["meshes"][0]["primitives"]) primitive.erase("extensions");
  });
  EXPECT_THAT(validate_micromaps("square.glb", as_bytes(square().glb())), IsEmpty());
}

// Sparse elements replace the accessor's own, so they are the ones judged.
TEST(SceneValidate, SparseIndicesAreJudged) {
  Subject s;
  s.accessor()["sparse"] = sparse_of(s, "\1", std::string("\2\0", 2));
  ASSERT_EQ(s.found().size(), 1u) << lines(s.found());
  EXPECT_EQ(describe(s.found()[0]), "index.range: " + indices_at + ": triangle 1: record 2 of 2");
}

TEST(SceneValidate, ALine) {
  Subject s;
  s.micromap()["data"] = 99;
  ASSERT_EQ(s.found().size(), 1u);
  EXPECT_EQ(describe(s.found()[0]), "micromap.view: " + micromap_at + "/data: 99 is no index of the " +
                                        std::to_string(s.file.json["bufferViews"].size()) + " bufferViews");
}

TEST(SceneValidate, ManyOfOneKindAreCounted) {
  Subject s;
  std::vector<std::uint16_t> codes(60, 9);
  codes[7] = 0;
  GltfFile& file = s.file;
  std::vector<std::uint32_t> vertices(180, 0);
  file.primitive()["indices"] = file.add_accessor(vertices, 5125, "SCALAR", 1);
  s.extension()["micromapIndices"] = file.add_accessor(codes, 5123, "SCALAR", 1);
  file.set_buffer_length();
  const auto found = s.found();
  ASSERT_EQ(found.size(), 9u) << lines(found);
  EXPECT_EQ(found[7].found, "triangle 8: record 9 of 2");
  EXPECT_EQ(found[8].found, "and 51 more");
}

TEST(SceneValidate, WhatIsNoFile) {
  EXPECT_EQ(validate_micromaps("no/such.glb").at(0).rule, "file.readable");
  EXPECT_EQ(validate_micromaps("nothing.glb", {}).at(0).rule, "file.readable");
  const std::string whole = Subject().file.glb();
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_FALSE(validate_micromaps("cut.glb", as_bytes(whole.substr(0, size))).empty());
}

}  // namespace
