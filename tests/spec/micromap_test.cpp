// [release] spec/micromap*.hpp against what was worked out by hand.
#include <gtest/gtest.h>

#include "spec/micromap/array.hpp"
#include "spec/micromap/level.hpp"
#include "spec/micromap/lossy.hpp"

namespace spec_micromap_test {

using namespace mmverify::spec::micromap;
using enum State;

constexpr State all_states[] = {T, O, UT, UO};

// ---- States, packing, special indices

TEST(SpecMicromap, ForceTwoState) {
  EXPECT_EQ(force2(States{T, O, UT, UO}), (States{T, O, T, O}));
  EXPECT_EQ(as_unknown(T), UT);
  EXPECT_EQ(as_unknown(UT), UT);
  EXPECT_EQ(as_unknown(O), UO);
  EXPECT_EQ(as_unknown(UO), UO);
}

TEST(SpecMicromap, PacksFromTheLeastSignificantBit) {
  EXPECT_EQ(pack(States{UO}, Format::four_state), Bytes{0b11});
  EXPECT_EQ(pack(States{O, T, O, O}, Format::two_state), Bytes{0b1101});
  EXPECT_EQ(pack(States{T, O, UT, UO}, Format::four_state), Bytes{0b11'10'01'00});
  States level2(16, T);
  level2[0] = level2[9] = O;
  EXPECT_EQ(pack(level2, Format::two_state), (Bytes{0b1, 0b10}));
  level2[4] = UT;
  EXPECT_EQ(pack(level2, Format::four_state), (Bytes{0b1, 0b10, 0b100, 0}));
}

TEST(SpecMicromap, ASizeIsRoundedUpToBytes) {
  // 4^n b bits: 1, 4, 16, 64 and 2, 8, 32, 128.
  constexpr std::uint64_t two[] = {1, 1, 2, 8}, four[] = {1, 1, 4, 16};
  for (std::uint32_t n = 0; n < 4; ++n) {
    EXPECT_EQ(packed_bytes(micro_triangles(n), Format::two_state), two[n]);
    EXPECT_EQ(packed_bytes(micro_triangles(n), Format::four_state), four[n]);
  }
  EXPECT_EQ(packed_bytes(micro_triangles(12), Format::four_state), 4'194'304u);
}

TEST(SpecMicromap, IgnoresPaddingOnReading) {
  EXPECT_EQ(unpack(Bytes{0b1111'1101}, Format::two_state, 4), (States{O, T, O, O}));
  EXPECT_EQ(unpack(Bytes{0b1111'1110}, Format::four_state, 1), (States{UT}));
  EXPECT_EQ(unpack(Bytes{0xe4, 0xff}, Format::four_state, 4), (States{T, O, UT, UO}));
}

TEST(SpecMicromap, RefusesWhatDoesNotFit) {
  EXPECT_THROW(pack(States{T, UT}, Format::two_state), std::invalid_argument);
  EXPECT_THROW(unpack(Bytes{0}, Format::four_state, 5), std::invalid_argument);
  EXPECT_THROW(unpack(Bytes{}, Format::two_state, 1), std::invalid_argument);
}

TEST(SpecMicromap, OnlyEqualStatesAreUniform) {
  EXPECT_EQ(uniform(States{UT, UT, UT, UT}), UT);
  EXPECT_EQ(uniform(States{UT, UT, UT, UO}), std::nullopt);
  EXPECT_EQ(uniform(States{O}), O);
  EXPECT_EQ(uniform(States{}), std::nullopt);
}

TEST(SpecMicromap, SpecialCodes) {
  EXPECT_EQ(special_index(T), -1);
  EXPECT_EQ(special_index(O), -2);
  EXPECT_EQ(special_index(UT), -3);
  EXPECT_EQ(special_index(UO), -4);
  EXPECT_EQ(special_code(T, Encoding::u8), 255u);
  EXPECT_EQ(special_code(UO, Encoding::u8), 252u);
  EXPECT_EQ(special_code(O, Encoding::u16), 65'534u);
  EXPECT_EQ(special_code(UT, Encoding::i16), 65'533u);
  EXPECT_EQ(special_code(T, Encoding::u32), 4'294'967'295u);
  EXPECT_EQ(special_code(UO, Encoding::i32), 4'294'967'292u);
}

TEST(SpecMicromap, CodesBelowTheSpecialOnes) {
  using Kind = Meaning::Kind;
  EXPECT_EQ(meaning(251, Encoding::u8), (Meaning{Kind::index, 251, T}));
  EXPECT_EQ(meaning(252, Encoding::u8), (Meaning{Kind::special, 0, UO}));
  // -5: a plain index without sign, nothing with one.
  EXPECT_EQ(meaning(0xfffb, Encoding::u16), (Meaning{Kind::index, 65'531, T}));
  EXPECT_EQ(meaning(0xfffb, Encoding::i16).kind, Kind::unknown);
  EXPECT_EQ(meaning(0xfffffffb, Encoding::u32), (Meaning{Kind::index, 4'294'967'291, T}));
  EXPECT_EQ(meaning(0xfffffffb, Encoding::i32).kind, Kind::unknown);
  EXPECT_EQ(meaning(0x7fff, Encoding::i16), (Meaning{Kind::index, 32'767, T}));
  EXPECT_EQ(meaning(0x8000, Encoding::i16).kind, Kind::unknown);
  EXPECT_EQ(meaning(0x80000000, Encoding::i32).kind, Kind::unknown);
  EXPECT_EQ(meaning(255, Encoding::u16), (Meaning{Kind::index, 255, T}));
}

TEST(SpecMicromap, WhatAnEncodingCanIndex) {
  EXPECT_EQ(index_limit(Encoding::u8), 252u);
  EXPECT_EQ(index_limit(Encoding::u16), 65'532u);
  EXPECT_EQ(index_limit(Encoding::u32), 4'294'967'292u);
  EXPECT_EQ(index_limit(Encoding::i16), 32'768u);
  EXPECT_EQ(index_limit(Encoding::i32), 2'147'483'648u);
}

// ---- Levels, modes, substitutions

TEST(SpecMicromap, MergesFourChildren) {
  EXPECT_EQ(merged(T, T, T, T), T);
  EXPECT_EQ(merged(O, O, O, O), O);
  EXPECT_EQ(merged(UT, UT, UT, UT), UT);
  EXPECT_EQ(merged(UO, UO, UO, UO), UO);
  EXPECT_EQ(merged(T, T, T, O), UT);
  EXPECT_EQ(merged(T, O, O, O), UO);
  EXPECT_EQ(merged(T, O, T, O), UO);  // a tie is opaque
  EXPECT_EQ(merged(T, T, T, UT), UT);
  EXPECT_EQ(merged(O, O, O, UO), UO);
  EXPECT_EQ(merged(T, UT, UO, UT), UT);
}

TEST(SpecMicromap, OneLevelDownAndUp) {
  EXPECT_EQ(down(States{T, T, T, T, O, O, O, O, T, O, UT, UT, UO, UO, T, T}), (States{T, O, UT, UO}));
  EXPECT_EQ(up(States{T, UO}), (States{T, T, T, T, UO, UO, UO, UO}));
  EXPECT_EQ(down_two_state(States{T, O, T, T}), (States{T}));
  EXPECT_EQ(down_two_state(States{T, O, O, T}), (States{O}));
  EXPECT_THROW(down(States{T}), std::invalid_argument);
  EXPECT_THROW(down(States{T, T, T, T, T}), std::invalid_argument);
}

TEST(SpecMicromap, OneBitModes) {
  const States all{T, O, UT, UO};
  EXPECT_EQ(through(all, Mode::T_O), (States{T, O, T, O}));
  EXPECT_EQ(through(all, Mode::T_C), (States{T, UO, UO, UO}));
  EXPECT_EQ(through(all, Mode::O_C), (States{UT, O, UT, UT}));
}

// Rows: was; columns: is; T, O, UT, UO.
TEST(SpecMicromap, SubstitutionsOneByOne) {
  constexpr bool by_khr[4][4] = {{1, 0, 1, 1}, {0, 1, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}};
  constexpr bool conservatively[4][4] = {{1, 0, 1, 1}, {0, 1, 1, 1}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  constexpr bool stably[4][4] = {{1, 0, 1, 0}, {0, 1, 0, 1}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  for (const State was : all_states)
    for (const State is : all_states) {
      EXPECT_EQ(allowed(was, is), by_khr[code(was)][code(is)]);
      EXPECT_EQ(conservative(was, is), conservatively[code(was)][code(is)]);
      EXPECT_EQ(force2_stable(was, is), stably[code(was)][code(is)]);
      EXPECT_LE(force2_stable(was, is), conservative(was, is));
      EXPECT_LE(conservative(was, is), allowed(was, is));
      EXPECT_TRUE(!force2_stable(was, is) || force2(was) == force2(is));
    }
}

TEST(SpecMicromap, ASubstitutionIsJudgedEverywhere) {
  EXPECT_TRUE(everywhere(States{T, O}, States{UT, O}, force2_stable));
  EXPECT_FALSE(everywhere(States{T, O}, States{UT, T}, allowed));
  EXPECT_FALSE(everywhere(States{T, O}, States{T}, allowed));
}

// ---- Arrays

const Map mixed{1, Format::four_state, {T, O, UT, UO}};
const Map same_bits_2{1, Format::two_state, {T, T, O, T}};  // 0b0100
const Map flat{1, Format::four_state, {O, O, O, O}};
const Map point{0, Format::four_state, {UT}};

TEST(SpecMicromap, BuildsAnArray) {
  Array array;
  const std::vector<Map> maps{mixed, flat, same_bits_2, mixed, point};
  const Geometry g = append(array, maps, {Encoding::u16, 0, true, true});
  EXPECT_EQ(array.records, (std::vector<Record>{{0, 1, 2}, {1, 1, 1}}));
  EXPECT_EQ(array.data, (Bytes{0xe4, 0b0100}));
  EXPECT_EQ(g.indices, (Bytes{0, 0, 0xfe, 0xff, 1, 0, 0, 0, 0xfd, 0xff}));
  // Two references to the 4-state record, one record of it: the two histograms differ.
  EXPECT_EQ(g.counts, (std::vector<UsageCount>{{1, 1, 1}, {2, 1, 2}}));
  EXPECT_EQ(usage_counts(array_histogram(array.records)), (std::vector<UsageCount>{{1, 1, 1}, {1, 1, 2}}));
  EXPECT_EQ(record_buffer(array.records), (Bytes{0, 0, 0, 0, 1, 0, 2, 0, 1, 0, 0, 0, 1, 0, 1, 0}));
  for (std::size_t t = 0; t < maps.size(); ++t)
    for (std::size_t i = 0; i < maps[t].states.size(); ++i)
      EXPECT_EQ(fetch(array, g, Encoding::u16, 0, t, i), maps[t].states[i]) << t << ' ' << i;
}

TEST(SpecMicromap, SharesAndReplacesOnlyOnRequest) {
  Array array;
  const Geometry g = append(array, std::vector<Map>{mixed, flat, mixed}, {Encoding::i32, 0, false, false});
  EXPECT_EQ(array.records, (std::vector<Record>{{0, 1, 2}, {1, 1, 2}, {2, 1, 2}}));
  EXPECT_EQ(array.data, (Bytes{0xe4, 0x55, 0xe4}));
  EXPECT_EQ(g.indices, (Bytes{0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0}));
}

TEST(SpecMicromap, EqualBitsOfAnotherFormatOrLevelAreAnotherMap) {
  Array array;
  const Map two{0, Format::two_state, {O}}, four{0, Format::four_state, {O}},
      wide{1, Format::two_state, {O, T, T, T}};
  append(array, std::vector<Map>{two, four, wide}, {Encoding::u32, 0, true, false});
  EXPECT_EQ(array.data, (Bytes{1, 1, 1}));
  EXPECT_EQ(array.records.size(), 3u);
}

TEST(SpecMicromap, BaseTriangleIsAddedToPlainIndicesOnly) {
  Array array;
  append(array, std::vector<Map>{mixed}, {});
  const Geometry g = append(array, std::vector<Map>{mixed, flat, same_bits_2}, {Encoding::u8, 1, true, true});
  EXPECT_EQ(array.records.size(), 3u);  // the first is not shared: it lies before the base
  EXPECT_EQ(g.indices, (Bytes{0, 254, 1}));
  EXPECT_EQ(g.counts, (std::vector<UsageCount>{{1, 1, 1}, {1, 1, 2}}));
  EXPECT_EQ(fetch(array, g, Encoding::u8, 1, 2, 2), O);
  EXPECT_EQ(fetch(array, g, Encoding::u8, 1, 1, 0), O);
}

TEST(SpecMicromap, AnIndexThatDoesNotFitIsAnErrorAndChangesNothing) {
  std::vector<Map> maps(253, mixed);
  Array array, before;
  append(array, std::vector<Map>(1, flat), {Encoding::u8, 0, false, false});
  before = array;
  const Options unshared{Encoding::u8, 0, false, true};
  EXPECT_THROW(append(array, maps, unshared), std::length_error);
  EXPECT_EQ(array, before);
  maps.resize(251);
  EXPECT_EQ(append(array, maps, unshared).indices.back(), 251);  // the last plain u8 index
  EXPECT_THROW(append(array, maps, {Encoding::u8, 300, true, true}), std::invalid_argument);
  EXPECT_THROW(append(array, std::vector<Map>{{1, Format::four_state, {T}}}, {}), std::invalid_argument);
}

TEST(SpecMicromap, CountsOfOneKindAddUp) {
  const std::vector<UsageCount> counts{{1, 3, 2}, {4, 1, 2}, {2, 3, 2}, {0, 7, 1}, {0xffffffff, 3, 2}};
  EXPECT_EQ(histogram(counts), (Histogram{{{1, 2}, 4}, {{3, 2}, 4'294'967'298}}));
}

}  // namespace spec_micromap_test
