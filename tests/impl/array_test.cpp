// [memory] impl/array: arrays worked out by hand, errors, and files beside the bytes that docs/ARRAYS.md has.
#include <gtest/gtest.h>

#include <string>

#include "impl/array/build.hpp"
#include "impl/array/change.hpp"
#include "impl/array/container.hpp"
#include "spec/array/api.hpp"
#include "tests/complaint.hpp"

namespace impl_array_test {

using namespace mmverify::impl::array;
using mmverify::impl::micromap::Record;

PackedMap four(Level level, const Bytes& bytes) { return {level, Format::four_state, bytes}; }
PackedMap two(Level level, const Bytes& bytes) { return {level, Format::two_state, bytes}; }

template <class Call>
std::string message_of(Call call) {
  return mmverify::tests::complaint_of([&] { call(); }, "nothing");
}

TEST(Array, IsBuiltAsWorkedOutByHand) {
  // T O UT UO; all O; 0110 in 2-state; the first again.
  const Bytes mixed{0xe4}, opaque{0x55}, band{0x06};
  const Built b = build({}, std::vector{four(1, mixed), four(1, opaque), two(1, band), four(1, mixed)},
                        {.api = Api::EXT, .encoding = Encoding::u16});
  EXPECT_EQ(b.array.data, (Bytes{0xe4, 0x06}));
  ASSERT_EQ(b.array.records.size(), 2u);
  EXPECT_EQ(b.array.records[0], (Record{0, 1, 2}));
  EXPECT_EQ(b.array.records[1], (Record{1, 1, 1}));
  EXPECT_EQ(b.part.indices, (Bytes{0, 0, 0xfe, 0xff, 1, 0, 0, 0}));
  // One record each, and two references to the first.
  EXPECT_EQ(b.array_counts, (std::vector<UsageCount>{{1, 1, 1}, {1, 1, 2}}));
  EXPECT_EQ(b.geometry_counts, (std::vector<UsageCount>{{1, 1, 1}, {2, 1, 2}}));
}

TEST(Array, MergesKnownIntoUnknownWithinTheBound) {
  // TTTT but for one O; the same but for another O: they differ in two places.
  const Bytes first{0x01}, second{0x04};
  const std::vector maps{four(1, first), four(1, second)};
  const Built apart = build({}, maps, {.encoding = Encoding::u8, .bound = 1});
  EXPECT_EQ(apart.array.records.size(), 2u);
  const Built together = build({}, maps, {.encoding = Encoding::u8, .bound = 2});
  EXPECT_EQ(together.array.data, (Bytes{0x0f}));  // UO UO T T
  EXPECT_EQ(together.part.indices, (Bytes{0, 0}));
  // UT beside UO: neither may become the other.
  const Bytes ut{0x02}, uo{0x03};
  EXPECT_EQ(build({}, std::vector{four(1, ut), four(1, uo)}, {.encoding = Encoding::u8, .bound = 4})
                .array.records.size(),
            2u);
  // 2-state has no unknown state.
  EXPECT_EQ(build({}, std::vector{two(1, first), two(1, Bytes{0x03})}, {.encoding = Encoding::u8, .bound = 4})
                .array.records.size(),
            2u);
}

TEST(Array, RecordsBeforeAreNeverMergedInto) {
  const Bytes first{0x01}, near{0x05};
  const Built b =
      build(std::vector{four(1, first)}, std::vector{four(1, near)}, {.encoding = Encoding::u8, .bound = 4});
  EXPECT_EQ(b.array.data, (Bytes{0x01, 0x05}));
  EXPECT_EQ(b.part.indices, (Bytes{1}));
}

TEST(Array, RefusesWhatItsDomainLeavesOut) {
  const Bytes one{0x01};
  const auto built = [&](const std::vector<PackedMap>& maps, const BuildOptions& o) {
    return message_of([&] { build({}, maps, o); });
  };
  EXPECT_EQ(built({}, {.api = Api::EXT, .encoding = Encoding::u8}),
            "array::build: indices that the API does not take");
  EXPECT_EQ(built({}, {.base = 1}), "array::build: a base triangle beyond the records before");
  EXPECT_EQ(built({four(13, one)}, {}), "array::build: map 0: not 4^level states of a level up to 12");
  EXPECT_EQ(built({four(2, one)}, {.bound = 1}),
            "array::build: map 0: not 4^level states of a level up to 12");
  // 252 indices in 8 bits.
  std::vector<Bytes> bytes;
  for (unsigned k = 0; k < 253; ++k) bytes.push_back({0x1b, static_cast<std::uint8_t>(k), 0, 0});
  std::vector<PackedMap> maps;
  for (const Bytes& b : bytes) maps.push_back(four(2, b));
  EXPECT_EQ(built(std::vector(maps.begin(), maps.end() - 1), {.encoding = Encoding::u8}), "nothing");
  EXPECT_NE(built(maps, {.encoding = Encoding::u8, .share = false}).find("triangle 252: index 252"),
            std::string::npos);
}

TEST(Array, ApisAreTheSpecifications) {
  namespace slow = mmverify::spec::array;
  for (const slow::Api api : slow::apis) {
    const auto& right = slow::requirements(api);
    const auto& ours = requirements(static_cast<Api>(api));
    EXPECT_STREQ(ours.name, right.name);
    EXPECT_EQ(ours.counts_geometry, right.counts_geometry) << right.name;
    EXPECT_EQ(ours.data_alignment, right.data_alignment) << right.name;
    EXPECT_EQ(ours.records_alignment, right.records_alignment) << right.name;
    EXPECT_EQ(ours.stride_multiple, right.stride_multiple) << right.name;
    EXPECT_EQ(ours.clusters, right.clusters) << right.name;
    for (const auto e : mmverify::spec::micromap::encodings)
      EXPECT_EQ(takes(static_cast<Api>(api), static_cast<Encoding>(e)), slow::takes(api, e)) << right.name;
  }
}

Bundle small() {
  Bundle b;
  b.array.records = {{0, 0, 2}, {1, 1, 1}};
  b.array.data = {0x02, 0x06};
  b.parts = {{Encoding::u32, 0, {1, 0, 0, 0, 0xff, 0xff, 0xff, 0xff}}};
  return b;
}

TEST(ArrayFile, VersionOneIsTheDocumentsBytes) {
  const Bytes file = written(small(), 1);
  const Bytes right{'M',  'M', 'A', 'R', 'R',  'A',  'Y',  'S',  1, 0, 0, 0,  // version
                    2,    0,   0,   0,   2,    0,    0,    0,                 // records, bytes of data
                    2,    0,   0,   0,   0,    0,    0,    0,                 // triangles, base
                    0,    0,   0,   0,   0,    0,    2,    0,                 // record 0
                    1,    0,   0,   0,   1,    0,    1,    0,                 // record 1
                    1,    0,   0,   0,   0xff, 0xff, 0xff, 0xff,              // indices
                    0x02, 0x06};
  EXPECT_EQ(file, right);
  EXPECT_EQ(written(read(file), 1), file);
}

TEST(ArrayFile, RefusalsNameTheirPlace) {
  const auto refused = [](Bytes file) { return message_of([&] { read(file); }); };
  Bytes file = written(small());
  EXPECT_EQ(refused({}), "byte 0: no array: it does not begin with MMARRAYS");
  file[8] = 3;
  EXPECT_EQ(refused(file), "byte 8: version 3, and this reader knows 1 and 2");
  file = written(small());
  file[24] = 9;
  EXPECT_EQ(refused(file), "byte 24: encoding 9 of 0 to 4");
  file = written(small());
  file.back() ^= 1;
  EXPECT_EQ(refused(file), "byte " + std::to_string(file.size() - 4) + ": the checksum is another");
  file = written(small());
  file.push_back(0);
  EXPECT_EQ(refused(file), "byte " + std::to_string(file.size() - 1) + ": 1 bytes too many");
  file.resize(40);
  EXPECT_EQ(refused(file).substr(0, 17), "byte 36: records:");
  EXPECT_EQ(message_of([] { written(small(), 3); }), "array::written: no version 3");
  Bundle two_parts = small();
  two_parts.parts.push_back(two_parts.parts[0]);
  EXPECT_EQ(message_of([&] { written(two_parts, 1); }),
            "array::written: version 1 holds one geometry with indices of 32 bits");
}

TEST(ArrayChanges, RefuseIndicesOfNoRecord) {
  Bundle b = small();
  b.parts[0].indices[0] = 2;
  EXPECT_EQ(message_of([&] { compacted(b); }), "array: part 0, triangle 0: no such record");
  b = small();
  b.array.records[1].offset = 2;
  EXPECT_EQ(message_of([&] { reordered(b); }), "array: record 1: outside the data");
  b.array.records[1].format = 3;
  EXPECT_EQ(message_of([&] { compacted(b); }), "array: record 1: no such format or level");
  EXPECT_EQ(compacted(small()).array.data, (Bytes{0x06}));
}

TEST(ArrayEmulation, RefusesALevelThatIsThere) {
  EXPECT_EQ(message_of([] { emulated(Bytes{0xe4}, 1, 1); }), "array::emulated: no level to emulate");
  EXPECT_EQ(message_of([] { emulated(Bytes{0xe4}, 2, 1); }), "array::emulated: too few bytes");
  EXPECT_EQ(emulated(Bytes{0x55}, 1, 0), (Bytes{1}));
}

}  // namespace impl_array_test
