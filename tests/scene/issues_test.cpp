// scene/: the table of what validate_file() finds.  For each code a file that gives it alone; the document is the table.
#include "scene/validate/issues.hpp"

#include <gtest/gtest.h>

#include <set>

#include "impl/common/crc32c.hpp"
#include "impl/micromap/rules.hpp"
#include "tests/folder.hpp"
#include "tests/scene/array_files.hpp"

namespace scene_issues_test {

using namespace mmverify::scene;
using namespace mmverify::tests;
namespace micromap_file = mmverify::tests::micromap_file;

struct Case {
  std::string code;
  MadeFile file;
  std::optional<Draft> draft = {};
};

MadeFile raw(const std::function<void(RawArray&)>& spoil) {
  RawArray array;
  spoil(array);
  return array.file();
}

/// A file for one API, without counts.
MadeFile plain(const char* api, const std::function<void(RawArray&)>& spoil) {
  return raw([&](RawArray& a) {
    a.json["apis"] = {api};
    a.json.erase("usageCounts");
    a.geometry().erase("usageCounts");
    spoil(a);
  });
}

/// One more usage count of the array, of nothing: only glTF forbids it.
MadeFile counted(const char* api, std::uint32_t level, std::uint32_t format,
                 const std::function<void(RawArray&)>& more = {}) {
  return raw([&](RawArray& a) {
    a.json["apis"] = {api};
    a.geometry().erase("usageCounts");
    a.json["usageCounts"].push_back({{"count", 0}, {"level", level}, {"format", format}});
    if (more) more(a);
  });
}

/// Two triangles on record 0, and one on record 1: the histograms differ.
void use_twice(RawArray& a) { a.json["apis"] = {"ext"}; }

/// 4-state alone, in a lossy build.
void lossy(RawArray& a) {
  a.json["lossy"] = true;
  a.records = {0, 0, 0, 0, 2, 0, 2, 0, 4, 0, 0, 0, 1, 0, 2, 0};
  if (a.json.contains("usageCounts")) a.json["usageCounts"][1]["format"] = 2;
}

MadeFile gltf(const std::function<void(micromap_file::Subject&)>& change, Draft draft = newest_draft) {
  micromap_file::Subject s;
  change(s);
  return {gltf_file(s.file, draft)};
}

MadeFile cut(ByteList bytes) {
  bytes.pop_back();
  return {bytes};
}
MadeFile with(ByteList bytes, std::size_t at, unsigned char value) {
  bytes[at] = value;
  return {bytes};
}

/// A container whose checksum is right although a byte of it is another; the sum is written anew.
MadeFile sealed(ByteList bytes, std::size_t at, unsigned char value, std::size_t crc_at, std::size_t header) {
  bytes[at] = value;
  const std::span<const std::uint8_t> all = bytes;
  const std::uint32_t crc =
      mmverify::impl::crc32c(all.subspan(header), mmverify::impl::crc32c(all.first(crc_at)));
  std::memcpy(bytes.data() + crc_at, &crc, 4);
  return {bytes};
}

std::vector<Case> alignments_and_strides() {
  return {
      {"align.data_256", plain("ext", [](RawArray& a) { a.json["data"]["address"] = 128; })},
      {"align.records_256", plain("ext", [](RawArray& a) { a.json["records"]["address"] = 128; })},
      {"align.data_128", plain("khr", [](RawArray& a) { a.json["data"]["address"] = 64; })},
      {"align.records_128", plain("khr", [](RawArray& a) { a.json["records"]["address"] = 64; })},
      {"align.records_4", plain("dxr", [](RawArray& a) { a.json["records"]["address"] = 2; })},
      {"align.index", plain("dxr", [](RawArray& a) { a.geometry()["indices"]["address"] = 1; })},
      {"align.index_ext", plain("ext", [](RawArray& a) { a.geometry()["indices"]["address"] = 1; })},
      {"stride.least", plain("ext", [](RawArray& a) { a.json["records"]["stride"] = 4; })},
      {"stride.multiple", plain("khr",
                                [](RawArray& a) {
                                  a.json["records"]["stride"] = 10;
                                  a.records.insert(a.records.begin() + 8, 2, 0);
                                })},
      {"stride.tight", plain("gltf",
                             [](RawArray& a) {
                               a.json["records"]["stride"] = 16;
                               a.records.insert(a.records.begin() + 8, 8, 0);
                             })},
  };
}

std::vector<Case> records() {
  return {
      {"records.size", plain("ext", [](RawArray& a) { a.json["records"]["count"] = 3; })},
      {"records.whole", plain("gltf", [](RawArray& a) { a.records.push_back(0); })},
      {"record.format", plain("ext", [](RawArray& a) { a.records[14] = 3; })},
      {"record.level", plain("ext", [](RawArray& a) { a.json["limits"]["fourStateLevel"] = 1; })},
      {"record.level_lossy", plain("khr",
                                   [](RawArray& a) {
                                     lossy(a);
                                     a.json["limits"]["lossyFourStateLevel"] = 1;
                                   })},
      {"record.level_12", plain("dxr",
                                [](RawArray& a) {
                                  a.records[4] = 13;
                                  a.data.resize(std::size_t{1} << 24);  // 4^13 states of 2 bits
                                })},
      {"record.lossy_format", plain("khr", [](RawArray& a) { a.json["lossy"] = true; })},
      {"record.region", plain("ext", [](RawArray& a) { a.data.pop_back(); })},
      {"record.overlap", plain("gltf", [](RawArray& a) { a.records[8] = 3; })},
  };
}

std::vector<Case> usage_counts() {
  return {
      {"counts.format", counted("dxr", 1, 3)},
      {"counts.level", counted("khr", 4, 2, [](RawArray& a) { a.json["limits"]["fourStateLevel"] = 3; })},
      {"counts.level_lossy", counted("khr", 4, 2,
                                     [](RawArray& a) {
                                       lossy(a);
                                       a.json["limits"]["lossyFourStateLevel"] = 3;
                                     })},
      {"counts.level_12", counted("dxr", 13, 2)},
      {"counts.lossy_format", counted("khr", 1, 1, lossy)},
      {"counts.zero", counted("gltf", 3, 2)},
      {"counts.limit", raw([](RawArray& a) {
         a.json["apis"] = {"khr"};
         a.json["limits"]["triangles"] = 1;
       })},
      {"counts.array", raw([](RawArray& a) { a.json["usageCounts"][0]["count"] = 7; })},
      {"counts.array_is_geometry", raw([](RawArray& a) {
         use_twice(a);
         a.json["usageCounts"] = a.geometry()["usageCounts"];
       })},
      {"counts.geometry", raw([](RawArray& a) {
         use_twice(a);
         a.geometry()["usageCounts"][0]["count"] = 7;
       })},
      {"counts.geometry_is_array", raw([](RawArray& a) {
         use_twice(a);
         a.geometry()["usageCounts"] = a.json["usageCounts"];
       })},
  };
}

std::vector<Case> indices() {
  return {
      {"index.encoding", plain("ext",
                               [](RawArray& a) {
                                 a.geometry()["indices"]["type"] = "u8";
                                 a.indices = {0, 1, 0xfe};
                               })},
      {"index.stride", plain("dxr",
                             [](RawArray& a) {
                               a.geometry()["indices"]["stride"] = 3;
                               a.indices.assign(8, 0);
                             })},
      {"index.stride_most", plain("ext",
                                  [](RawArray& a) {
                                    a.geometry()["indices"]["stride"] = 4294967296;
                                    a.geometry()["triangles"] = 1;
                                  })},
      {"index.tight", plain("gltf", [](RawArray& a) { a.geometry()["indices"]["stride"] = 0; })},
      {"index.size", plain("ext", [](RawArray& a) { a.indices.pop_back(); })},
      {"index.count", plain("gltf", [](RawArray& a) { a.geometry()["triangles"] = 2; })},
      {"index.special", plain("gltf",
                              [](RawArray& a) {
                                a.geometry()["indices"]["type"] = "i16";
                                a.indices[4] = 0xfb;
                                a.indices[5] = 0xff;
                              })},
      {"index.range", plain("ext", [](RawArray& a) { a.indices[2] = 2; })},
      {"index.uint8", plain("khr",
                            [](RawArray& a) {
                              a.geometry()["indices"]["type"] = "u8";
                              a.indices = {0, 1, 0};
                              a.json["limits"]["indexTypeUint8"] = false;
                            })},
      {"index.none", plain("khr",
                           [](RawArray& a) {
                             a.geometry()["triangles"] = 2;
                             a.geometry()["indices"]["type"] = "none";
                           })},
      {"index.none", plain("ext",
                           [](RawArray& a) {
                             a.geometry()["triangles"] = 2;
                             a.geometry()["indices"] = {{"type", "none"}, {"address", 64}};
                           })},
      {"index.mixed", plain("khr",
                            [](RawArray& a) {
                              a.indices = {0, 0, 1, 0, 0xfe, 0xff};
                              a.json["limits"]["disallowMixedSpecialIndex"] = true;
                            })},
      {"index.mixed_khr", plain("khr", [](RawArray& a) { a.indices = {0, 0, 1, 0, 0xfe, 0xff}; })},
  };
}

std::vector<Case> sidecars() {
  return {
      {"sidecar.readable", {as_bytes("{\"schema\": \"mmverify.array/1\", ")}},
      {"sidecar.readable",
       {as_bytes("{\"schema\": \"mmverify.array/1\", \"lossy\": true, \"lossy\": false}")}},
      {"sidecar.readable", {as_bytes("{\"a\": {\"b\": 1, \"c\": {}, \"b\": \"mmverify.array/1\"}}")}},
      {"sidecar.schema", raw([](RawArray& a) { a.json["schema"] = "mmverify.array/2"; })},
      {"sidecar.schema", raw([](RawArray& a) { a.json["schema"] = "mmverify.arrays/1"; })},
      {"sidecar.schema", raw([](RawArray& a) { a.json.erase("schema"); })},
      {"sidecar.schema", {as_bytes("{\"records\": {}}")}},
      {"sidecar.schema", {as_bytes("{\"schema\": 1, \"apis\": [\"ext\"]}")}},
      {"sidecar.missing", raw([](RawArray& a) { a.json.erase("data"); })},
      {"sidecar.missing", raw([](RawArray& a) { a.geometry().erase("triangles"); })},
      {"sidecar.unknown", raw([](RawArray& a) { a.json["indexes"] = 1; })},
      {"sidecar.unknown", raw([](RawArray& a) { a.geometry()["indices"]["strid"] = 2; })},
      {"sidecar.type", raw([](RawArray& a) { a.json["records"]["stride"] = "8"; })},
      {"sidecar.type", raw([](RawArray& a) { a.geometry()["baseTriangle"] = -1; })},
      {"sidecar.type", raw([](RawArray& a) { a.geometry()["indices"]["type"] = "u64"; })},
      {"sidecar.type", raw([](RawArray& a) { a.json["lossy"] = 1; })},
      {"sidecar.type", raw([](RawArray& a) { a.json["geometries"] = 1; })},
      {"sidecar.api", raw([](RawArray& a) { a.json["apis"] = {"metal"}; })},
      {"sidecar.api", raw([](RawArray& a) { a.json["apis"] = Json::array(); })},
      {"sidecar.path", raw([](RawArray& a) { a.json["data"]["file"] = "../data.bin"; })},
      {"sidecar.path", raw([](RawArray& a) { a.json["data"]["file"] = "/data.bin"; })},
      {"sidecar.path", raw([](RawArray& a) { a.json["data"]["file"] = "file:data.bin"; })},
      {"sidecar.path", raw([](RawArray& a) { a.json["data"]["file"] = "a//data.bin"; })},
      {"sidecar.file", raw([](RawArray& a) { a.json["data"]["file"] = "other.bin"; })},
      {"sidecar.range", raw([](RawArray& a) { a.json["data"]["offset"] = 6; })},
      {"sidecar.range", raw([](RawArray& a) { a.json["data"]["bytes"] = 6; })},
      {"sidecar.range", raw([](RawArray& a) {
         a.json["data"]["offset"] = 18446744073709551614u;
         a.json["data"]["bytes"] = 4;
       })},
  };
}

std::vector<Case> containers() {
  const ByteList one = array_file(1), two = array_file(2), tree = tree_file(false), dag = dag_file(),
                 attributes = attribute_file();
  std::vector<Case> all{
      {"container.version", with(two, 8, 3)},
      {"container.version", with(tree, 4, 2)},
      {"container.version", with(dag, 4, 2)},
      {"container.version", with(attributes, 4, 2)},
      {"container.header", with(two, 24, 5)},  // an encoding
      {"container.header", with(tree, 5, 13)},
      {"container.header", with(dag, 5, 3)},
      {"container.header", with(attributes, 7, 13)},
      {"container.checksum", with(two, two.size() - 5, 9)},
      {"container.checksum", with(tree, tree.size() - 1, static_cast<unsigned char>(tree.back() ^ 1))},
      {"container.checksum", with(dag, dag.size() - 1, static_cast<unsigned char>(dag.back() ^ 1))},
      {"container.checksum", with(attributes, attributes.size() - 1, 99)},
      {"container.content", sealed(tree, 16, static_cast<unsigned char>(tree[16] ^ 0x40), 12, 16)},
      {"container.content", sealed(dag, 33, 7, 28, 32)},
  };
  for (const ByteList& bytes : {one, two, tree, tree_file(true), dag, attributes}) {
    all.push_back({"container.size", cut(bytes)});
    ByteList longer = bytes;
    longer.push_back(0);
    all.push_back({"container.size", {longer}});
  }
  all.push_back({"container.size", {ByteList(two.begin(), two.begin() + 8)}});
  return all;
}

std::vector<Case> gltfs() {
  std::vector<Case> all;
  for (const micromap_file::Breach& breach : micromap_file::breaches())
    if (breach.plant) all.push_back({breach.rule, gltf(breach.plant)});
  const auto nothing = [](micromap_file::Subject&) {};
  all.push_back({"draft.name", gltf(nothing), Draft::khr});
  all.push_back({"draft.name", gltf(nothing, Draft::khr), Draft::ext_1});
  all.push_back({"file.no_micromaps", {as_bytes(square().glb())}});
  all.push_back({"file.readable", {as_bytes("{ \"asset\": ")}});
  all.push_back({"bake.stale", gltf([](micromap_file::Subject& s) {
                   Json& maps = s.file.json["meshes"][0]["primitives"][0]["extensions"];
                   maps.begin().value()["extras"]["mmverify_bake"] = {{"version", 1}, {"alphaCutoff", 0.75}};
                 })});
  all.push_back({"material.cutoff", gltf([](micromap_file::Subject& s) {
                   s.file.json["materials"].push_back({{"alphaMode", "MASK"}, {"alphaCutoff", 1.25}});
                 })});
  all.push_back({"primitive.same_geometry", gltf([](micromap_file::Subject& s) {
                   Json& primitives = s.file.json["meshes"][0]["primitives"];
                   Json other = primitives[0];
                   other.erase("extensions");
                   primitives.push_back(other);
                 })});
  return all;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const auto& some :
       {alignments_and_strides(), records(), usage_counts(), indices(), sidecars(), containers(), gltfs()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

std::string lines(const Judged& judged) { return micromap_file::lines(judged.findings); }

TEST(SceneIssues, StaleMapsThatMovedNameTheOption) {
  for (const bool moved : {false, true}) {
    const Judged judged = gltf([moved](micromap_file::Subject& s) {
                            Json record{{"version", 1}, {"alphaCutoff", 0.75}};
                            if (moved) record["moving"] = {0, 0, 1, 1, 0, 1, 0, 1, 1, 0};
                            Json& maps = s.file.json["meshes"][0]["primitives"][0]["extensions"];
                            maps.begin().value()["extras"]["mmverify_bake"] = record;
                          }).judged();
    ASSERT_EQ(judged.findings.size(), 1u) << lines(judged);
    EXPECT_EQ(judged.findings[0].found.ends_with("; the maps were baked with --moving"), moved)
        << judged.findings[0].found;
  }
}

TEST(SceneIssues, GoodFilesOfEveryKind) {
  const std::pair<FileKind, MadeFile> good[] = {
      {FileKind::sidecar, RawArray().file()},
      {FileKind::gltf, {gltf_file(micromap_file::good(), newest_draft)}},
      {FileKind::gltf, {gltf_file(micromap_file::good(), Draft::khr)}},
      {FileKind::array, {array_file(1)}},
      {FileKind::array, {array_file(2)}},
      {FileKind::tree, {tree_file(true)}},
      {FileKind::tree, {tree_file(false)}},
      {FileKind::dag, {dag_file()}},
      {FileKind::attributes, {attribute_file()}},
  };
  for (const auto& [kind, file] : good) {
    const Judged judged = file.judged();
    EXPECT_EQ(judged.kind, kind);
    EXPECT_TRUE(judged.findings.empty()) << name_of(kind) << lines(judged);
  }
}

TEST(SceneIssues, OneGeometryMayHaveMapsThatDifferInExtrasAlone) {
  const MadeFile file = gltf([](micromap_file::Subject& s) {
    Json& primitives = s.file.json["meshes"][0]["primitives"];
    Json other = primitives[0];
    other["extensions"].begin().value()["extras"]["note"] = "another";
    primitives.push_back(other);
  });
  EXPECT_EQ(lines(file.judged()), "");
}

// The files lie on disk, as a user has them.
TEST(SceneIssues, EachCodeHasAFileThatGivesItAlone) {
  std::set<std::string_view> given;
  for (const Case& one : cases()) {
    const Folder folder;
    GltfFile::write(folder / "made", {one.file.bytes.begin(), one.file.bytes.end()});
    for (const auto& [name, bytes] : one.file.beside)
      GltfFile::write(folder / name, {bytes.begin(), bytes.end()});
    const Judged judged = validate_file((folder / "made").string(), one.draft);
    ASSERT_FALSE(judged.findings.empty()) << one.code << " planted";
    for (const FileViolation& finding : judged.findings) EXPECT_EQ(finding.rule, one.code) << lines(judged);
    EXPECT_EQ(describe(judged.findings[0]).find('\n'), std::string::npos);
    // A file in memory has the same findings.
    EXPECT_EQ(one.file.judged(one.draft).findings.size(), judged.findings.size()) << one.code;
    given.insert(issue_of(one.code).code);
  }
  std::set<std::string_view> codes;
  for (const Issue& issue : issues()) EXPECT_TRUE(codes.insert(issue.code).second) << issue.code;
  if (!has_meshopt()) codes.erase("view.compressed");  // a build without the decoder cannot tell
  EXPECT_EQ(given, codes);
}

// JSON's -0 is 0; 2^64-1 is no number that is taken, and the words say so.
TEST(SceneIssues, NumbersAtTheEndsOfTheirRange) {
  const auto with_base = [](const std::string& number) {
    MadeFile file = RawArray().file();
    const std::string json(file.bytes.begin(), file.bytes.end()), zero = "\"baseTriangle\":0";
    const std::size_t at = json.find(zero);
    file.bytes = as_bytes(json.substr(0, at) + "\"baseTriangle\":" + number + json.substr(at + zero.size()));
    return file.judged();
  };
  EXPECT_TRUE(with_base("-0").findings.empty()) << lines(with_base("-0"));
  for (const char* number : {"-1", "4294967296", "0.5"}) {
    const Judged judged = with_base(number);
    ASSERT_EQ(judged.findings.size(), 1u) << lines(judged);
    EXPECT_EQ(judged.findings[0].found,
              "a whole number from 0, below 4294967296, is due, not " + std::string(number));
  }
  const Judged judged = raw([](RawArray& a) { a.json["data"]["offset"] = 18446744073709551615u; }).judged();
  ASSERT_EQ(judged.findings.size(), 1u) << lines(judged);
  EXPECT_EQ(judged.findings[0].found,
            "a whole number from 0, below 18446744073709551615, is due, not 18446744073709551615");
}

// Who writes one by hand, or with another program.
TEST(SceneIssues, ASidecarIsToldByItsMembers) {
  const auto kind = [](const std::string& json) { return MadeFile{as_bytes(json)}.judged().kind; };
  EXPECT_EQ(kind(R"({"schema": "mmverify.array\/1"})"), FileKind::sidecar);
  EXPECT_EQ(kind(R"({"apis": [)"), FileKind::sidecar);
  EXPECT_EQ(kind(R"({"asset": {"version": "2.0"}, "records": 1})"), FileKind::gltf);
  EXPECT_EQ(kind(R"({"records": 1, "asset": {"version": "2.0"}})"), FileKind::gltf);
  EXPECT_EQ(kind(R"({"extras": {"records": 1}})"), FileKind::gltf);
}

// The array is judged once and each geometry by itself; of each rule eight violations are kept.
TEST(SceneIssues, ListsTheFirstEightAndCountsTheRest) {
  constexpr std::size_t records = 20, triangles = 30;
  const MadeFile file = plain("gltf", [&](RawArray& a) {
    a.records.clear();
    // The first record has the last bytes: overlaps are found from the last record on.
    for (std::size_t r = 0; r < records; ++r) {
      const ByteList record{static_cast<unsigned char>(records - r), 0, 0, 0, 2, 0, 2, 0};
      a.records.insert(a.records.end(), record.begin(), record.end());
    }
    a.data.resize(records + 4);
    a.indices.assign(2 * triangles, 0x7f);
    a.geometry()["triangles"] = triangles;
    a.json["geometries"].push_back(a.geometry());
  });
  const Judged judged = file.judged();
  ASSERT_EQ(judged.findings.size(), 27u) << lines(judged);
  const auto expect = [&](std::size_t from, const char* rule, const char* pointer, const char* thing,
                          std::size_t all) {
    for (std::size_t k = 0; k < 9; ++k) {
      const FileViolation& finding = judged.findings[from + k];
      EXPECT_EQ(finding.rule, rule);
      EXPECT_EQ(finding.pointer, pointer);
      const std::string begins =
          k == 8 ? "and " + std::to_string(all - 8) + " more" : std::string(thing) + std::to_string(k) + ":";
      EXPECT_TRUE(finding.found.starts_with(begins)) << finding.found << " for " << begins;
    }
  };
  expect(0, "record.overlap", "/records", "record ", records - 1);  // all but the last, the first in the data
  expect(9, "index.range", "/geometries/0/indices", "triangle ", triangles);
  expect(18, "index.range", "/geometries/1/indices", "triangle ", triangles);
}

TEST(SceneIssues, EveryRuleIsAnIssue) {
  for (const auto& rule : mmverify::impl::micromap::rules) EXPECT_NO_THROW(issue_of(rule.id)) << rule.id;
  for (const FileRule& rule : file_rules()) EXPECT_NO_THROW(issue_of(rule.id)) << rule.id;
  for (const Issue& issue : issues()) {
    EXPECT_GT(issue.says.size(), 10u) << issue.code;
    EXPECT_GT(issue.source.size(), 3u) << issue.code;
    EXPECT_GT(std::string(issue.remedy).size(), 10u) << issue.code;
    EXPECT_EQ(std::string(issue.remedy).find('\n'), std::string::npos) << issue.code;
  }
  EXPECT_THROW(issue_of("no.such"), std::out_of_range);
}

// `./run tables` writes it.
TEST(SceneIssues, TheDocumentIsTheTable) {
  const std::string document = text_of(MMVERIFY_ISSUES);
  std::size_t from = 0;
  for (const Issue& issue : issues()) {
    const std::string row = "\n| `" + std::string(issue.code) + "` | " + name_of(issue.severity) + " | " +
                            issue.says + " | " + issue.source + " | " + issue.remedy + " |\n";
    const std::size_t at = document.find(row, from);
    ASSERT_NE(at, std::string::npos) << row;
    from = at + row.size() - 1;
  }
  EXPECT_GT(document.find("\n| `", from), document.find("<!-- end of table -->", from));
}

TEST(SceneIssues, FilesOfNoKind) {
  for (const std::string& bytes : {std::string("x"), std::string("[]"), std::string("  \n"),
                                   std::string("MMARRAY"), std::string("glT"), std::string("\xef\xbb\xbf")})
    EXPECT_THROW(MadeFile{as_bytes(bytes)}.judged(), BadScene) << bytes;
  EXPECT_THROW(validate_file("no/such/file"), BadScene);
  EXPECT_EQ(MadeFile{as_bytes(" \n{")}.judged().kind, FileKind::gltf);
}

// ---- The drafts

/// Compares each draft's finding about one file: a code, or nothing.
void expect_by_draft(const std::function<void(micromap_file::Subject&)>& change, const std::string& older,
                     const std::string& newest) {
  for (const Draft draft : {Draft::khr, Draft::ext_1, Draft::ext_2}) {
    const Judged judged = gltf(change, draft).judged(draft);
    const std::string& due = draft == newest_draft ? newest : older;
    EXPECT_EQ(judged.drafts, std::vector{draft});
    EXPECT_EQ(judged.findings.empty(), due.empty()) << text(draft).name << lines(judged);
    for (const FileViolation& finding : judged.findings)
      EXPECT_EQ(finding.rule, due) << text(draft).name << lines(judged);
  }
}

TEST(SceneDrafts, WhereTheyDiffer) {
  using micromap_file::Subject;
  // Records may lie apart, indices too.
  const auto apart = [](Subject& s) {
    const std::string old = s.file.bytes.substr(s.records_view()["byteOffset"].get<std::size_t>(), 16);
    s.micromap()["triangles"] = s.file.add_view(old.substr(0, 8) + "gap." + old.substr(8) + "gap.");
    s.records_view()["byteStride"] = 12;
    s.file.set_buffer_length();
  };
  const auto indices = [](Subject& s) {
    s.accessor()["bufferView"] = s.file.add_view(std::string("\1\0..\xfe\xff", 6));
    s.indices_view()["byteStride"] = 4;
    s.file.set_buffer_length();
  };
  for (const Draft draft : {Draft::khr, Draft::ext_1}) {
    EXPECT_TRUE(gltf(apart, draft).judged(draft).findings.empty()) << lines(gltf(apart, draft).judged(draft));
    EXPECT_TRUE(gltf(indices, draft).judged(draft).findings.empty())
        << lines(gltf(indices, draft).judged(draft));
    const auto outside = [&](Subject& s) {
      indices(s);
      s.file.bytes[s.indices_view()["byteOffset"].get<std::size_t>()] = 2;
    };
    EXPECT_EQ(gltf(outside, draft).judged(draft).findings.at(0).rule, "index.range");
    const auto all_one = [](Subject& s) { s.indices_view()["byteStride"] = 0; };
    EXPECT_EQ(gltf(all_one, draft).judged(draft).findings.at(0).rule, "index.stride");
  }
  // The newest reads the bytes as they lie.
  EXPECT_EQ(gltf(apart).judged().findings.at(0).rule, "view.stride");
  EXPECT_EQ(gltf(indices).judged().findings.at(0).rule, "view.stride");
  // Only the sum of the counts is asked.
  expect_by_draft([](Subject& s) { s.micromap()["usageLevels"] = {5, 6}; }, "", "counts.array");
  expect_by_draft([](Subject& s) { s.micromap()["usageCounts"] = {2, 1}; }, "counts.array", "counts.array");
  // No word on these.
  expect_by_draft([](Subject& s) { s.micromap()["name"] = 1; }, "", "micromap.name");
  expect_by_draft([](Subject& s) { s.accessor()["normalized"] = true; }, "", "indices.normalized");
  expect_by_draft([](Subject& s) { s.file.json["extensionsRequired"] = {micromap_file::name}; }, "",
                  "required.unlisted");
  // Levels have no end: the record's bytes have to be there all the same.
  const auto thirteen = [](Subject& s) {
    s.micromap()["usageLevels"][0] = 13;
    s.byte_of(s.records_view(), 12) = 13;
  };
  for (const Draft draft : {Draft::khr, Draft::ext_1}) {
    const Judged judged = gltf(thirteen, draft).judged(draft);
    ASSERT_EQ(judged.findings.size(), 1u) << lines(judged);
    EXPECT_EQ(judged.findings[0].rule, "record.region");
  }
}

TEST(SceneDrafts, StridesOfTheOlderOnes) {
  using micromap_file::Subject;
  const auto stride = [](int bytes) {
    return [bytes](Subject& s) { s.records_view()["byteStride"] = bytes; };
  };
  for (const Draft draft : {Draft::khr, Draft::ext_1}) {
    EXPECT_TRUE(gltf(stride(8), draft).judged(draft).findings.empty());
    EXPECT_EQ(gltf(stride(4), draft).judged(draft).findings.at(0).rule, "stride.least");
    EXPECT_EQ(gltf(stride(10), draft).judged(draft).findings.at(0).rule, "file.readable");  // glTF 2.0 itself
    EXPECT_EQ(gltf([](Subject& s) { s.records_view()["byteLength"] = 17; }, draft)
                  .judged(draft)
                  .findings.at(0)
                  .rule,
              "records.whole");
  }
}

// The name tells the draft; a file with both names is judged twice.
TEST(SceneDrafts, AreToldByTheName) {
  EXPECT_EQ(MadeFile{gltf_file(micromap_file::good(), Draft::khr)}.judged().drafts, std::vector{Draft::khr});
  EXPECT_EQ(MadeFile{gltf_file(micromap_file::good(), Draft::ext_1)}.judged().drafts,
            std::vector{Draft::ext_2});
  const MadeFile both = gltf([](micromap_file::Subject& s) {
    s.file.json["extensions"]["KHR_mesh_opacity_micromap"] = s.root();
    s.file.json["extensionsUsed"].push_back("KHR_mesh_opacity_micromap");
    s.file.json["extensions"]["KHR_mesh_opacity_micromap"]["micromaps"][0]["data"] = 99;
  });
  const Judged judged = both.judged();
  EXPECT_EQ(judged.drafts, (std::vector{Draft::ext_2, Draft::khr}));
  ASSERT_EQ(judged.findings.size(), 1u) << lines(judged);
  EXPECT_EQ(judged.findings[0].pointer, "/extensions/KHR_mesh_opacity_micromap/micromaps/0/data");
}

}  // namespace scene_issues_test
