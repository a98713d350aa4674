// [release] Topic vq's subjects in the dock: who has which entry point, what the cases add up to, what replay takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <tuple>

#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/vq/maps.hpp"
#include "proofs/vq/texts.hpp"

namespace vq_laws_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::vq;

/// Inside a test, Run is a member function of GoogleTest's.
std::uint64_t cases(const char* law, Level level) { return find_law(law)->cases(level, Run{}); }

Result judged(const char* law, const char* subject, Level level) {
  return run_level(*find_law(law), *find_subject(subject), level, Run{});
}

TEST(VqLaws, ALawNeedsItsEntryPointsAndItsLevel) {
  for (const auto& [law, subject, level] : std::initializer_list<std::tuple<const char*, const char*, Level>>{
           {"vq.vectors", "vq", 1},
           {"vq.vectors", "vq-spec", 3},
           {"vq2.block_bits", "vq", 4},
           {"vq2.region_is_map", "vq2-optimal", 4},
           {"vq2.region_is_map", "vq", 5},
           {"vq4.region_is_map", "vq", 4},
           {"vq2.conservative", "vq", 4},
           {"vq2.optimum", "impl", 4}})
    EXPECT_EQ(judged(law, subject, level).verdict, Verdict::not_applicable) << law << ' ' << subject;
}

TEST(VqLaws, CasesAddUpToTheirClosedForms) {
  EXPECT_EQ(judged("vq.vectors", "vq-spec", 1).cases_run(), 9u);
  EXPECT_EQ(judged("vq.transforms", "vq-spec", 2).cases_run(), 64u);
  EXPECT_EQ(judged("vq.codes", "vq-spec", 1).cases_run(), 32u + 12u);
  EXPECT_EQ(judged("vq2.block_bits", "vq-spec", 4).cases_run(), 2u * (1 + 256 + 256 * 255 / 2));
  EXPECT_EQ(judged("vq2.region_is_map", "vq", 4).cases_run(), 8u * 32 + 512 * 8);
  EXPECT_EQ(judged("vq4.region_is_map", "vq", 5).cases_run(), 8u * 2 * (1 + 20 + 190 + 1140) + 512 * 16);
  EXPECT_EQ(cases("vq.vectors", 2), 81u);
  EXPECT_EQ(cases("vq.codes", 2), 131'072u + 2 * 262'144u + 1'048'576u + 4 * 240u);
  EXPECT_EQ(cases("vq2.conservative", 4), 3u * 64 * 81);
  EXPECT_EQ(cases("vq2.conservative_in_pairs", 4), 6u * 81 * 81);
  EXPECT_EQ(judged("vq2.no_other_bit", "vq", 4).cases_run(), 1u << 14);
  EXPECT_EQ(judged("vq4.no_other_bit", "vq", 5).cases_run(), 1u << 15);
  EXPECT_EQ(judged("vq2.field_values", "vq-spec", 4).cases_run(), 1u << 15);
  EXPECT_EQ(cases("vq4.every_code_word", 5), std::uint64_t{8} << 20);
}

TEST(VqLaws, ReplayTakesTheTextsItGives) {
  const auto holds = [](const char* law, const char* subject, Level n, const std::string& at) {
    return find_law(law)->replay(*find_subject(subject), n, at).holds;
  };
  EXPECT_TRUE(holds("vq.vectors", "vq-spec", 1, "row:TO"));
  EXPECT_TRUE(holds("vq.transforms", "vq-spec", 2, "rows:7,1"));
  EXPECT_TRUE(holds("vq.codes", "vq-spec", 1, "mini:0x1f"));
  EXPECT_TRUE(holds("vq.codes", "vq-spec", 2, "generic:0xfffff"));
  EXPECT_TRUE(holds("vq.codes", "vq-spec", 2, "vertical-pair:0,3"));
  const std::string block = "block:" + std::string(64, '7'), map = "map:" + std::string(128, '5');
  EXPECT_TRUE(holds("vq2.block_bits", "vq-spec", 4, block));
  EXPECT_TRUE(holds("vq2.region_is_map", "vq", 4, block));
  EXPECT_TRUE(holds("vq2.conservative", "vq2-optimal", 4, map));
  EXPECT_TRUE(holds("vq2.optimum", "vq2-optimal", 4, map));
  for (const auto& [law, n, at] : std::initializer_list<std::tuple<const char*, Level, std::string>>{
           {"vq.vectors", 1, "row:TOT"},
           {"vq.vectors", 1, "row:TX"},
           {"vq.vectors", 3, "row:TOTOTOTO"},
           {"vq.transforms", 1, "rows:8,1"},
           {"vq.codes", 1, "generic:0x1"},
           {"vq.codes", 2, "mini:0x1"},
           {"vq.codes", 2, "simple:0x20000"},
           {"vq.codes", 2, "simple:0x1z"},
           {"vq.codes", 2, "simple-pair:3,3"},
           {"vq2.region_is_map", 4, "block:00"},
           {"vq2.region_is_map", 5, block},
           {"vq2.conservative", 4, "map:" + std::string(128, 'f')},
           {"vq2.conservative", 5, map}})
    EXPECT_THROW(holds(law, "vq-spec", n, at), BadCase) << law << ' ' << at;
}

