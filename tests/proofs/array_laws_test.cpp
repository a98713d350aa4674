// Topic array: its domains are as large as they are said to be, and its texts are read back.
#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>
#include <utility>

#include "proofs/array/cases.hpp"
#include "proofs/array/small_answers.hpp"
#include "proofs/array/subject.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"

namespace array_laws_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::array;
using LawRun = mmverify::proofs::Run;

TEST(ArrayCases, AreAsManyAsTheirDomainSays) {
  EXPECT_EQ(all_maps(0).size(), 6u);
  EXPECT_EQ(all_maps(1).size(), 278u);
  // Ascending: 2 and 4 of level 0, 5 of four bits, 35 of four states out of four.
  EXPECT_EQ(sorted_maps(1).size(), 2u + 4 + 5 + 35);
  EXPECT_EQ(small_arrays(0), 259u * 8 * 3);
  EXPECT_EQ(small_arrays(1), (278u + 278 * 278 + 7 * (46 + 46 * 46) + 46 * 46 * 46) * 3);
  EXPECT_EQ(whole_small_arrays(), 278u * 278 * 278 * 3);
  const auto cases = [](const char* id, Level n) { return find_law(id)->cases(n, LawRun{}); };
  EXPECT_EQ(cases("array.resolves", 1), small_arrays(1));
  EXPECT_EQ(cases("array.merging", 1), 2u * (278 * 278 + 46 * 46 * 46));
  // Bell's numbers 1, 2, 5, ... of 1 to 10.
  EXPECT_EQ(cases("array.blocks", 0), 1u + 2 + 5 + 15 + 52 + 203 + 877 + 4'140 + 21'147 + 115'975);
}

TEST(ArrayCases, ComeBackFromTheirTexts) {
  std::set<std::string> texts;
  for (const Level n : {0u, 1u})
    for (std::uint64_t k = 0; k < small_arrays(n); k += n == 0 ? 1 : 997) {
      const BuildCase c = small_array(n, k);
      const std::string text = text_of(c);
      EXPECT_TRUE(texts.insert(std::to_string(n) + text).second) << text;
      const BuildCase back = case_of(text);
      EXPECT_EQ(text_of(back), text);
      EXPECT_EQ(back.maps, c.maps) << text;
      EXPECT_EQ(back.before, c.before) << text;
    }
}

TEST(ArrayCases, OtherTextsAreNone) {
  for (const char* text : {"", "u8", "khr", "ext,u8", "khr,u8,base=1", "khr,u8,base=x", "khr,u8,4-state:012",
                           "khr,u8,2-state:2", "khr,u8,shares", "khr,u8,bound=", "khr,i16,2-state:0"})
    EXPECT_THROW(case_of(text), BadCase) << text;
  EXPECT_THROW(sample_of("sample:1"), BadCase);
}

// The library's answers are kept for the next law on small arrays, and for nobody else: a builder made of the library's,
// wrong where only another law looks, is judged by its own answers.
TEST(SmallArrays, AreKeptOfTheLibraryAlone) {
  const Law &resolves = *find_law("array.resolves"), &counts = *find_law("array.array_histogram");
  const SubjectPtr library = find_subject("array");
  const Result anew = run_level(resolves, *library, 0, LawRun{}),
               kept = run_level(counts, *library, 0, LawRun{});
  EXPECT_EQ(anew.verdict, Verdict::proved);
  EXPECT_EQ(kept.verdict, Verdict::proved);
  EXPECT_EQ(kept.cases_run(), small_arrays(0));
  EXPECT_EQ(kept.digest, anew.digest);
  Functions functions = built_in("array")->functions;
  functions.build = [real = functions.build](const BuildCase& c) {
    std::optional<Answer> answer = real(c);
    if (answer && !answer->array_counts.empty()) ++answer->array_counts.back().count;
    return answer;
  };
  const ArraySubject miscounts("array", "counts one more", functions);
  EXPECT_EQ(run_level(resolves, miscounts, 0, LawRun{}).verdict, Verdict::proved);
  EXPECT_EQ(run_level(counts, miscounts, 0, LawRun{}).verdict, Verdict::refuted);
}

// A user's builder keeps its answers, too.  It is wrong where only another law looks: the first law to come to a case asks
// all checks, so that its own success spares the other law nothing.
TEST(SmallArrays, AreKeptWhereEveryLawHolds) {
  Functions functions = built_in("array")->functions;
  std::atomic<std::uint64_t> builds = 0;
  functions.build = [&builds, real = functions.build](const BuildCase& c) {
    ++builds;
    std::optional<Answer> answer = real(c);
    if (answer && answer->array_counts.size() > 1) ++answer->array_counts.back().count;
    return answer;
  };
  functions.small_arrays = small_arrays_of_subject();
  const ArraySubject miscounts("user", "counts one more of a second kind", std::move(functions));
  const Result first = run_level(*find_law("array.resolves"), miscounts, 0, LawRun{});
  EXPECT_EQ(first.verdict, Verdict::proved);
  const std::uint64_t built_first = builds;
  EXPECT_GE(built_first, small_arrays(0));
  const Result second = run_level(*find_law("array.array_histogram"), miscounts, 0, LawRun{});
  EXPECT_EQ(second.verdict, Verdict::refuted);
  EXPECT_GT(second.mismatches(), 0u);
  EXPECT_LT(builds - built_first, built_first);  // the right ones were kept
}

}  // namespace array_laws_test
