// [release] Topic micromap's subjects in the dock: who keeps which rule, who has which entry point, and what replay
// takes.
#include <gtest/gtest.h>

#include <set>

#include "proofs/engine/runner.hpp"
#include "proofs/micromap/maps.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/tree/damages.hpp"

namespace micromap_laws_test {

using namespace mmverify::proofs;

Result judged(const char* law, const char* subject, Level level) {
  return run_level(*find_law(law), *find_subject(subject), level, Run{});
}

TEST(MicromapLaws, EachCodecBreaksTheNextStricterRule) {
  // T, T, T, O: merged, O becomes UT.  T, O, UT, UO: UT becomes UO.
  const Result conservative = judged("lossy.conservative", "lossy-merge", 1),
               stable = judged("lossy.force2_stable", "lossy-conservative", 1);
  EXPECT_EQ(conservative.verdict, Verdict::refuted);
  EXPECT_EQ(stable.verdict, Verdict::refuted);
  EXPECT_EQ(judged("lossy.force2_stable", "lossy-merge", 1).verdict, Verdict::refuted);
  // Maps of four equal states, and those of level 0, are left alone.
  for (const char* law : {"lossy.allowed", "lossy.conservative", "lossy.force2_stable"})
    EXPECT_EQ(judged(law, "lossy-merge", 0).verdict, Verdict::proved);
  ASSERT_EQ(conservative.counterexamples.size(), 1u);
  const Law& law = *find_law("lossy.conservative");
  EXPECT_FALSE(law.replay(*find_subject("lossy-merge"), 1, conservative.counterexamples.front().at).holds);
  EXPECT_TRUE(law.replay(*find_subject("lossy-stable"), 1, conservative.counterexamples.front().at).holds);
}

TEST(MicromapLaws, ALawNeedsItsEntryPoints) {
  EXPECT_EQ(judged("lossy.allowed", "micromap", 1).verdict, Verdict::not_applicable);
  EXPECT_EQ(judged("micromap.packing", "lossy-merge", 1).verdict, Verdict::not_applicable);
  EXPECT_EQ(judged("micromap.packing", "impl", 1).verdict, Verdict::not_applicable);
  EXPECT_EQ(judged("micromap.down", "micromap", 0).verdict, Verdict::not_applicable);
  EXPECT_EQ(judged("micromap.packing", "micromap", 3).verdict, Verdict::not_applicable);
}

TEST(MicromapLaws, CasesAddUpToTheirClosedForms) {
  EXPECT_EQ(judged("micromap.packing", "micromap", 0).cases_run(), 2u + 4u);
  EXPECT_EQ(judged("micromap.packing", "micromap", 1).cases_run(), 16u + 256u);
  EXPECT_EQ(judged("lossy.judges", "micromap", 1).cases_run(), 65'536u);
  EXPECT_EQ(judged("micromap.build", "micromap", 0).cases_run(), 6u * 6u);
  EXPECT_EQ(judged("micromap.special_indices", "micromap", 0).cases_run(), 256u + 65'536u + 65'536u);
  EXPECT_EQ(judged("micromap.packing_any_count", "micromap", 0).cases_run(), 8190u + 5460u);
  EXPECT_EQ(judged("micromap.one_apart", "micromap", 2).cases_run(), 6u + 14 * (4 + 16));
  EXPECT_EQ(judged("tree.one_apart", "tree-ranked", 3).cases_run(), 6u + 14 * (4 + 16 + 64));
}

TEST(MicromapLaws, ReplayTakesTheTextsItGives) {
  const auto holds = [](const char* law, Level n, const char* at) {
    return find_law(law)->replay(*find_subject("micromap"), n, at).holds;
  };
  EXPECT_TRUE(holds("micromap.packing", 1, "4-state:0123"));
  EXPECT_TRUE(holds("micromap.on_samples", 5, "sample:1:17"));
  EXPECT_TRUE(holds("micromap.one_apart", 4, "4-state:0+2@3:17"));
  EXPECT_TRUE(holds("micromap.one_apart_on_samples", 9, "2-state:1+1@0:0"));
  EXPECT_TRUE(holds("micromap.packing_any_count", 0, "4-state:01230"));
  EXPECT_TRUE(holds("lossy.judges_on_samples", 5, "sample:1:3|2@5:17"));
  EXPECT_TRUE(holds("lossy.judges", 1, "4-state:0123|4-state:2323"));
  EXPECT_TRUE(holds("micromap.special_indices", 0, "i16:65531"));
  EXPECT_TRUE(holds("micromap.special_indices_32", 0, "u32:4294967291"));
  EXPECT_TRUE(holds("micromap.build", 1, "4-state:0123|2-state:0110"));
  EXPECT_TRUE(holds("micromap.build_on_samples", 4, "sample:1:23"));
  EXPECT_TRUE(holds("micromap.validate", 3, "sample:1:287"));
  for (const auto& [law, at] : std::initializer_list<std::pair<const char*, const char*>>{
           {"micromap.packing", "nonsense"},
           {"micromap.modes", "2-state:0110"},
           {"lossy.judges", "4-state:0123"},
           {"lossy.judges", "4-state:0123|2-state:0110"},
           {"micromap.special_indices", "u8:256"},
           {"micromap.special_indices", "u64:1"},
           {"micromap.build", "4-state:0123"},
           {"micromap.one_apart", "4-state:0+2@1:4"},
           {"micromap.one_apart", "2-state:0+2@1:3"},
           {"micromap.one_apart", "4-state:0123"},
           {"micromap.packing_any_count", "2-state:012"},
           {"lossy.judges_on_samples", "sample:1:2|2@1:0"},
           {"micromap.validate", "sample:1"}})
    EXPECT_THROW(holds(law, 1, at), BadCase) << law << ' ' << at;
}

// The closed forms of maps of one state but for one node are the specification's, and no two are alike.
TEST(MicromapLaws, MapsOfOneStateButForOneNodeAreWhatTheirTextsSay) {
  namespace slow = mmverify::spec;
  for (Level n = 0; n <= 3; ++n) {
    std::set<std::pair<tree::Format, tree::Bytes>> different;
    for (std::uint64_t k = 0; k < micromap::one_apart_count(n); ++k) {
      const micromap::OneApart apart = micromap::one_apart_number(n, k);
      const micromap::Map map = micromap::map_of(n, apart);
      const auto states = slow::micromap::unpack(map.packed, map.format, slow::micromap::micro_triangles(n));
      EXPECT_TRUE(different.insert({map.format, map.packed}).second) << micromap::text_of(apart);
      EXPECT_EQ(micromap::code_of(apart), slow::tree::bytes(slow::tree::encode(states, n), map.format))
          << micromap::text_of(apart);
      const std::uint64_t run = slow::micromap::micro_triangles(n - apart.depth);
      for (std::uint64_t i = 0; i < states.size(); ++i)
        EXPECT_EQ(slow::micromap::code(states[i]), i / run == apart.node ? apart.odd : apart.common);
      EXPECT_EQ(micromap::map_from_text(n, micromap::text_of(apart)).packed, map.packed);
    }
    EXPECT_EQ(different.size(), micromap::one_apart_count(n));
  }
}

// constructed_codes() knows the meaning of each string that it builds; the specification must read the same.
TEST(MicromapLaws, ConstructedCodesMeanWhatTheSpecificationReads) {
  std::uint64_t refused = 0, taken = 0;
  for (Level n = 1; n <= 4; ++n)
    for (std::uint64_t k = 0; k < 40; ++k)
      tree::constructed_codes(micromap::sample_map(n, 7, k), [&](const tree::Constructed& c) {
        const auto read = mmverify::spec::tree::from_bytes(c.bytes, c.format);
        const auto meant = read ? mmverify::spec::tree::decode(*read, c.level, c.format) : std::nullopt;
        EXPECT_EQ(meant.has_value(), c.meant.has_value()) << c.what << " level " << n << " sample " << k;
        if (meant && c.meant) {
          EXPECT_EQ(mmverify::spec::micromap::pack(*meant, c.format), c.meant->packed) << c.what;
        }
        ++(c.meant ? taken : refused);
        return true;
      });
  EXPECT_GT(refused, 1000u);
  EXPECT_GT(taken, 300u);
}

}  // namespace micromap_laws_test
