// scene/: the validator of EXT_mesh_opacity_micromap.  A good file, each rule of it broken by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "scene/validate/micromaps.hpp"
#include "scene/write/glb.hpp"
#include "tests/folder.hpp"
#include "tests/scene/gltf_file.hpp"

namespace {

using namespace mmverify::scene;
using namespace mmverify::tests;
using mmverify::impl::micromap::Array;
using mmverify::impl::micromap::Encoding;
using testing::ElementsAre;
using testing::IsEmpty;

const char* const name = "EXT_mesh_opacity_micromap";

/// Two primitives: two triangles with 16-bit signed indices, record 1 and opaque; one triangle without, on
/// record 0 + 1.
GltfFile good() {
  GltfFile source = square();
  source.json["meshes"][0]["primitives"].push_back(source.primitive());
  source.json["meshes"][0]["primitives"][1].erase("indices");
  source.set_buffer_length();
  const Array array{{{0, 2, 2}, {4, 1, 1}}, {0xe4, 0x1b, 0, 0, 0xf5}};
  const std::vector<std::int16_t> codes{1, -2};
  const std::string bytes = bytes_of(codes);
  const std::vector<unsigned char> indices = as_bytes(bytes);
  const PrimitiveMicromaps primitives[] = {{0, 0, 0, Encoding::i16, indices, 0},
                                           {0, 1, 0, Encoding::u32, {}, 1}};
  return taken_apart(
      to_glb("good.glb", as_bytes(source.glb()), {std::span(&array, 1), std::span(primitives)}));
}

struct Subject {
  GltfFile file = good();

  Json& root() { return file.json["extensions"][name]; }
  Json& micromap() { return root()["micromaps"][0]; }
  Json& extension(std::size_t primitive = 0) {
    return file.json["meshes"][0]["primitives"][primitive]["extensions"][name];
  }
  Json& view_of(const Json& number) { return file.json["bufferViews"][number.get<std::size_t>()]; }
  Json& data_view() { return view_of(micromap()["data"]); }
  Json& records_view() { return view_of(micromap()["triangles"]); }
  Json& accessor() { return file.json["accessors"][extension()["micromapIndices"].get<std::size_t>()]; }
  Json& indices_view() { return view_of(accessor()["bufferView"]); }
  char& byte_of(Json& view, std::size_t at) { return file.bytes[view["byteOffset"].get<std::size_t>() + at]; }

