// [sanitized, memory] The array validator: each rule broken by hand, both validators with one list; then what no sane file says.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include "fuzz/micromap_both.hpp"
#include "spec/micromap/array.hpp"

namespace impl_micromap_validate_test {

using namespace mmverify::spec::micromap;
using mmverify::fuzz::micromap::to_slow;
using mmverify::fuzz::micromap::validate_fast;
using enum State;
namespace fast = mmverify::impl::micromap;

constexpr std::uint64_t huge = std::numeric_limits<std::uint64_t>::max();

// An ArrayValidator lists the first violation of each rule, and all of usage counts; it counts the others.
void expect_counted(const fast::Input& in) {
  const fast::ArrayValidator validator(in, 1);
  fast::Violations is = validator.array();
  const fast::Violations of_geometry = validator.geometry(in);
  is.list.insert(is.list.end(), of_geometry.list.begin(), of_geometry.list.end());
  std::sort(is.list.begin(), is.list.end());
  is.more.insert(of_geometry.more.begin(), of_geometry.more.end());
  fast::Violations due;
  for (const fast::Violation& v : fast::validate(in)) {
    const bool of_count = v.place == fast::Place::array_count || v.place == fast::Place::geometry_count;
    if (of_count || due.list.empty() || due.list.back().rule != v.rule)
      due.list.push_back(v);
    else
      ++due.more[v.rule];
  }
  EXPECT_EQ(is.list, due.list);
  EXPECT_EQ(is.more, due.more);
}

// A clean array and geometry, ready to be spoilt.
struct Subject {
  Array array;
  Geometry geometry;
  std::vector<UsageCount> counts;
  Bytes records;
  Input in;

  // 4 triangles: a level-2 4-state map twice, a special index, a level-1 2-state map.
  explicit Subject(Sets sets, Encoding e = Encoding::u16) {
    States level2(16, T);
    level2[3] = UO;
    const Map a{2, Format::four_state, level2}, flat{2, Format::four_state, States(16, O)},
        b{1, Format::two_state, {T, O, O, T}};
    geometry = append(array, std::vector<Map>{a, flat, b, a}, {e, 0, true, true});
    counts = usage_counts(array_histogram(array.records));
    records = record_buffer(array.records);
    in.sets = sets;
    in.encoding = e;
    in.index_stride = width(e) / 8;
    in.indexed = true;
    in.triangles = 4;
    in.record_count = 2;
  }

  std::vector<Violation> found() {
    in.records = records;
    in.data = array.data;
    in.indices = geometry.indices;
    if (in.array_counts) in.array_counts = counts;
    if (in.geometry_counts) in.geometry_counts = geometry.counts;
    const auto got = validate(in);
    EXPECT_EQ(to_slow(validate_fast(in)), got);
    mmverify::fuzz::micromap::with_fast(in, expect_counted);
    return got;
  }

