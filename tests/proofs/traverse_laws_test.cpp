// [release] Topic traverse: its domains are as large as they are said to be, and its texts are read back.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "proofs/engine/law.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/traverse/combinations.hpp"

namespace traverse_laws_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::traverse;
using LawRun = mmverify::proofs::Run;

TEST(TraverseCombinations, AreAllThereOnce) {
  EXPECT_EQ(all_combinations, 123'904u);
  EXPECT_EQ(defined_combinations, 17'040u);
  EXPECT_EQ(defined().size(), defined_combinations);
  std::set<std::string> texts;
  for (std::uint64_t k = 0; k < all_combinations; k += 7) {
    const std::string text = text_of(combination(k));
    EXPECT_TRUE(texts.insert(text).second) << text;
    EXPECT_EQ(combination_of(text), combination(k)) << text;
  }
}

TEST(TraverseCombinations, OtherTextsAreNone) {
  for (const char* text : {"", "khr-query", "khr-query,on,4-state:UT,not-opaque,instance=none",
                           "ext-query,off,nothing,opaque,instance=none,ray=none",
                           "khr-query,on,2-state:UT,not-opaque,instance=none,ray=none",
                           "khr-query,on,nothing:T,opaque,instance=none,ray=none",
                           "khr-query,on,special,opaque,instance=none,ray=none",
                           "vk-query,on,nothing,opaque,instance=none,ray=none",
                           "khr-query,on,nothing,opaque,instance=2-state+force-opaque,ray=none",
                           "khr-query,on,nothing,opaque,instance=none,ray=opaque+",
                           "khr-query,on,nothing,opaque,instance=none,ray=opaque+opaque"})
    EXPECT_THROW(combination_of(text), BadCase) << text;
}

// Worked out in the comments of each.
TEST(TraverseLaws, HaveAsManyCasesAsTheirDomainsSay) {
  const auto cases = [](const char* id) { return find_law(id)->cases(0, LawRun{}); };
  // 6 ways, 2 geometries; 3 x 5 flags that exclude each other, 2 x 2 of force-2-state.  T is held in 3 forms, UT in 2.
  EXPECT_EQ(cases("traverse.ignored_is_final"), 6u * 2 * 15 * (3 * 4 + 2 * 3));
  EXPECT_EQ(cases("traverse.two_state_never_calls_a_shader"), 6u * 2 * 15 * 2 * (3 * 4 + 2 * 3));
  // 12 of 15 have a flag that overrides.
  EXPECT_EQ(cases("traverse.last_flag_wins"), (17'040u - 3'240) * 12 / 15);
  EXPECT_EQ(cases("traverse.apis_agree"), 11u * 2 * 12 * 10);
  // 2 APIs, 2 geometries, 2 forms.  Without force-2-state: T to two states, 5 of 15 make it opaque; O to two, 2 cull it; UT
  // and UO to the other.  With it, 3 ways: T and O to their own side; each of four to the other, of which 3 of 15 drop both
  // sides, and 5 ask a shader, which drops a T.
  EXPECT_EQ(cases("traverse.lossy_is_conservative"),
            8u * (2 * 10 + 2 * 13 + 2 * 15 + 3 * 2 * 15 + 3 * (4 * 3 + 5)));
  EXPECT_EQ(cases("traverse.lossy_shows"), 8u * (2 * 5 + 2 * 2 + 3 * (4 * 12 - 5)));
  EXPECT_EQ(cases("traverse.lossy_decides_no_more"), 1'736u + 1'144);
  // Pairs of codes; the third code runs within a case.
  EXPECT_EQ(cases("traverse.blend"), 5u * 65'536);
  EXPECT_EQ(cases("traverse.blend_order_free"), 3u * 65'536);
  EXPECT_EQ(cases("traverse.blend_duplicates"), 4u * 65'536);
  // Kinds of one to four hits, and 2^(n-1) ways in which neighbours are at one distance; 2 payloads.
  EXPECT_EQ(cases("paper.blend_with_accepted_hit"), 3u * 2 * (2 * 1 + 4 * 2 + 8 * 4 + 16 * 8));
  // Each hit's kind and distance; 3 + 3 + 1 + 1 + 1 ways to report them, 3 orders of values, 2 payloads.
  EXPECT_EQ(cases("traverse.blend_before_closest"), 9u * 3 * 2 * (2 + 4 * 4 + 6 * 6 * 6 + 8 * 8 * 8 * 8));
}

}  // namespace traverse_laws_test
