// scene/: files of every kind, spoilt 3,000 times with fixed seeds.  None makes validate_file() do anything but list
// findings or refuse the file, and none that a rule forbids passes.
//
// That a mutant breaks a rule is known without the library under test: the change by hand names the rule, the checksum
// finds every byte that changed, the header says how long a file is, or the specification of arrays judges the bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>

#include "spec/array/container.hpp"
#include "spec/micromap/array.hpp"
#include "spec/micromap/validate.hpp"
#include "tests/scene/array_files.hpp"

namespace scene_validate_mutants_test {

using namespace mmverify::scene;
using namespace mmverify::tests;
namespace micromap_file = mmverify::tests::micromap_file;
namespace spec = mmverify::spec;

/// Whether an error was found, or the file refused.  Any other exception ends the test.
bool passes(const MadeFile& file, std::optional<Draft> draft = {}) {
  try {
    return file.judged(draft).count(Severity::error) == 0;
  } catch (const BadScene&) {
    return false;
  }
}

class SceneValidateMutants : public testing::Test {
 protected:
  void TearDown() override {
    RecordProperty("mutants", std::to_string(mutants_));
    RecordProperty("forbidden", std::to_string(forbidden_));
  }

  std::uint64_t below(std::uint64_t end) { return random_() % end; }
  unsigned char other_byte(unsigned char than) { return static_cast<unsigned char>(than ^ (1 + below(255))); }
  void flip(ByteList& bytes, std::uint64_t at) { bytes.at(at) = other_byte(bytes[at]); }
  ByteList shortened(ByteList bytes) {
    bytes.resize(static_cast<std::size_t>(below(bytes.size())));
    return bytes;
  }

  /// A mutant that must not pass.
  void forbidden(const MadeFile& file, const std::string& why, std::optional<Draft> draft = {}) {
    ++mutants_;
    ++forbidden_;
    EXPECT_FALSE(passes(file, draft)) << why;
  }
  /// One of which another judge says whether it may pass.
  void judged(const MadeFile& file, bool clean, const std::string& why, std::optional<Draft> draft = {}) {
    ++mutants_;
    forbidden_ += clean ? 0 : 1;
    EXPECT_EQ(passes(file, draft), clean) << why << micromap_file::lines(file.judged(draft).findings);
  }
  /// One of which nothing is known but that it does not crash.
  void any(const MadeFile& file, std::optional<Draft> draft = {}) {
    ++mutants_;
    passes(file, draft);
  }

