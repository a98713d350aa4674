// scene/edit/: what is changed in a file, and that the rest of it stays.
#include <gtest/gtest.h>

#ifdef MMVERIFY_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include "proofs/engine/random.hpp"
#include "scene/edit/edited_file.hpp"
#include "scene/edit/json_patch.hpp"
#include "scene/edit/map_edits.hpp"
#include "scene/edit/record_sizes.hpp"
#include "scene/edit/rules.hpp"
#include "scene/validate/suspect_record.hpp"
#include "tests/folder.hpp"
#include "tests/scene/micromap_breaches.hpp"

namespace mmverify::tests {
namespace {

using namespace mmverify::scene;
using namespace mmverify::tests::micromap_file;

std::string patched(const std::string& text, const std::function<void(Json&)>& change) {
  const Json was = Json::parse(text);
  Json is = was;
  change(is);
  const std::string out = patched_json(text, was, is);
  EXPECT_EQ(Json::parse(out), is) << out;
  return out;
}

TEST(PatchedJson, KeepsWhatIsEqual) {
  const std::string text = " { \"a\" : 1.50 ,\n\t\"b\":[1 , 2e0,{\"c\":\"\\u00e9 \\\" ]\"}] }\n";
  EXPECT_EQ(patched(text, [](Json&) {}), text);
}

TEST(PatchedJson, ReplacesANumberAlone) {
  EXPECT_EQ(patched("{ \"a\": 1.50, \"b\": [1, 20, 3 ] }", [](Json& j) { j["b"][1] = 7; }),
            "{ \"a\": 1.50, \"b\": [1, 7, 3 ] }");
}

TEST(PatchedJson, AddsBehindTheLast) {
  EXPECT_EQ(patched("{\n  \"a\": [\n    1,\n    2\n  ]\n}",
                    [](Json& j) {
                      j["a"].push_back(3);
                      j["z"] = true;
                    }),
            "{\n  \"a\": [\n    1,\n    2,\n    3\n  ],\n  \"z\":true\n}");
  EXPECT_EQ(patched("{\"a\":[],\"b\":{}}",
                    [](Json& j) {
                      j["a"].push_back(3);
                      j["b"]["c"] = nullptr;
                    }),
            "{\"a\":[3],\"b\":{\"c\":null}}");
}

TEST(PatchedJson, TakesMembersAndElementsOut) {
  EXPECT_EQ(patched("{\"a\": 1, \"b\": 2, \"c\": 3}", [](Json& j) { j.erase("b"); }), "{\"a\": 1, \"c\": 3}");
  EXPECT_EQ(patched("{\"a\": 1, \"b\": 2}", [](Json& j) { j.erase("a"); }), "{ \"b\": 2}");
  EXPECT_EQ(patched("[\"x\", 1.0, \"y\"]", [](Json& j) { j.erase(0); }), "[ 1.0, \"y\"]");
  EXPECT_EQ(patched("[\"x\", 1.0]", [](Json& j) { j = Json::array(); }), "[]");
}

TEST(PatchedJson, ReadsEscapedNames) {
  EXPECT_EQ(patched("{\"\\u0061\\\\\": 1, \"}\": 2}", [](Json& j) { j["}"] = 3; }),
            "{\"\\u0061\\\\\": 1, \"}\": 3}");
}

TEST(PatchedJson, RefusesAnotherText) {
  EXPECT_THROW(patched_json("[1,2", Json{1, 2}, Json{1, 3}), std::invalid_argument);
  EXPECT_THROW(patched_json("[1]", Json{1, 2}, Json{1, 3}), std::invalid_argument);
}

/// A random value, at most so deep.
Json random_json(proofs::Random& random, int depth) {
  const auto kind = random.below(depth == 0 ? 4 : 6);
  if (kind == 0) return random.below(9);
  if (kind == 1) return std::string("a\"}],{\\ b").substr(0, random.below(10));
  if (kind == 2) return random.below(2) == 0 ? Json(nullptr) : Json(0.5);
  if (kind == 3) return -1.5e30;
  Json all = kind == 4 ? Json::array() : Json::object();
  for (auto k = random.below(5); k != 0; --k)
    if (kind == 4)
      all.push_back(random_json(random, depth - 1));
    else
      all["m\"" + std::to_string(random.below(4))] = random_json(random, depth - 1);
  return all;
}

/// Changes a random part of a value.
void change_somewhere(Json& value, proofs::Random& random) {
  if (value.is_structured() && !value.empty() && random.below(4) != 0) {
    auto at = value.begin();
    std::advance(at, static_cast<std::ptrdiff_t>(random.below(value.size())));
    if (random.below(4) == 0)
      value.erase(at);
    else
      change_somewhere(*at, random);
    return;
  }
  if (value.is_array())
    value.insert(value.begin() + static_cast<std::ptrdiff_t>(random.below(value.size() + 1)), 7);
  else if (value.is_object())
    value["new"] = {1, 2};
  else
    value = random_json(random, 1);
}

TEST(PatchedJson, RandomChangesOfRandomTexts) {
  proofs::Random random(11, 0, 0);
  for (int round = 0; round < 5000; ++round) {
    const Json was = random_json(random, 4);
    Json is = was;
    for (auto k = random.below(4); k != 0; --k) change_somewhere(is, random);
    const std::string mark = random.below(8) == 0 ? "\xef\xbb\xbf" : "";
    const std::string text = mark + was.dump(static_cast<int>(random.below(4)) - 1) + "\n";
    const std::string out = patched_json(text, was, is);
    ASSERT_EQ(Json::parse(out), is) << text << out;
    ASSERT_TRUE(was != is || out == text) << text << out;
  }
}

/// A file on disk.
class OnDisk {
 public:
  explicit OnDisk(const std::string& bytes, const std::string& name = "f.glb")
      : path_((folder_ / name).string()) {
    GltfFile::write(path_, bytes);
  }
  EditedFile opened() const { return EditedFile(path_); }

