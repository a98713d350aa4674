// Topic micromap's subjects in the dock: who keeps which rule, who has which entry point, and what replay
// takes.
#include <gtest/gtest.h>

#include "proofs/engine/runner.hpp"
#include "proofs/registry.hpp"

namespace {

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
}

TEST(MicromapLaws, ReplayTakesTheTextsItGives) {
  const auto holds = [](const char* law, Level n, const char* at) {
    return find_law(law)->replay(*find_subject("micromap"), n, at).holds;
  };
  EXPECT_TRUE(holds("micromap.packing", 1, "4-state:0123"));
  EXPECT_TRUE(holds("micromap.on_samples", 5, "sample:1:17"));
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
           {"micromap.validate", "sample:1"}})
    EXPECT_THROW(holds(law, 1, at), BadCase) << law << ' ' << at;
}

}  // namespace