TEST(VqTexts, AreReadBack) {
  for (std::uint64_t k = 0; k < 64; ++k) {
    const Map<Vq2> two = sample_map<Vq2>(3, k);
    const Map<Vq4> four = sample_map<Vq4>(3, k);
    EXPECT_EQ(map_from_text<Vq2>(text_of_map<Vq2>(two)), two);
    EXPECT_EQ(map_from_text<Vq4>(text_of_map<Vq4>(four)), four);
    const BlockBytes<Vq4> block = mmverify::spec::vq::bytes(sample_block<Vq4>(3, k));
    EXPECT_EQ(block_from_text<Vq4>(text_of_block<Vq4>(block)), block);
  }
}

// The samples have the kinds that the laws' domains promise.
TEST(VqMaps, SamplesAreOfTheirKinds) {
  std::set<std::array<std::uint32_t, 3>> triples;
  for (std::uint64_t k = 0; k < 512; ++k) {
    const auto& t = sample_block<Vq2>(1, k).transforms;
    triples.insert({t[1].number(), t[2].number(), t[3].number()});
    EXPECT_EQ(t[0].number(), 0u);
  }
  EXPECT_EQ(triples.size(), 512u);
  std::uint64_t beside = 0, uniform = 0, odd = 0;
  for (std::uint64_t k = 0; k < 80; ++k) {
    const Map<Vq4> map = sample_map<Vq4>(1, k);
    bool valid = true;
    for (std::uint32_t v = 0; v < 64; ++v)
      valid = valid && mmverify::spec::vq::valid<4>(vector_of<Vq4>(map, v));
    beside += valid ? 0 : 1;
    const auto same = std::count(map.begin(), map.end(), map[0]);
    uniform += same == 1024 ? 1 : 0;
    odd += same == 1023 || same == 1 ? 1 : 0;
  }
  EXPECT_GT(beside, 8u);
  EXPECT_GT(uniform, 2u);
  EXPECT_GT(odd, 2u);
}

// Maps whose fewest substitutions are plain to see.
TEST(VqLeast, OfMapsWorkedByHand) {
  Map<Vq2> map;
  map.fill(State::T);
  EXPECT_EQ(least_substitutions(map), 0u);
  // O beside T in one vector: one of the two has to go.
  map[0] = State::O;
  EXPECT_EQ(least_substitutions(map), 1u);
  map[1] = State::O;
  EXPECT_EQ(least_substitutions(map), 2u);
  // TL, never turned, has five entries: of seven vectors, two pairs share one that keeps two regions of each.
  using enum State;
  map.fill(C);
  const Vector<2> seven[] = {{C, T, T, T}, {T, C, T, T}, {T, T, C, T}, {T, T, T, C},
                             {C, O, O, O}, {O, C, O, O}, {O, O, C, O}};
  for (std::uint32_t k = 0; k < 7; ++k) put<Vq2>(map, k % 4 + 8 * (4 + k / 4), seven[k]);
  EXPECT_EQ(least_substitutions(map), 4u);
}

}  // namespace vq_laws_test