 private:
  Folder folder_;
  std::string path_;
};

TEST(EditedFile, StaysAsItIs) {
  const std::string glb = Subject().file.glb();
  const OnDisk disk(glb);
  EditedFile file = disk.opened();
  EXPECT_FALSE(file.is_changed());
  EXPECT_EQ(file.written().bytes, as_bytes(glb));
}

TEST(EditedFile, ChangesOneByteInPlace) {
  Subject s;
  const std::string glb = s.file.glb();
  const OnDisk disk(glb);
  EditedFile file = disk.opened();
  const auto view = s.micromap()["data"].get<std::size_t>();
  const unsigned char byte = static_cast<unsigned char>(file.view(view)[2] ^ 0xff);
  ASSERT_TRUE(file.is_alone(view, 0, file.view(view).size()));
  file.overwrite(view, 2, {&byte, 1});
  const Bytes after = file.written().bytes;
  ASSERT_EQ(after.size(), glb.size());
  std::size_t differing = 0;
  for (std::size_t k = 0; k < after.size(); ++k) differing += after[k] != static_cast<unsigned char>(glb[k]);
  EXPECT_EQ(differing, 1u);
}

TEST(EditedFile, KnowsWhoReadsBytes) {
  Subject s;
  const auto data = s.micromap()["data"].get<std::size_t>();
  s.file.json["bufferViews"].push_back(s.data_view());  // nobody reads it
  EXPECT_TRUE(OnDisk(s.file.glb()).opened().is_alone(data, 0, 1));
  s.file.add("accessors", {{"bufferView", s.file.json["bufferViews"].size() - 1},
                           {"componentType", 5121},
                           {"count", 2},
                           {"type", "SCALAR"}});
  EXPECT_FALSE(OnDisk(s.file.glb()).opened().is_alone(data, 0, 6));
  EXPECT_TRUE(OnDisk(s.file.glb()).opened().is_alone(data, 2, 4)) << "the accessor has two bytes";
  s.file.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {
      {"buffer", 0}, {"byteOffset", s.data_view()["byteOffset"]}, {"byteLength", 5}};
  EXPECT_FALSE(OnDisk(s.file.glb()).opened().is_alone(data, 2, 4));
}

TEST(EditedFile, GrowsItsBuffer) {
  Subject s;
  const OnDisk disk(s.file.glb());
  EditedFile file = disk.opened();
  const auto view = s.micromap()["data"].get<std::size_t>();
  Bytes bytes(file.view(view).begin(), file.view(view).end());
  bytes.push_back(0x5a);
  file.replace(view, bytes);
  const WrittenFile written = file.written();
  const GltfFile after = taken_apart(written.bytes);
  EXPECT_EQ(after.bytes.substr(0, s.file.bytes.size()), s.file.bytes);
  EXPECT_TRUE(validate_micromaps("f.glb", written.bytes).empty())
      << lines(validate_micromaps("f.glb", written.bytes));
  EXPECT_EQ(after.json["bufferViews"][view]["byteLength"], bytes.size());
}

TEST(EditedFile, WritesDataUrisAndFilesOfBuffers) {
  Subject s;
  for (const bool in_file : {false, true}) {
    GltfFile source = s.file;
    Json text = Json::parse(source.gltf_with_data_uri());
    Folder folder;
    if (in_file) {
      text["buffers"][0]["uri"] = "b.bin";
      GltfFile::write(folder / "b.bin", source.bytes);
    }
    GltfFile::write(folder / "f.gltf", text.dump(2));
    EditedFile file((folder / "f.gltf").string());
    const unsigned char byte = 0;
    file.overwrite(s.micromap()["data"].get<std::size_t>(), 0, {&byte, 1});
    const WrittenFile written = file.written();
    EXPECT_EQ(written.buffers.size(), in_file ? 1u : 0u);
    const Document document = file.reopened(written);
    const Buffers buffers(document);
    std::string wanted = source.bytes;
    wanted[s.data_view()["byteOffset"].get<std::size_t>()] = 0;
    EXPECT_EQ(std::string(buffers.all()[0].begin(), buffers.all()[0].end()), wanted);
    if (!in_file) continue;
    EXPECT_EQ(std::string(written.bytes.begin(), written.bytes.end()), text.dump(2));
  }
}

/// The findings that are left, and what was done, by rule.
std::vector<std::string> done(const std::string& glb, std::size_t left = 0) {
  const OnDisk disk(glb);
  EditedFile file = disk.opened();
  const RepairedRules repaired = repair_rules(file);
  EXPECT_EQ(repaired.left.size(), left) << lines(repaired.left);
  std::vector<std::string> rules;
  for (const RuleRepair& one : repaired.repairs) rules.push_back(one.rule);
  if (left == 0) {
    const auto found = validate_micromaps("f.glb", file.written().bytes);
    EXPECT_TRUE(found.empty()) << lines(found);
  }
  return rules;
}

// Rules whose breach leaves data that say what is right.
TEST(RepairedRules, EachBreachThatDataSayHowToMend) {
  const std::set<std::string> mended{
      "used.listed",   "required.unlisted", "micromap.name",      "view.stride",
      "usage.array",   "usage.integer",     "usage.length",       "counts.zero",
      "counts.array",  "records.whole",     "primitive.micromap", "primitive.base",
      "index.special", "index.range",       "indices.normalized", "align.index"};
  std::set<std::string> seen;
  for (const Breach& breach : breaches()) {
    if (!breach.plant || !mended.contains(breach.rule)) continue;
    SCOPED_TRACE(breach.rule);
    seen.insert(breach.rule);
    Subject s;
    breach.plant(s);
    const std::vector<std::string> rules = done(s.file.glb());
    ASSERT_FALSE(rules.empty());
    EXPECT_EQ(rules[0], breach.rule);
  }
  EXPECT_EQ(seen, mended);
}

TEST(RepairedRules, OthersAreLeft) {
  Subject s;
  s.byte_of(s.records_view(), 12) = 13;
  done(s.file.glb(), 4);
}

TEST(RepairedRules, ViewsThatWereRenumberedAreFound) {
  Subject s;
  const Json data = s.micromap()["data"], records = s.micromap()["triangles"];
  s.micromap()["data"] = 0;
  s.micromap()["triangles"] = 1;
  const OnDisk disk(s.file.glb());
  EditedFile file = disk.opened();
  const RepairedRules repaired = repair_rules(file);
  EXPECT_TRUE(repaired.left.empty()) << lines(repaired.left);
  EXPECT_EQ(file.json["extensions"][name]["micromaps"][0]["data"], data);
  EXPECT_EQ(file.json["extensions"][name]["micromaps"][0]["triangles"], records);
}

TEST(RepairedRules, TouchesNothingElse) {
  Subject s;
  const std::string before = s.file.bytes;
  s.micromap()["usageCounts"] = {1, 2};
  s.file.json["extras"] = {{"kept", 1.0}};
  const OnDisk disk(s.file.glb());
  EditedFile file = disk.opened();
  repair_rules(file);
  Json wanted = s.file.json;
  wanted["extensions"][name]["micromaps"][0]["usageCounts"] = {1, 1};
  const GltfFile after = taken_apart(file.written().bytes);
  EXPECT_EQ(after.json, wanted);
  EXPECT_EQ(after.bytes.substr(0, before.size()), before);
}

/// Two triangles on one record each want another map.
// Bytes of a map: 4^n / 8 in 2-state, 4^n / 4 in 4-state.
TEST(RecordSizes, AreTheBytesUpToTheNextMap) {
  using Records = std::vector<impl::micromap::Record>;
  const Records right{{0, 3, 2}, {24, 4, 1}, {16, 3, 1}};  // 16, 32 and 8 bytes
  EXPECT_EQ(sized_by_gaps(right, 56), right);
  for (std::size_t k = 0; k < right.size(); ++k)
    for (const std::uint16_t wrong : std::initializer_list<std::uint16_t>{0, 2, 5, 12, 13, 200}) {
      Records level = right, format = right;
      level[k].level = wrong;
      format[k].format = wrong == 2 ? static_cast<std::uint16_t>(3 - right[k].format) : wrong;
      EXPECT_EQ(sized_by_gaps(level, 56), right) << k << " " << wrong;
      EXPECT_EQ(sized_by_gaps(format, 56), right) << k << " " << wrong;
    }
}

TEST(RecordSizes, RefuseGapsThatNoMapOrSeveralFill) {
  using Records = std::vector<impl::micromap::Record>;
  EXPECT_FALSE(sized_by_gaps({{0, 5, 2}}, 24));  // no map has 24 bytes
  EXPECT_FALSE(sized_by_gaps({{0, 5, 2}}, 1));   // three have one byte
  EXPECT_EQ(sized_by_gaps({{0, 1, 1}}, 1), (Records{{0, 1, 1}}));
  EXPECT_FALSE(sized_by_gaps({{8, 3, 1}}, 16));             // bytes before the first map
  EXPECT_FALSE(sized_by_gaps({{0, 3, 1}, {0, 3, 1}}, 16));  // one place for two
  EXPECT_FALSE(sized_by_gaps({{0, 3, 1}, {16, 3, 1}}, 8));  // behind the data
  EXPECT_FALSE(sized_by_gaps({}, 0));
}

/// The suspect of an array of 16, 32 and 8 bytes of data, whose usage counts are those of `counted`.
std::string suspect(const std::vector<impl::micromap::Record>& records,
                    const std::optional<std::vector<impl::micromap::UsageCount>>& counts) {
  const std::vector<std::uint8_t> bytes = impl::micromap::record_buffer(records), data(56);
  impl::micromap::Input in;
  in.records = bytes;
  in.record_count = records.size();
  in.data = data;
  if (counts) in.array_counts = *counts;
  return suspect_record(in);
}

TEST(SuspectRecord, IsTheOneWhoseBytesAnotherLevelFills) {
  const std::vector<impl::micromap::Record> right{{0, 3, 2}, {24, 4, 1}, {16, 3, 1}};
  const std::vector<impl::micromap::UsageCount> counts{{1, 3, 2}, {1, 4, 1}, {1, 3, 1}};
  EXPECT_EQ(suspect(right, counts), "");
  auto overlapping = right, beyond = right, gap = right, moved = right, format = right, two = right;
  overlapping[0].level = 5;
  EXPECT_EQ(suspect(overlapping, counts),
            "suspect: record 0: it says level 5 in 4-state (256 bytes), and has the 16 bytes of level 3 in "
            "4-state");
  EXPECT_EQ(suspect(overlapping, {}), suspect(overlapping, counts));
  beyond[1].level = 6;
  EXPECT_EQ(suspect(beyond, counts),
            "suspect: record 1: it says level 6 in 2-state (512 bytes), and has the 32 bytes of level 4 in "
            "2-state");
  gap[0].level = 2;
  EXPECT_EQ(
      suspect(gap, counts),
      "suspect: record 0: it says level 2 in 4-state (4 bytes), and has the 16 bytes of level 3 in 4-state");
  EXPECT_EQ(suspect(gap, {}), "") << "a gap breaks no rule";
  EXPECT_EQ(suspect(gap, {{{1, 2, 2}, {1, 4, 1}, {1, 3, 1}}}), "") << "the counts say that the gap is meant";
  format[0].format = 7;
  EXPECT_EQ(suspect(format, counts),
            "suspect: record 0: it says format 7, and has the 16 bytes of level 3 in 4-state");
  two[0].level = two[2].level = 5;
  EXPECT_NE(suspect(two, counts).find("; and 1 more such record"), std::string::npos);
  moved[1].offset = 20;
  EXPECT_EQ(suspect(moved, counts), "") << "its offset is wrong";
  auto elsewhere = right;
  elsewhere[2].offset = 8;  // other levels would fill these gaps, too
  EXPECT_EQ(suspect(elsewhere, {}), "") << "its levels fill the data, so its offset is wrong";
}

TEST(SuspectRecord, IsNamedByTheValidatorOnce) {
  Subject s;
  const auto named = [&] {
    const std::string text = s.file.glb();
    const Bytes bytes(text.begin(), text.end());
    std::size_t count = 0;
    for (const FileViolation& one : validate_micromaps("f.glb", bytes))
      count += one.found.find("suspect: record 0: it says level 9") != std::string::npos ? 1 : 0;
    return count;
  };
  EXPECT_EQ(named(), 0u);
  s.byte_of(s.records_view(), 4) = 9;
  EXPECT_EQ(named(), 1u);
}

TEST(WrittenMaps, ASharedRecordGetsASecondOne) {
  Subject s;
  GltfFile& file = s.file;
  // Both triangles of primitive 0 have record 0.
  for (std::size_t k = 0; k < 4; ++k)
    s.byte_of(s.indices_view(), s.accessor().value("byteOffset", std::size_t{0}) + k) = 0;
  const OnDisk disk(file.glb());
  EditedFile edited = disk.opened();
  BakedTriangle map;
  map.level = 2;
  map.format = impl::micromap::Format::four_state;
  map.map = impl::micromap::Bytes{1, 2, 3, 4};
  write_maps(edited, {map}, {{0, 0, 1, 0}});
  const Bytes written = edited.written().bytes;
  EXPECT_TRUE(validate_micromaps("f.glb", written).empty()) << lines(validate_micromaps("f.glb", written));
  const GltfFile after = taken_apart(written);
  Subject t;
  t.file = after;
  EXPECT_EQ(t.records_view()["byteLength"], 24);
  EXPECT_EQ(t.data_view()["byteLength"], 9);
  EXPECT_EQ(t.byte_of(t.indices_view(), 0), 0);
  EXPECT_EQ(t.byte_of(t.indices_view(), 2), 2);
}

TEST(WrittenMaps, ALoneRecordIsOverwritten) {
  Subject s;
  const OnDisk disk(s.file.glb());
  EditedFile edited = disk.opened();
  BakedTriangle map;
  map.level = 1;
  map.format = impl::micromap::Format::two_state;
  map.map = impl::micromap::Bytes{0x0a};
  // Record 1 is that of triangle 0 of primitive 0, and of primitive 1.
  write_maps(edited, {map}, {{0, 0, 0, 0}, {0, 1, 0, 0}});
  const GltfFile after = taken_apart(edited.written().bytes);
  EXPECT_EQ(after.json, s.file.json);
  std::string wanted = s.file.bytes;
  wanted[s.data_view()["byteOffset"].get<std::size_t>() + 4] = 0x0a;
  EXPECT_EQ(after.bytes.substr(0, wanted.size()), wanted);
}

#ifdef MMVERIFY_HAS_MESHOPT

/// Compresses the view of the records, two of 8 bytes.
void compress_records(Subject& s) {
  const std::string records = s.file.bytes.substr(s.records_view()["byteOffset"].get<std::size_t>(), 16);
  std::string code(meshopt_encodeVertexBufferBound(2, 8), '\0');
  code.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(code.data()), code.size(),
                                         records.data(), 2, 8));
  compress(s.file, s.records_view(), code);
  s.records_view()["byteLength"] = 16;
  s.records_view()["extensions"]["EXT_meshopt_compression"]["byteStride"] = 8;
}