  std::vector<FileViolation> found() const { return validate_micromaps("f.glb", as_bytes(file.glb())); }
};

std::string lines(const std::vector<FileViolation>& found) {
  std::string all;
  for (const FileViolation& violation : found) all += "\n  " + describe(violation);
  return all;
}

/// A breach of one rule, which shows at one place, and breaks no other.
struct Breach {
  std::string rule, pointer;
  std::function<void(Subject&)> plant;
};

const std::string root_at = std::string("/extensions/") + name, micromap_at = root_at + "/micromaps/0",
                  primitive_at = "/meshes/0/primitives/0" + root_at,
                  indices_at = primitive_at + "/micromapIndices", accessor_at = "/accessors/3";

Json sparse_of(Subject& s, const std::string& where, const std::string& what) {
  const auto indices = s.file.add_view(where), values = s.file.add_view(what);
  s.file.set_buffer_length();
  return {{"count", where.size()},
          {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
          {"values", {{"bufferView", values}}}};
}

const std::vector<Breach>& breaches() {
  static const std::vector<Breach> all{
      {"file.readable", "", [](Subject& s) { s.file.json["asset"]["version"] = 2; }},
      {"used.listed", "/extensionsUsed", [](Subject& s) { s.file.json.erase("extensionsUsed"); }},
      {"required.unlisted", "/extensionsRequired",
       [](Subject& s) { s.file.json["extensionsRequired"] = {name}; }},
      {"root.micromaps", root_at + "/micromaps",
       [](Subject& s) {
         s.root()["micromaps"] = Json::array();
         for (Json& primitive : s.file.json["meshes"][0]["primitives"]) primitive.erase("extensions");
       }},
      {"root.object", root_at,
       [](Subject& s) {
         s.root() = 7;
         for (Json& primitive : s.file.json["meshes"][0]["primitives"]) primitive.erase("extensions");
       }},
      {"micromap.object", micromap_at, [](Subject& s) { s.micromap() = Json::array(); }},
      {"micromap.missing", micromap_at, [](Subject& s) { s.micromap().erase("usageLevels"); }},
      {"micromap.missing", micromap_at, [](Subject& s) { s.micromap().erase("data"); }},
      {"micromap.missing", micromap_at, [](Subject& s) { s.micromap().erase("triangles"); }},
      {"micromap.name", micromap_at + "/name", [](Subject& s) { s.micromap()["name"] = 1; }},
      {"micromap.view", micromap_at + "/data", [](Subject& s) { s.micromap()["data"] = 99; }},
      {"micromap.view", micromap_at + "/triangles", [](Subject& s) { s.micromap()["triangles"] = -1; }},
      {"view.stride", micromap_at + "/triangles", [](Subject& s) { s.records_view()["byteStride"] = 8; }},
      {"view.stride", micromap_at + "/data", [](Subject& s) { s.data_view()["byteStride"] = 4; }},
      {"view.stride", indices_at, [](Subject& s) { s.indices_view()["byteStride"] = 4; }},
      {"view.inside", micromap_at + "/data", [](Subject& s) { s.data_view()["byteLength"] = 100000; }},
      {"usage.array", micromap_at + "/usageFormats", [](Subject& s) { s.micromap()["usageFormats"] = 1; }},
      {"usage.integer", micromap_at + "/usageLevels/0",
       [](Subject& s) { s.micromap()["usageLevels"][0] = 1.5; }},
      {"usage.integer", micromap_at + "/usageCounts/1",
       [](Subject& s) { s.micromap()["usageCounts"][1] = -1; }},
      {"usage.integer", micromap_at + "/usageCounts/1",
       [](Subject& s) { s.micromap()["usageCounts"][1] = 4294967297; }},
      {"usage.length", micromap_at + "/usageLevels", [](Subject& s) { s.micromap()["usageLevels"] = {1}; }},
      {"counts.zero", micromap_at + "/usageCounts/2",
       [](Subject& s) {
         s.micromap()["usageCounts"].push_back(0);
         s.micromap()["usageLevels"].push_back(1);
         s.micromap()["usageFormats"].push_back(1);
       }},
      // A count of what no record can be breaks counts.array as well; so these come with a record of it.
      {"counts.level_12", micromap_at + "/usageLevels/0", {}},
      {"counts.format", micromap_at + "/usageFormats/0", {}},
      {"counts.array", micromap_at + "/usageCounts",
       [](Subject& s) {
         s.micromap()["usageCounts"] = {2, 1};
       }},
      {"records.whole", micromap_at + "/triangles", [](Subject& s) { s.records_view()["byteLength"] = 17; }},
      {"record.region", micromap_at + "/triangles", [](Subject& s) { s.data_view()["byteLength"] = 4; }},
      {"record.overlap", micromap_at + "/triangles", [](Subject& s) { s.byte_of(s.records_view(), 8) = 3; }},
      {"record.level_12", micromap_at + "/triangles", {}},
      {"record.format", micromap_at + "/triangles", {}},
      {"primitive.object", primitive_at, [](Subject& s) { s.extension() = "0"; }},
      {"primitive.micromap", primitive_at + "/micromap", [](Subject& s) { s.extension()["micromap"] = 1; }},
      {"primitive.micromap", primitive_at + "/micromap", [](Subject& s) { s.extension().erase("micromap"); }},
      {"primitive.base", primitive_at + "/micromapBaseTriangle",
       [](Subject& s) { s.extension()["micromapBaseTriangle"] = -1; }},
      {"primitive.mode", "/meshes/0/primitives/1/mode",
       [](Subject& s) { s.file.json["meshes"][0]["primitives"][1]["mode"] = 5; }},
      {"indices.accessor", indices_at, [](Subject& s) { s.extension()["micromapIndices"] = 4; }},
      {"indices.type", accessor_at + "/type", [](Subject& s) { s.accessor()["type"] = "VEC2"; }},
      {"indices.component", accessor_at + "/componentType",
       [](Subject& s) { s.accessor()["componentType"] = 5126; }},
      {"indices.component", accessor_at + "/componentType",
       [](Subject& s) { s.accessor()["componentType"] = 5120; }},
      {"indices.normalized", accessor_at + "/normalized",
       [](Subject& s) { s.accessor()["normalized"] = true; }},
      {"indices.count", indices_at, [](Subject& s) { s.accessor()["count"] = 1; }},
      {"indices.inside", indices_at, [](Subject& s) { s.accessor()["byteOffset"] = 2; }},
      {"indices.sparse", accessor_at + "/sparse/indices",
       [](Subject& s) { s.accessor()["sparse"] = sparse_of(s, "\2", std::string("\0\0", 2)); }},
      {"indices.sparse", accessor_at + "/sparse/indices",
       [](Subject& s) {
         s.accessor()["sparse"] = sparse_of(s, std::string("\1\0", 2), std::string(4, '\0'));
       }},
      {"indices.sparse", accessor_at + "/sparse/values",
       [](Subject& s) {
         s.accessor()["sparse"] = sparse_of(s, std::string("\0\1", 2), std::string(3, '\0'));
       }},
      {"align.index", indices_at,
       [](Subject& s) {
         s.indices_view()["byteOffset"] = s.indices_view()["byteOffset"].get<int>() - 1;
         s.byte_of(s.indices_view(), 0) = s.byte_of(s.indices_view(), 1) = 0;
         s.byte_of(s.indices_view(), 2) = s.byte_of(s.indices_view(), 3) = 0;
       }},
      {"index.special", indices_at, [](Subject& s) { s.byte_of(s.indices_view(), 2) = '\xfb'; }},
      {"index.range", indices_at, [](Subject& s) { s.byte_of(s.indices_view(), 0) = 2; }},
      {"index.range", "/meshes/0/primitives/1" + root_at,
       [](Subject& s) { s.extension(1)["micromapBaseTriangle"] = 2; }},
      {"index.range", "/meshes/0/primitives/1" + root_at,
       [](Subject& s) { s.extension(1)["micromapBaseTriangle"] = 4294967295; }},
      {"limits.indices", accessor_at + "/count",
       [](Subject& s) {
         s.accessor().erase("bufferView");
         s.accessor()["count"] = 4194305;
       }},
  };
  return all;
}

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

// What sparse elements say is what counts.
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