  std::mt19937_64 random_{24};
  std::size_t mutants_ = 0, forbidden_ = 0;
};

// ---- The specification's verdict on bytes

/// An array and its geometries, for the specification's validator.
bool clean(spec::micromap::Input array, const std::vector<spec::micromap::Input>& geometries) {
  if (!spec::micromap::validate(array).empty()) return false;
  return std::all_of(geometries.begin(), geometries.end(), [&](spec::micromap::Input in) {
    in.sets = array.sets;
    in.records = array.records;
    in.record_count = array.record_count;
    in.data = array.data;
    in.records_address = array.records_address;
    in.data_address = array.data_address;
    return spec::micromap::validate(in).empty();
  });
}

bool clean(const spec::array::Bundle& bundle) {
  const auto records = spec::micromap::record_buffer(bundle.array.records);
  spec::micromap::Input array;
  array.sets = spec::micromap::glTF;
  array.records = records;
  array.record_count = bundle.array.records.size();
  array.data = bundle.array.data;
  std::vector<spec::micromap::Input> geometries;
  for (const spec::array::Part& part : bundle.parts) {
    spec::micromap::Input& in = geometries.emplace_back();
    in.indexed = true;
    in.encoding = part.encoding;
    in.index_stride = spec::micromap::width(part.encoding) / 8;
    in.indices = part.indices;
    in.triangles = spec::array::triangles(part);
    in.base_triangle = part.base;
  }
  return clean(array, geometries);
}

bool clean(const RawArray& raw, spec::micromap::Sets sets) {
  const std::vector<spec::micromap::UsageCount> counts{{1, 2, 2}, {1, 1, 1}},
      of_geometry{{2, 2, 2}, {1, 1, 1}};
  spec::micromap::Input array;
  array.sets = sets;
  array.records = raw.records;
  array.record_count = raw.records.size() / 8;
  array.records_address = 512;
  array.data = raw.data;
  array.data_address = 256;
  array.array_counts = counts;
  spec::micromap::Input in;
  in.triangles = 3;
  in.indexed = true;
  in.encoding = spec::micromap::Encoding::u16;
  in.index_stride = 2;
  in.indices = raw.indices;
  in.indices_address = 64;
  in.geometry_counts = of_geometry;
  return clean(array, {in});
}

/// The two primitives of micromap_file::good().
bool clean(micromap_file::Subject& s) {
  const auto view = [&](Json& json) {
    const auto bytes = as_bytes(s.file.bytes);
    const auto from = bytes.begin() + json["byteOffset"].get<std::ptrdiff_t>();
    return ByteList(from, from + json["byteLength"].get<std::ptrdiff_t>());
  };
  const ByteList records = view(s.records_view()), data = view(s.data_view()),
                 indices = view(s.indices_view());
  const std::vector<spec::micromap::UsageCount> counts{{1, 1, 1}, {1, 2, 2}};
  spec::micromap::Input array;
  array.sets = spec::micromap::glTF;
  array.records = records;
  array.record_count = 2;
  array.data = data;
  array.array_counts = counts;
  spec::micromap::Input first, second;
  first.triangles = 2;
  first.indexed = true;
  first.encoding = spec::micromap::Encoding::i16;
  first.index_stride = 2;
  first.indices = indices;
  second.triangles = 1;
  second.base_triangle = 1;
  return clean(array, {first, second});
}

// ---- glTF

/// The rules that the newest draft alone forbids, or only advises against.
bool of_all_drafts(const std::string& rule) {
  static const std::set<std::string> newest{"view.stride", "micromap.name", "indices.normalized",
                                            "required.unlisted"};
  return !newest.contains(rule);
}

// Each breach by hand, in each draft, among other changes that break nothing.
TEST_F(SceneValidateMutants, GltfWithABreachByHand) {
  for (int round = 0; round < 6; ++round)
    for (const micromap_file::Breach& breach : micromap_file::breaches())
      for (const Draft draft : {Draft::khr, Draft::ext_1, Draft::ext_2}) {
        if (!breach.plant || issue_of(breach.rule).severity != Severity::error) continue;
        if (draft != newest_draft && !of_all_drafts(breach.rule)) continue;
        micromap_file::Subject s;
        for (std::uint64_t k = below(4); k > 0; --k)
          s.byte_of(s.data_view(), static_cast<std::size_t>(below(5))) = static_cast<char>(below(256));
        if (below(2) == 0) s.micromap()["extras"] = below(1000);
        breach.plant(s);
        forbidden({gltf_file(s.file, draft)}, breach.rule + std::string(" in ") + text(draft).name, draft);
      }
  EXPECT_GE(forbidden_, 600u);
}

// Bytes of data, records and indices: the specification's validator judges them.
TEST_F(SceneValidateMutants, GltfWithOtherBytes) {
  for (int k = 0; k < 500; ++k) {
    micromap_file::Subject s;
    Json* const views[] = {&s.data_view(), &s.records_view(), &s.indices_view()};
    for (std::uint64_t flips = 1 + below(2); flips > 0; --flips) {
      Json& view = *views[below(3)];
      char& byte = s.byte_of(view, static_cast<std::size_t>(below(view["byteLength"].get<std::uint64_t>())));
      byte = static_cast<char>(other_byte(static_cast<unsigned char>(byte)));
    }
    judged({gltf_file(s.file, newest_draft)}, clean(s), "mutant " + std::to_string(k));
  }
  EXPECT_GE(forbidden_, 100u);
  EXPECT_LT(forbidden_, mutants_);
}

// A GLB says how long it is.  Bytes of its JSON: whatever they are.
TEST_F(SceneValidateMutants, GltfCutAndSpoilt) {
  const ByteList whole = gltf_file(micromap_file::good(), newest_draft);
  for (int k = 0; k < 150; ++k) forbidden({shortened(whole)}, "cut, mutant " + std::to_string(k));
  for (int k = 0; k < 350; ++k) {
    ByteList bytes = whole;
    for (std::uint64_t flips = 1 + below(3); flips > 0; --flips) flip(bytes, below(bytes.size()));
    any({bytes});
  }
  EXPECT_EQ(mutants_, 500u);
}

// ---- Sidecars

TEST_F(SceneValidateMutants, SidecarsWithOtherBytes) {
  constexpr std::pair<const char*, spec::micromap::Sets> apis[] = {{"ext", spec::micromap::EXT},
                                                                   {"khr", spec::micromap::KHR},
                                                                   {"dxr", spec::micromap::DXR},
                                                                   {"gltf", spec::micromap::glTF}};
  for (int k = 0; k < 500; ++k) {
    RawArray raw;
    const auto& [name, sets] = apis[below(4)];
    raw.json["apis"] = {name};
    ByteList* const buffers[] = {&raw.records, &raw.data, &raw.indices};
    ByteList& buffer = *buffers[below(3)];
    if (below(4) == 0)
      buffer = shortened(buffer);
    else
      flip(buffer, below(buffer.size()));
    if (raw.records.size() / 8 != 2) {
      // Records that are not there are not in the number that is taken from the file: the counts say it.
      forbidden(raw.file(), "records cut");
      continue;
    }
    judged(raw.file(), clean(raw, sets), std::string(name) + ", mutant " + std::to_string(k));
  }
  EXPECT_GE(forbidden_, 100u);
  EXPECT_LT(forbidden_, mutants_);
}

/// Every place in a JSON value.
void places(const Json& json, const Json::json_pointer& at, std::vector<Json::json_pointer>& all) {
  all.push_back(at);
  if (json.is_object())
    for (const auto& [key, value] : json.items()) places(value, at / key, all);
  if (json.is_array())
    for (std::size_t k = 0; k < json.size(); ++k) places(json[k], at / k, all);
}

// docs/array.schema.json forbids each: another type, a member that is missing, one too many.
TEST_F(SceneValidateMutants, SidecarsThatTheSchemaForbids) {
  const Json whole = RawArray().json;
  const Json schema = Json::parse(std::ifstream(MMVERIFY_ARRAY_SCHEMA));
  std::vector<Json::json_pointer> all;
  places(whole, Json::json_pointer(), all);
  all.erase(all.begin());
  const auto spoilt = [](const std::function<void(Json&)>& change) {
    RawArray raw;
    change(raw.json);
    return raw.file();
  };
  const Json others[] = {1.5, "text", Json::array(), Json::object(), true, -1};
  for (const auto& at : all)
    for (const Json& other : others) {
      const Json& is = whole[at];
      // A value of the same type may be valid, so it is skipped; -1 and 1.5 are wrong for every number here.
      if (other.type() == is.type() && !other.is_number()) continue;
      if (other.is_string() && at.back() == "file") continue;
      forbidden(spoilt([&](Json& json) { json[at] = other; }), at.to_string() + " = " + other.dump());
    }
  const auto without = [&](const Json::json_pointer& parent, const Json& names) {
    for (const Json& name : names)
      forbidden(spoilt([&](Json& json) { json[parent].erase(name.get<std::string>()); }),
                parent.to_string() + " without " + name.dump());
  };
  const Json& members = schema["properties"];
  without(Json::json_pointer(), schema["required"]);
  without(Json::json_pointer("/records"), members["records"]["required"]);
  without(Json::json_pointer("/data"), members["data"]["required"]);
  without(Json::json_pointer("/geometries/0"), members["geometries"]["items"]["required"]);
  without(Json::json_pointer("/usageCounts/0"), schema["$defs"]["usageCounts"]["items"]["required"]);
  without(Json::json_pointer("/geometries/0/indices"),
          members["geometries"]["items"]["properties"]["indices"]["anyOf"][1]["required"]);
  for (const auto& at : all)
    if (whole[at].is_object())
      forbidden(spoilt([&](Json& json) { json[at]["stranger"] = 1; }), at.to_string() + " with a stranger");
  EXPECT_EQ(forbidden_, mutants_);
  EXPECT_GE(mutants_, 150u);
}

TEST_F(SceneValidateMutants, SidecarsCutAndSpoilt) {
  const MadeFile whole = RawArray().file();
  std::vector<Json::json_pointer> all;
  places(RawArray().json, Json::json_pointer(), all);
  for (int k = 0; k < 100; ++k) forbidden({shortened(whole.bytes), whole.beside}, "cut: no JSON");
  for (int k = 0; k < 200; ++k) {
    MadeFile file = whole;
    flip(file.bytes, below(file.bytes.size()));
    any(file);
  }
  // Numbers of all sizes.
  for (int k = 0; k < 200; ++k) {
    RawArray raw;
    for (std::uint64_t changes = 1 + below(3); changes > 0; --changes) {
      Json& value = raw.json[all[static_cast<std::size_t>(below(all.size()))]];
      if (value.is_number()) value = random_() >> below(64);
    }
    any(raw.file());
  }
}

// ---- Containers

// A checksum finds every change within four bytes; a header says how long its file is.
TEST_F(SceneValidateMutants, SealedContainers) {
  for (const ByteList& whole :
       {array_file(2), tree_file(true), tree_file(false), dag_file(), attribute_file()}) {
    for (int k = 0; k < 90; ++k) {
      ByteList bytes = whole;
      const std::uint64_t at = below(bytes.size());
      flip(bytes, at);
      if (below(3) == 0 && at + 1 < bytes.size()) flip(bytes, at + 1);
      forbidden({bytes}, "byte " + std::to_string(at) + " of " + std::to_string(bytes.size()));
    }
    for (int k = 0; k < 30; ++k) forbidden({shortened(whole)}, "cut");
    for (int k = 0; k < 10; ++k) {
      ByteList bytes = whole;
      for (std::uint64_t more = 1 + below(9); more > 0; --more)
        bytes.push_back(static_cast<unsigned char>(below(256)));
      forbidden({bytes}, "longer");
    }
  }
  EXPECT_EQ(mutants_, 650u);
}

// Version 1 of an array file has no checksum: the specification reads it and judges what it says.
TEST_F(SceneValidateMutants, ArrayFilesWithoutAChecksum) {
  const ByteList whole = array_file(1);
  for (int k = 0; k < 400; ++k) {
    ByteList bytes = whole;
    flip(bytes, 8 + below(bytes.size() - 8));
    if (below(8) == 0) bytes = shortened(bytes);
    if (bytes.size() < 8) bytes = ByteList(whole.begin(), whole.begin() + 8);
    const auto bundle = spec::array::read(bytes);
    judged({bytes}, bundle && clean(*bundle), "mutant " + std::to_string(k));
  }
  EXPECT_GE(forbidden_, 100u);
  EXPECT_LT(forbidden_, mutants_);
}

}  // namespace scene_validate_mutants_test