  Subject& counted() {
    in.array_counts.emplace();
    in.geometry_counts.emplace();
    return *this;
  }
  void set_record(std::size_t r, Record to) {
    array.records[r] = to;
    records = record_buffer(array.records);
  }
};

using Found = std::vector<Violation>;
constexpr Place whole = Place::whole, record = Place::record, triangle = Place::triangle,
                array_count = Place::array_count, geometry_count = Place::geometry_count,
                kind = Place::level_and_format;
constexpr std::uint64_t level(std::uint64_t n) { return n << 32; }

TEST(MicromapValidate, ACleanArrayIsClean) {
  for (const Sets sets : {EXT, KHR, DXR, glTF, Sets(EXT | KHR | DXR | glTF)})
    EXPECT_EQ(Subject(sets).counted().found(), Found{}) << int(sets);
  for (const Encoding e : encodings) EXPECT_EQ(Subject(glTF, e).counted().found(), Found{});
}

TEST(MicromapValidate, NothingAtAllIsClean) { EXPECT_EQ(validate(Input{}), Found{}); }

TEST(MicromapValidate, Addresses) {
  Subject s(all_sets);
  s.in.data_address = 128;
  s.in.records_address = 4;
  s.in.indices_address = 3;
  EXPECT_EQ(s.found(), (Found{{Rule::align_data_256, whole, 0, 128, 256},
                              {Rule::align_records_256, whole, 0, 4, 256},
                              {Rule::align_records_128, whole, 0, 4, 128},
                              {Rule::align_index, whole, 0, 3, 2}}));
  s.in.data_address = 64;
  s.in.records_address = 6;
  s.in.indices_address = 2;
  s.in.sets = DXR;
  EXPECT_EQ(s.found(),
            (Found{{Rule::align_data_128, whole, 0, 64, 128}, {Rule::align_records_4, whole, 0, 6, 4}}));
}

TEST(MicromapValidate, Strides) {
  Subject s(all_sets);
  s.in.record_stride = 7;
  EXPECT_EQ(s.found(), (Found{{Rule::stride_least, whole, 0, 7, 8},
                              {Rule::stride_multiple, whole, 0, 7, 4},
                              {Rule::stride_tight, whole, 0, 7, 8}}));
  s.in.record_stride = 12;  // the second record then ends at byte 20 of 20
  s.records.insert(s.records.begin() + 8, 4, 0xee);
  EXPECT_EQ(s.found(),
            (Found{{Rule::stride_tight, whole, 0, 12, 8}, {Rule::records_whole, whole, 0, 20, 8}}));
  s.in.sets = KHR;
  EXPECT_EQ(s.found(), Found{});
}

TEST(MicromapValidate, MissingRecords) {
  Subject s(KHR);
  s.counted();
  s.in.record_count = 3;
  EXPECT_EQ(s.found(), (Found{{Rule::records_size, record, 2, 16, 3}}));
  s.in.record_count = 2;
  s.records.pop_back();
  EXPECT_EQ(s.found(), (Found{{Rule::records_size, record, 1, 15, 2}}));
}

TEST(MicromapValidate, Formats) {
  Subject s(glTF);
  s.set_record(0, {0, 2, 0});
  s.set_record(1, {4, 1, 3});
  EXPECT_EQ(s.found(),
            (Found{{Rule::record_format, record, 0, 0, 2}, {Rule::record_format, record, 1, 3, 2}}));
}

TEST(MicromapValidate, LevelsAreLimitedByFormat) {
  Subject s(KHR);
  s.in.limits = {0, 1, 2, huge};
  EXPECT_EQ(s.found(), (Found{{Rule::record_level, record, 0, 2, 1}, {Rule::record_level, record, 1, 1, 0}}));
  s.in.limits = {1, 2, 0, huge};
  EXPECT_EQ(s.found(), Found{});
}

TEST(MicromapValidate, ALossyBuildHasALimitOfItsOwnAndNo2State) {
  Subject s(KHR);
  s.counted();
  s.in.lossy = true;
  s.in.limits = {12, 1, 2, huge};
  const Found two_state{{Rule::record_lossy_format, record, 1, 1, 2},
                        {Rule::counts_lossy_format, array_count, 0, 1, 2}};
  EXPECT_EQ(s.found(), two_state);
  s.in.limits = {12, 2, 1, huge};
  EXPECT_EQ(s.found(), (Found{{Rule::record_level_lossy, record, 0, 2, 1},
                              two_state[0],
                              {Rule::counts_level_lossy, array_count, 1, 2, 1},
                              two_state[1]}));
  // EXT knows no lossy builds: its limit stays.
  s.in.sets = EXT;
  s.in.limits = {12, 1, 9, huge};
  s.in.geometry_counts.reset();
  EXPECT_EQ(s.found(),
            (Found{{Rule::record_level, record, 0, 2, 1}, {Rule::counts_level, array_count, 1, 2, 1}}));
}

TEST(MicromapValidate, Level12IsTheLastForDxrAndGltf) {
  Subject s(DXR);
  s.in.triangles = 0;
  s.set_record(0, {0, 13, 2});
  s.array.data.assign(4, 0);
  s.set_record(1, {3, 1, 1});
  EXPECT_EQ(s.found(), (Found{{Rule::record_level_12, record, 0, 13, 12},
                              {Rule::record_region, record, 0, 16'777'216, 4}}));
}

TEST(MicromapValidate, RegionsBeyondTheEnd) {
  Subject s(DXR);
  s.set_record(1, {5, 1, 1});
  EXPECT_EQ(s.found(), (Found{{Rule::record_region, record, 1, 6, 5}}));
  s.set_record(1, {4'294'967'295, 1, 1});
  EXPECT_EQ(s.found(), (Found{{Rule::record_region, record, 1, 4'294'967'296, 5}}));
  s.set_record(1, {4, 65'535, 2});  // 4^65535 micro-triangles
  EXPECT_EQ(s.found(), (Found{{Rule::record_level_12, record, 1, 65'535, 12},
                              {Rule::record_region, record, 1, huge, 5}}));
}

TEST(MicromapValidate, OverlapsAreGltfsAlone) {
  Subject s(glTF);
  s.set_record(1, {3, 1, 1});
  EXPECT_EQ(s.found(), (Found{{Rule::record_overlap, record, 1, 0, 3}}));
  s.in.sets = EXT | KHR | DXR;
  EXPECT_EQ(s.found(), Found{});
}

TEST(MicromapValidate, EachOverlapIsListedWithTheFurthestReach) {
  Subject s(glTF);
  s.in.triangles = 0;
  s.in.indexed = false;
  s.array.data.assign(40, 0);
  // Regions 0: 8..12, 1: 0..16, 2: 4..8, 3: 16..20, 4: 19..23, 5: 0..16, 6: no format, no region.
  s.array.records = {{8, 2, 2}, {0, 3, 2}, {4, 2, 2}, {16, 2, 2}, {19, 2, 2}, {0, 3, 2}, {0, 3, 7}};
  s.records = record_buffer(s.array.records);
  s.in.record_count = 7;
  EXPECT_EQ(s.found(), (Found{{Rule::record_format, record, 6, 7, 2},
                              {Rule::record_overlap, record, 0, 1, 8},
                              {Rule::record_overlap, record, 2, 1, 4},
                              {Rule::record_overlap, record, 4, 3, 19},
                              {Rule::record_overlap, record, 5, 1, 0}}));
}

TEST(MicromapValidate, TouchingRegionsDoNotOverlap) {
  Subject s(glTF);
  s.in.triangles = 0;
  s.in.indexed = false;
  s.array.data.assign(8, 0);
  s.set_record(0, {4, 2, 2});
  s.set_record(1, {0, 2, 2});
  EXPECT_EQ(s.found(), Found{});
}

TEST(MicromapValidate, EntriesOfTheCounts) {
  Subject s(all_sets, Encoding::u16);
  s.counted();
  s.counts.push_back({0, 13, 3});
  s.geometry.counts.push_back({0, 1, 4});
  s.in.limits.two_state_level = 0;
  s.in.limits.triangles = 1;
  EXPECT_EQ(s.found(), (Found{{Rule::record_level, record, 1, 1, 0},
                              {Rule::counts_format, array_count, 2, 3, 2},
                              {Rule::counts_format, geometry_count, 2, 4, 2},
                              {Rule::counts_level, array_count, 0, 1, 0},
                              {Rule::counts_level, geometry_count, 0, 1, 0},
                              {Rule::counts_level_12, array_count, 2, 13, 12},
                              {Rule::counts_zero, array_count, 2, 0, 1},
                              {Rule::counts_limit, whole, 0, 2, 1}}));
}

TEST(MicromapValidate, TheWrongHistogramIsNamed) {
  const auto spoilt = [](const std::function<void(Subject&)>& spoil) {
    Subject s(EXT);
    s.counted();
    spoil(s);
    return s.found();
  };
  EXPECT_EQ(spoilt([](Subject& s) { s.counts[0].count = 5; }),
            (Found{{Rule::counts_array, kind, level(1) + 1, 5, 1}}));
  EXPECT_EQ(spoilt([](Subject& s) { s.geometry.counts[1].count = 3; }),
            (Found{{Rule::counts_geometry, kind, level(2) + 2, 3, 2}}));
  EXPECT_EQ(spoilt([](Subject& s) { s.counts[1].level = 3; }),
            (Found{{Rule::counts_array, kind, level(2) + 2, 0, 1},
                   {Rule::counts_array, kind, level(3) + 2, 1, 0}}));
  // Each taken for the other.
  EXPECT_EQ(spoilt([](Subject& s) { s.counts = s.geometry.counts; }),
            (Found{{Rule::counts_array, kind, level(2) + 2, 2, 1},
                   {Rule::counts_array_is_geometry, whole, 0, 0, 0}}));
  EXPECT_EQ(spoilt([](Subject& s) { s.geometry.counts = s.counts; }),
            (Found{{Rule::counts_geometry, kind, level(2) + 2, 1, 2},
                   {Rule::counts_geometry_is_array, whole, 0, 0, 0}}));
  EXPECT_EQ(spoilt([](Subject& s) { std::swap(s.geometry.counts, s.counts); }).size(), 4u);
  // Parts of one kind add up.
  EXPECT_EQ(spoilt([](Subject& s) {
              s.geometry.counts[1].count = 1;
              s.geometry.counts.push_back(s.geometry.counts[1]);
            }),
            Found{});
}

TEST(MicromapValidate, GeometryCountsAreExtsAlone) {
  Subject s(KHR | DXR | glTF);
  s.counted();
  s.geometry.counts = {{77, 9, 9}};
  EXPECT_EQ(s.found(), Found{});
}

TEST(MicromapValidate, IndexTypes) {
  const auto types = [](Sets sets) {
    std::set<int> refused;
    for (const Encoding e : encodings)
      for (const Violation& v : Subject(sets, e).found())
        if (v.rule == Rule::index_encoding) refused.insert(static_cast<int>(e));
    return refused;
  };
  EXPECT_EQ(types(EXT), (std::set<int>{0, 3, 4}));
  EXPECT_EQ(types(KHR), (std::set<int>{3, 4}));
  EXPECT_EQ(types(DXR), (std::set<int>{3, 4}));
  EXPECT_EQ(types(glTF), (std::set<int>{}));
}

TEST(MicromapValidate, IndexBuffers) {
  Subject s(glTF);
  s.geometry.indices.push_back(0);
  EXPECT_EQ(s.found(), Found{});  // half an index more is none
  s.geometry.indices.push_back(0);
  EXPECT_EQ(s.found(), (Found{{Rule::index_count, whole, 0, 5, 4}}));
  s.geometry.indices.resize(7);
  EXPECT_EQ(s.found(), (Found{{Rule::index_size, triangle, 3, 7, 4}}));
  Subject apart(all_sets);
  apart.in.triangles = 2;
  apart.in.index_stride = 3;
  EXPECT_EQ(apart.found(), (Found{{Rule::index_stride, whole, 0, 3, 2},
                                  {Rule::index_tight, whole, 0, 3, 2},
                                  {Rule::index_count, whole, 0, 4, 2},
                                  {Rule::index_range, triangle, 1, 511, 2}}));  // bytes 255, 1
}

TEST(MicromapValidate, AnIndexStrideHas32Bits) {
  Subject s(EXT);
  s.in.triangles = 1;
  s.in.index_stride = 4'294'967'294;
  EXPECT_EQ(s.found(), Found{});
  s.in.index_stride = 4'294'967'296;
  EXPECT_EQ(s.found(), (Found{{Rule::index_stride_most, whole, 0, 4'294'967'296, 4'294'967'295}}));
}

TEST(MicromapValidate, UnknownSpecialIndices) {
  Subject s(glTF, Encoding::i16);
  s.geometry.indices[2] = 0xfb;  // -5
  EXPECT_EQ(s.found(), (Found{{Rule::index_special, triangle, 1, 0xfffb, 4}}));
  Subject u(glTF, Encoding::u16);
  u.geometry.indices[2] = 0xfb;
  EXPECT_EQ(u.found(), (Found{{Rule::index_range, triangle, 1, 65'531, 2}}));
}

TEST(MicromapValidate, IndexPlusBaseIsLessThanTheNumberOfRecords) {
  Subject s(KHR);
  s.geometry.indices[0] = 1;
  EXPECT_EQ(s.found(), Found{});
  s.geometry.indices[0] = 2;  // as many as there are: one too many
  EXPECT_EQ(s.found(), (Found{{Rule::index_range, triangle, 0, 2, 2}}));
  s.geometry.indices[0] = 0;
  s.in.base_triangle = 1;
  EXPECT_EQ(s.found(), (Found{{Rule::index_range, triangle, 2, 2, 2}}));
  s.in.base_triangle = 4'294'967'295;
  EXPECT_EQ(s.found(), (Found{{Rule::index_range, triangle, 0, 4'294'967'295, 2},
                              {Rule::index_range, triangle, 2, 4'294'967'296, 2},
                              {Rule::index_range, triangle, 3, 4'294'967'295, 2}}));
}

TEST(MicromapValidate, WithoutIndicesEveryTriangleNamesItself) {
  Subject s(all_sets);
  s.counted();
  s.in.indexed = false;
  s.in.triangles = 2;
  s.geometry.counts = s.counts;
  EXPECT_EQ(s.found(), Found{});
  s.in.base_triangle = 1;
  EXPECT_EQ(s.found(), (Found{{Rule::index_range, triangle, 1, 2, 2}}));
  s.in.base_triangle = 9;
  EXPECT_EQ(s.found(), (Found{{Rule::index_range, triangle, 0, 9, 2}}));
}

TEST(MicromapValidate, AStrideOfZeroIsOneIndexForAll) {
  Subject s(EXT);
  s.counted();
  s.in.index_stride = 0;
  s.in.triangles = 1'000'000'000'000;
  s.geometry.counts = {{1, 2, 2}};
  EXPECT_EQ(s.found(), (Found{{Rule::counts_geometry, kind, level(2) + 2, 1, 1'000'000'000'000}}));
  s.geometry.indices[0] = 200;
  EXPECT_EQ(s.found(), (Found{{Rule::index_range, triangle, 0, 200, 2}}));
}

// ---- Numbers that no sane file has

TEST(MicromapValidate, AbsurdNumbersAreJudgedAtOnce) {
  for (const std::uint64_t count : {std::uint64_t{0}, std::uint64_t{1} << 32, std::uint64_t{1} << 63, huge})
    for (const std::uint64_t stride : {std::uint64_t{0}, std::uint64_t{8}, std::uint64_t{1} << 61, huge})
      for (const bool indexed : {false, true}) {
        Subject s(all_sets);
        s.counted();
        s.in.indexed = indexed;
        s.in.record_count = s.in.triangles = count;
        s.in.record_stride = s.in.index_stride = stride;
        s.in.base_triangle = 0xffffffff;
        s.counts.push_back({0xffffffff, 0xffffffff, 0xffffffff});
        s.geometry.counts.assign(3, {0xffffffff, 0xffffffff, 0});
        s.set_record(0, {0xffffffff, 0xffff, 2});
        EXPECT_FALSE(s.found().empty());
      }
}

TEST(MicromapValidate, EmptyBuffersAreNotRead) {
  Subject s(all_sets);
  s.counted();
  s.records.clear();
  s.array.data.clear();
  s.geometry.indices.clear();
  EXPECT_EQ(s.found(), (Found{{Rule::records_size, record, 0, 0, 2}, {Rule::index_size, triangle, 0, 0, 4}}));
}

// ---- The table

TEST(MicromapValidate, BothHaveTheSameRules) {
  static_assert(fast::rule_count == rule_count);
  std::set<std::string> ids;
  for (std::size_t k = 0; k < rule_count; ++k) {
    EXPECT_EQ(rules[k].rule, static_cast<Rule>(k));
    EXPECT_STREQ(fast::rules[k].id, rules[k].id);
    EXPECT_STREQ(fast::rules[k].says, rules[k].says);
    EXPECT_EQ(fast::rules[k].sets, rules[k].sets);
    EXPECT_FALSE(std::string(rules[k].source).empty());
    ids.insert(rules[k].id);
  }
  EXPECT_EQ(ids.size(), rule_count);
}

TEST(MicromapValidate, AViolationIsOneLine) {
  EXPECT_EQ(fast::describe({fast::Rule::record_overlap, fast::Place::record, 5, 3, 96}),
            "record.overlap (glTF): record 5: its first byte, 96, belongs to record 3");
  EXPECT_EQ(fast::describe({fast::Rule::counts_array, fast::Place::level_and_format, level(4) + 2, 7, 6}),
            "counts.array (EXT, KHR, DXR, glTF): level 4, format 2: the array's usage counts say 7, there "
            "are 6 records");
  EXPECT_EQ(fast::describe({fast::Rule::stride_least, fast::Place::whole, 0, 4, 8}),
            "stride.least (EXT, KHR, DXR, glTF): the stride is 4, not at least 8");
  for (std::size_t k = 0; k < rule_count; ++k) {
    const std::string line = fast::describe({static_cast<fast::Rule>(k), fast::Place::whole, 0, 1, 2});
    EXPECT_GT(line.size(), std::string(rules[k].id).size() + 2) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

}  // namespace impl_micromap_validate_test