// Changes of a compressed view are stored plain; its code, and all else, stays.
TEST(WrittenMaps, RecordsInACompressedViewBecomePlain) {
  Subject plain, s;
  compress_records(s);
  BakedTriangle map;
  map.level = 2;
  map.format = impl::micromap::Format::four_state;
  map.map = impl::micromap::Bytes{1, 2, 3, 4};
  const auto edited = [&](const GltfFile& file) {
    const OnDisk disk(file.glb());
    EditedFile opened = disk.opened();
    write_maps(opened, {map}, {{0, 0, 0, 0}});
    const Bytes written = opened.written().bytes;
    EXPECT_TRUE(validate_micromaps("f.glb", written).empty()) << lines(validate_micromaps("f.glb", written));
    Subject after;
    after.file = taken_apart(written);
    // The triangle's index is another: all else is as it was.
    const auto index = after.indices_view()["byteOffset"].get<std::size_t>();
    EXPECT_EQ(after.file.bytes.substr(0, index), file.bytes.substr(0, index));
    EXPECT_EQ(after.file.bytes.substr(index + 4, file.bytes.size() - index - 4),
              file.bytes.substr(index + 4));
    return after;
  };
  Subject was = edited(plain.file), is = edited(s.file);
  EXPECT_FALSE(is.records_view().contains("extensions"));
  EXPECT_EQ(is.records_view()["byteLength"], 24);
  const auto records = [](Subject& one) {
    return one.file.bytes.substr(one.records_view()["byteOffset"].get<std::size_t>(), 24);
  };
  EXPECT_EQ(records(is), records(was));
  const auto changed = s.micromap()["triangles"].get<std::size_t>();
  for (std::size_t view = 0; view < s.file.json["bufferViews"].size(); ++view)
    EXPECT_TRUE(view == changed || view == s.micromap()["data"].get<std::size_t>() ||
                is.file.json["bufferViews"][view] == s.file.json["bufferViews"][view])
        << view;
}

