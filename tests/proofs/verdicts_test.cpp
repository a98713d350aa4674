// [sanitized] Subjects that are known to be wrong, and what a run says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <memory>
#include <set>
#include <span>
#include <string>

#include "proofs/index/judges/judges.hpp"
#include "tests/proofs/every_law.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::tests;
namespace index = mmverify::proofs::index;

struct Known {
  const char* subject;
  Level level;
  const char *at, *expected, *got;
};

// Traced by hand in spec_index_test.cpp, all but step-appendix-middle at level 2: (3/8, 1/8) there is
//   u v w = 3/8 1/8 1/2: M; u_M, w_M, v_M = 0, 3/4, 1/4.  Printed, v = w_M: 2v = 3/2 -> T, 1*4 + 3 = 7.
//   Appendix A: v = v_M = 1/4, w = 3/4: 2w > 1 -> L, 1*4 + 0 = 4.
TEST(Readings, AreRefutedWhereTheHandTraceSays) {
  const Law& law = *find_law("index.equals_reference");
  for (const Known& k : {Known{"step-appendix-middle", 2, "e:u=3/8,v=1/8", "7", "4"},
                         Known{"step-appendix-middle", 3, "v:u=1/4,v=1/4", "20", "23"},
                         Known{"step-appendix-ties", 2, "e:u=3/8,v=3/8", "6", "5"},
                         Known{"step-appendix-names", 2, "v:u=0,v=1/2", "14", "15"},
                         Known{"step-restarted", 2, "v:u=1/2,v=0", "8", "10"}}) {
    const Result r = run_level(law, *find_subject(k.subject), k.level, LawRun{});
    EXPECT_EQ(r.verdict, Verdict::refuted);
    ASSERT_FALSE(r.counterexamples.empty()) << k.subject;
    EXPECT_EQ(r.counterexamples.front().at, k.at) << k.subject;
    EXPECT_EQ(r.counterexamples.front().expected, k.expected) << k.subject;
    EXPECT_EQ(r.counterexamples.front().got, k.got) << k.subject;
  }
}

// The counterexamples of the run are the simplest ones, whoever found them first.
TEST(Readings, CountsAndCounterexamplesAreTheSameForOneThreadAndTwo) {
  if (sanitized) GTEST_SKIP() << "the same runs once more; these sanitizers see nothing of threads";
  const Law& law = *find_law("index.equals_reference");
  for (const char* name : {"step-appendix-middle", "step-appendix-ties", "step-appendix-names"}) {
    const Report one = run_alone(law, find_subject(name), 9, 1, 6),
                 two = run_alone(law, find_subject(name), 9, 2, 6);
    EXPECT_EQ(one.results.front().counterexamples.size(), 6u);
    EXPECT_EQ(outcome(one), outcome(two));
  }
}

// The law's own sample begins with these: sample k depends on the seed, the level and k alone.
constexpr std::uint64_t first_samples = 14'000;

std::uint64_t wrong_on_floats(const char* name, Level n, std::uint64_t samples) {
  const Tally tally = index::exact_on_floats(*index::built_in(name), n, LawRun{}, samples);
  EXPECT_EQ(tally.cases(), samples);
  std::uint64_t wrong = 0;
  for (const Count& c : tally.by_kind()) wrong += c.mismatches;
  return wrong;
}

class StepInBinary32 : public testing::TestWithParam<Level> {};
INSTANTIATE_TEST_SUITE_P(Level, StepInBinary32, testing::Range(Level{4}, Level{9}));

TEST_P(StepInBinary32, IsRefutedOnFloats) {
  EXPECT_GT(wrong_on_floats("step-f32", GetParam(), first_samples), 0u);
}

TEST(ReferenceInBinary32, IsRefutedOnFloatsSomewhere) {
  std::uint64_t wrong = 0;
  for (const Level n : {1u, 4u, 8u, 16u}) wrong += wrong_on_floats("reference-f32", n, first_samples);
  EXPECT_GT(wrong, 0u);
}

TEST(ExactSubjects, AreRightOnTheSameFloats) {
  for (const char* name : {"reference", "reference-wide", "step", "impl"})
    for (const Level n : {0u, 1u, 8u, 15u, 16u})
      EXPECT_EQ(wrong_on_floats(name, n, 3'500), 0u) << name << " level " << n;
}

// A sample meets the same pair more than once; a list of counterexamples that says one of them three times is
// short of two.
TEST(Samples, CounterexamplesAreDifferentCases) {
  const auto subject = index::built_in("step-f32");
  const Tally tally = index::exact_on_floats(*subject, 5, keeping(6), 200'000);
  std::set<std::string> cases;
  for (const Counterexample& c : tally.found()) cases.insert(c.at);
  EXPECT_EQ(tally.found().size(), 6u);
  EXPECT_EQ(cases.size(), tally.found().size());
}

/// Gives every point index 0, and presses Ctrl-C after a while.
SubjectPtr zero(int calls_until_interrupt) {
  index::Functions functions;
  const auto calls = std::make_shared<std::atomic<int>>(calls_until_interrupt);
  functions.index = [calls](Level, index::Batch, std::span<std::uint32_t> out) {
    if (--*calls == 0) std::raise(SIGINT);
    std::fill(out.begin(), out.end(), 0);
  };
  functions.index_at = [](Level, const points::RationalPoint&) { return 0u; };
  return std::make_shared<index::IndexSubject>("zero", "for a test", std::move(functions));
}

// A refutation without an input that shows it is worth nothing.
TEST(Bijective, AnInterruptedRefutationStillNamesItsCase) {
  const Report report = run_alone(*find_law("index.bijective"), zero(300), 9, 2);
  ASSERT_EQ(report.results.size(), 1u);
  const Result& r = report.results.front();
  EXPECT_TRUE(report.interrupted);
  if (r.verdict == Verdict::incomplete) return;  // as good an answer
  EXPECT_EQ(r.verdict, Verdict::refuted);
  for (const Counterexample& c : r.counterexamples) EXPECT_FALSE(c.at.empty());
}

TEST(Bijective, NamesTheFirstTriangleWhoseIndexWasTaken) {
  const InterruptGuard forgets_the_test_before;
  const Result r = run_level(*find_law("index.bijective"), *zero(0), 1, LawRun{});
  ASSERT_EQ(r.verdict, Verdict::refuted);
  EXPECT_EQ(r.mismatches(), 3u);  // four triangles, one index
  // Strips go from v = 0, upright before inverted: (1/8, 1/8) has 0 first, (5/8, 1/8) comes second.
  EXPECT_EQ(r.counterexamples.front().at, "i:u=5/8,v=1/8");
  EXPECT_EQ(r.counterexamples.front().got, "0, which i:u=1/8,v=1/8 has");
}

}  // namespace
