// The vectors of arrays, held against the library's validator and, as files, against mmverify validate's.
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "impl/micromap/validate.hpp"
#include "scene/validate/file.hpp"
#include "scene/validate/issues.hpp"
#include "tests/vectors/reading.hpp"

namespace vectors_arrays_test {

using namespace mmverify;
using tests::Reading;
using vectors::Bytes;
using Json = nlohmann::json;
namespace micromap = impl::micromap;

const Reading& builds() {
  static const Reading all(tests::family("arrays"), "builds");
  return all;
}

std::vector<micromap::UsageCount> counts_of(std::size_t k, const char* column) {
  std::vector<micromap::UsageCount> counts;
  const auto words = builds().word_list(k, column);
  for (std::size_t at = 0; at < words.size(); at += 3)
    counts.push_back({words[at], words[at + 1], words[at + 2]});
  return counts;
}

/// The names of the codes, from the column that says them.
const std::vector<std::string>& names() { return tests::family("arrays").tables[0].columns.back().names; }

std::set<std::string> codes_of(std::size_t k) {
  std::set<std::string> codes;
  for (std::size_t c = 0; c < names().size(); ++c)
    if ((builds().wide(k, "codes") >> c & 1) != 0) codes.insert(names()[c]);
  return codes;
}

TEST(VectorsArrays, TheGreatestLimitIsNotNone) {
  std::map<vectors::Optional, std::size_t> limits;
  for (std::size_t k = 0; k < builds().size(); ++k) ++limits[builds().optional(k, "limit_maps")];
  EXPECT_EQ(limits[0xffffffffu], 1u);
  EXPECT_GT(limits[vectors::none], 10u);
}

TEST(VectorsArrays, CodesAreThoseOfTheLibrary) {
  for (std::size_t k = 0; k < builds().size(); ++k) {
    const Bytes records = builds().part(k, "records"), data = builds().part(k, "data"),
                indices = builds().part(k, "indices");
    const auto counts = counts_of(k, "counts"), geometry = counts_of(k, "geometry_counts");
    micromap::Input in;
    in.sets = static_cast<micromap::Sets>(builds().wide(k, "apis"));
    in.limits = {builds()(k, "limit_two"), builds()(k, "limit_four"), builds()(k, "limit_lossy")};
    if (const auto limit = builds().optional(k, "limit_maps")) in.limits.triangles = *limit;
    in.lossy = builds()(k, "lossy") != 0;
    in.records = records;
    in.record_count = builds()(k, "record_count");
    in.record_stride = builds().wide(k, "record_stride");
    in.records_address = builds().wide(k, "records_address");
    in.data = data;
    in.data_address = builds().wide(k, "data_address");
    if (builds()(k, "counted") != 0) in.array_counts = counts;
    in.triangles = builds()(k, "triangles");
    in.indexed = builds()(k, "indexed") != 0;
    in.indices = indices;
    in.encoding = micromap::Encoding(builds()(k, "encoding"));
    in.index_stride = builds().wide(k, "index_stride");
    in.indices_address = builds().wide(k, "indices_address");
    in.base_triangle = builds()(k, "base");
    if (builds()(k, "geometry_counted") != 0) in.geometry_counts = geometry;
    std::set<std::string> found;
    for (const micromap::Violation& v : micromap::validate(in)) found.insert(micromap::text(v.rule).id);
    EXPECT_EQ(found, codes_of(k)) << k << ' ' << builds().about(k);
  }
}

Json counts_json(std::size_t k, const char* column) {
  Json list = Json::array();
  for (const auto& c : counts_of(k, column))
    list.push_back({{"count", c.count}, {"level", c.level}, {"format", c.format}});
  return list;
}

/// The vector as a sidecar, with the buffers beside it.
scene::Judged judged_as_files(std::size_t k) {
  const Reading& r = builds();
  Json apis = Json::array();
  constexpr const char* api_names[] = {"ext", "khr", "dxr", "gltf"};
  for (unsigned a = 0; a < 4; ++a)
    if ((r.wide(k, "apis") >> a & 1) != 0) apis.push_back(api_names[a]);
  Json file{{"schema", "mmverify.array/1"},
            {"apis", apis},
            {"records",
             {{"file", "records"},
              {"address", r.wide(k, "records_address")},
              {"stride", r.wide(k, "record_stride")},
              {"count", r(k, "record_count")}}},
            {"data", {{"file", "data"}, {"address", r.wide(k, "data_address")}}},
            {"limits",
             {{"twoStateLevel", r(k, "limit_two")},
              {"fourStateLevel", r(k, "limit_four")},
              {"lossyFourStateLevel", r(k, "limit_lossy")}}},
            {"lossy", r(k, "lossy") != 0}};
  if (const auto limit = r.optional(k, "limit_maps")) file["limits"]["triangles"] = *limit;
  if (r(k, "counted") != 0) file["usageCounts"] = counts_json(k, "counts");
  if (r(k, "triangles") != 0) {
    constexpr const char* types[] = {"u8", "u16", "u32", "i16", "i32"};
    Json geometry{{"triangles", r(k, "triangles")}, {"baseTriangle", r(k, "base")}, {"indices", nullptr}};
    if (r(k, "indexed") != 0)
      geometry["indices"] = {{"file", "indices"},
                             {"type", types[r(k, "encoding")]},
                             {"address", r.wide(k, "indices_address")},
                             {"stride", r.wide(k, "index_stride")}};
    if (r(k, "geometry_counted") != 0) geometry["usageCounts"] = counts_json(k, "geometry_counts");
    file["geometries"] = {geometry};
  }
  const std::string text = file.dump();
  return scene::validate_file("made", {reinterpret_cast<const unsigned char*>(text.data()), text.size()}, {},
                              [&](const std::string& name) { return r.part(k, name); });
}

TEST(VectorsArrays, CodesAreThoseOfMmverifyValidate) {
  for (std::size_t k = 0; k < builds().size(); ++k) {
    std::set<std::string> found;
    for (const scene::FileViolation& finding : judged_as_files(k).findings) {
      const scene::Issue& issue = scene::issue_of(finding.rule);
      if (issue.severity == scene::Severity::error) found.emplace(issue.code);
    }
    std::set<std::string> wanted = codes_of(k);
    // One histogram handed over for the other is one finding there.
    if (wanted.contains("counts.array_is_geometry")) wanted.erase("counts.array");
    if (wanted.contains("counts.geometry_is_array")) wanted.erase("counts.geometry");
    EXPECT_EQ(found, wanted) << k << ' ' << builds().about(k);
  }
}

TEST(VectorsArrays, EachCodeHasAVectorOfItsOwn) {
  std::set<std::string> all, well;
  for (std::size_t k = 0; k < builds().size(); ++k) {
    const std::string about = builds().about(k);
    if (about.starts_with("well")) {
      EXPECT_TRUE(codes_of(k).empty()) << about;
      well.insert(about);
      continue;
    }
    const std::string code = about.substr(0, about.find(':'));
    EXPECT_TRUE(codes_of(k).contains(code)) << about;
    EXPECT_NO_THROW(scene::issue_of(code)) << code;
    all.insert(code);
  }
  EXPECT_EQ(all, std::set<std::string>(names().begin(), names().end()));
  EXPECT_GT(well.size(), 10u);
}

}  // namespace vectors_arrays_test