TEST(RepairedRules, CountsOfCompressedRecords) {
  Subject s;
  compress_records(s);
  const std::string code = s.file.bytes;
  s.micromap()["usageCounts"] = {1, 2};
  const OnDisk disk(s.file.glb());
  EditedFile file = disk.opened();
  EXPECT_TRUE(repair_rules(file).left.empty());
  EXPECT_EQ(file.json["extensions"][name]["micromaps"][0]["usageCounts"], Json({1, 1}));
  EXPECT_TRUE(file.is_compressed(s.micromap()["triangles"].get<std::size_t>())) << "no record changed";
  EXPECT_EQ(taken_apart(file.written().bytes).bytes.substr(0, code.size()), code);
}

#endif

TEST(WrittenMaps, APrimitiveWithoutIndicesGetsThem) {
  Subject s;
  const OnDisk disk(s.file.glb());
  EditedFile edited = disk.opened();
  BakedTriangle map;
  map.level = 1;
  map.format = impl::micromap::Format::four_state;
  map.map = impl::micromap::Bytes{0xe4};
  write_maps(edited, {map}, {{0, 1, 0, 0}});  // its record is that of primitive 0, too
  const Bytes written = edited.written().bytes;
  EXPECT_TRUE(validate_micromaps("f.glb", written).empty()) << lines(validate_micromaps("f.glb", written));
  Subject t;
  t.file = taken_apart(written);
  const Json& accessor = t.file.json["accessors"][t.extension(1)["micromapIndices"].get<std::size_t>()];
  EXPECT_EQ(accessor["componentType"], 5125);
  EXPECT_EQ(accessor["count"], 1);
  EXPECT_EQ(t.byte_of(t.view_of(accessor["bufferView"]), 0), 1) << "record 2 from base triangle 1";
  EXPECT_EQ(t.micromap()["usageCounts"], (Json{1, 1, 1}));
}

TEST(WrittenMaps, CodesThatANarrowTypeCannotHoldGetAWiderOne) {
  Subject s;
  // 8 bits, and records up to 252, which 8 bits name no more.
  std::string records, data(4 + 252, '\0');
  for (std::uint32_t k = 0; k < 252; ++k)
    records += little_endian(k == 0 ? 0 : 3 + k) + std::string(k == 0 ? "\2\0\2\0" : "\1\0\1\0", 4);
  s.micromap()["data"] = s.file.add_view(data);
  s.micromap()["triangles"] = s.file.add_view(records);
  s.micromap()["usageCounts"] = {1, 251};
  s.micromap()["usageLevels"] = {2, 1};
  s.micromap()["usageFormats"] = {2, 1};
  s.accessor()["componentType"] = 5121;
  s.file.set_buffer_length();
  s.byte_of(s.indices_view(), 0) = 0;
  s.byte_of(s.indices_view(), 1) = '\xfe';
  ASSERT_TRUE(s.found().empty()) << lines(s.found());
  const OnDisk disk(s.file.glb());
  EditedFile edited = disk.opened();
  BakedTriangle map;
  map.level = 1;
  map.format = impl::micromap::Format::four_state;
  map.map = impl::micromap::Bytes{0xe4};
  write_maps(edited, {map}, {{0, 0, 0, 0}, {0, 1, 0, 0}});
  const Bytes written = edited.written().bytes;
  EXPECT_TRUE(validate_micromaps("f.glb", written).empty()) << lines(validate_micromaps("f.glb", written));
  map.map = impl::micromap::Bytes{0x1b};
  EditedFile again = disk.opened();
  write_maps(again, {map, map}, {{0, 0, 1, 0}});
  Subject t;
  t.file = taken_apart(again.written().bytes);
  EXPECT_TRUE(t.found().empty()) << lines(t.found());
  EXPECT_EQ(t.accessor()["componentType"], 5123);
  EXPECT_EQ(t.byte_of(t.indices_view(), 0), 0);
  EXPECT_EQ(t.byte_of(t.indices_view(), 2), '\xfc') << "record 252";
  EXPECT_EQ(t.byte_of(t.indices_view(), 3), 0);
}

TEST(WrittenMaps, AUniformMapIsASpecialIndex) {
  Subject s;
  const OnDisk disk(s.file.glb());
  EditedFile edited = disk.opened();
  BakedTriangle map;
  map.uniform = impl::micromap::State::T;
  write_maps(edited, {map}, {{0, 0, 0, 0}});
  Subject t;
  t.file = taken_apart(edited.written().bytes);
  EXPECT_EQ(t.byte_of(t.indices_view(), 0), '\xff');
  EXPECT_EQ(t.byte_of(t.indices_view(), 1), '\xff');
  EXPECT_EQ(t.file.json, s.file.json);
}

}  // namespace
}  // namespace mmverify::tests
