// [sanitized] proofs/engine/breaks: a case on which a subject crashes does not end the law, and is never held for right.
#include "proofs/engine/breaks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "proofs/engine/cases.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/journal.hpp"
#include "proofs/engine/kinds.hpp"
#include "proofs/engine/runner.hpp"
#include "tests/folder.hpp"

namespace breaks_test {

using namespace mmverify::proofs;
using testing::ElementsAre;

class Fragile : public Subject {
 public:
  Fragile() : Subject("test", "fragile", "breaks on some numbers") {}
  bool exact() const override { return true; }
};

/// A law of 2000 numbers a level, in chunks of 10.
Law law_of(const std::function<Finding(Level, std::uint64_t)>& check) {
  Law law;
  law.id = "test.fragile";
  law.topic = "test";
  law.method = Method::exhaustive;
  law.domain = [](const Subject&, Level) { return std::string("numbers"); };
  law.unfit = [](const Subject&, Level) -> std::optional<std::string> { return std::nullopt; };
  NumberedCases cases;
  cases.count = [](Level, const Run&) -> std::uint64_t { return 2000; };
  cases.check = [check](const Subject&, Level n, std::uint64_t k, const Run&) { return check(n, k); };
  cases.text = [](const Subject&, Level, std::uint64_t k, const Run&) { return "k=" + std::to_string(k); };
  cases.chunk = 10;
  cases.kind = Kind::interior;
  return on_numbered_cases(law, cases);
}

Finding broken_on(std::uint64_t k, bool hung = false) {
  throw mmverify::dock::CaseBroken("crashed on k=" + std::to_string(k), hung);
}

Report run_with(const Law& law, unsigned threads, Journal* journal = nullptr) {
  RunOptions options;
  options.threads = threads;
  options.show_progress = false;
  options.mutants = false;
  options.journal = journal;
  return run_jobs({{&law, std::make_shared<Fragile>(), {0, 2}, {}}}, options, [](const Result&) {});
}

class BrokenCases : public testing::Test {
  const InterruptGuard guard_;
};

TEST_F(BrokenCases, AreNamedInTheirOrderAndTheOthersJudged) {
  const Law law = law_of([](Level n, std::uint64_t k) {
    if (n == 1 && (k == 1234 || k == 70 || k == 71)) broken_on(k);
    return Finding{k};
  });
  for (const unsigned threads : {1u, 2u, 4u}) {
    const Report report = run_with(law, threads);
    ASSERT_EQ(report.results.size(), 3u) << "the levels above are judged";
    EXPECT_EQ(report.results[0].verdict, Verdict::proved);
    EXPECT_EQ(report.results[2].verdict, Verdict::proved);
    const Result& r = report.results[1];
    EXPECT_EQ(r.verdict, Verdict::broken);
    EXPECT_EQ(r.reason, "crashed on k=70");
    EXPECT_THAT(r.breaks, ElementsAre("crashed on k=70", "crashed on k=71", "crashed on k=1234"));
    EXPECT_EQ(r.cases_run(), 2000u);
    EXPECT_EQ(r.declined(), 0u);
    EXPECT_EQ(r.by_kind[static_cast<std::size_t>(Kind::interior)].unjudged, 3u);
  }
}

/// The same numbers, asked a chunk at a time: a chunk that holds one of `broken` is not answered.
Law law_in_batches(const std::vector<std::uint64_t>& broken, std::uint64_t wrong_one) {
  Law law = law_of([](Level, std::uint64_t k) { return Finding{k}; });
  law.judge = [=](const Subject&, Level n, const Run& run) {
    return sweep(
        run, 2000, 64,
        [&](Chunk chunk, Tally& tally) {
          for (const std::uint64_t k : broken)
            if (n == 1 && k >= chunk.begin && k < chunk.end) broken_on(k);
          for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
            tally.count(Kind::interior, 1);
            tally.digest(k, k);
            if (k == wrong_one)
              tally.mismatch(Kind::interior, {k, 0, 0}, [&] {
                return Counterexample{{k, 0, 0}, n, "k=" + std::to_string(k), {}, "right", "wrong"};
              });
          }
        },
        as_one_case(Kind::edge));
  };
  return law;
}

TEST_F(BrokenCases, AreFoundInABatchByHalves) {
  constexpr std::uint64_t none = 5000;
  const Law law = law_in_batches({1234, 70, 71}, none);
  for (const unsigned threads : {1u, 2u, 4u}) {
    const Report report = run_with(law, threads);
    ASSERT_EQ(report.results.size(), 3u);
    const Result& r = report.results[1];
    EXPECT_EQ(r.verdict, Verdict::broken);
    EXPECT_THAT(r.breaks, ElementsAre("crashed on k=70", "crashed on k=71", "crashed on k=1234"));
    EXPECT_EQ(r.cases_run(), 2000u);
    EXPECT_EQ(r.by_kind[static_cast<std::size_t>(Kind::edge)].unjudged, 3u);
    EXPECT_EQ(r.declined(), 0u);
    EXPECT_EQ(report.results[2].verdict, Verdict::proved);
    std::uint64_t digest = 0;
    for (std::uint64_t k = 0; k < 2000; ++k)
      if (k != 1234 && k != 70 && k != 71) digest += Tally::digest_of(k, k);
    EXPECT_EQ(r.digest, digest) << "each of the others is judged once";
  }
}

TEST_F(BrokenCases, HideNoWrongAnswerInTheirBatch) {
  const Report report = run_with(law_in_batches({70}, 71), 2);
  EXPECT_EQ(report.results[1].verdict, Verdict::refuted);
  EXPECT_EQ(report.results[1].mismatches(), 1u);
  EXPECT_THAT(report.results[1].breaks, ElementsAre("crashed on k=70"));
}

TEST_F(BrokenCases, HideNoWrongAnswer) {
  const Law law = law_of([](Level, std::uint64_t k) {
    if (k == 5) broken_on(k);
    return k == 9 ? wrong("9", "8") : Finding{k};
  });
  const Report report = run_with(law, 2);
  EXPECT_EQ(report.results.front().verdict, Verdict::refuted);
  EXPECT_EQ(report.results.front().counterexamples.front().at, "k=9");
  EXPECT_THAT(report.results.front().breaks, ElementsAre("crashed on k=5"));
}

TEST_F(BrokenCases, EndALawWhereTheyAreTooMany) {
  const Law all = law_of([](Level, std::uint64_t k) { return broken_on(k); });
  const Law slow =
      law_of([](Level, std::uint64_t k) { return k % 500 == 0 ? broken_on(k, true) : Finding{k}; });
  for (const unsigned threads : {1u, 2u, 4u})
    for (const Law* law : {&all, &slow}) {
      const Report report = run_with(*law, threads);
      ASSERT_EQ(report.results.size(), 1u);
      EXPECT_EQ(report.results.front().verdict, Verdict::broken);
      EXPECT_TRUE(report.results.front().breaks.empty());
    }
  EXPECT_EQ(run_with(all, 4).results.front().reason, "crashed on k=0");
}

// A journal that forgot them would make a proof of what is left.
TEST_F(BrokenCases, AreAskedAgainByTheRunThatGoesOn) {
  const mmverify::tests::Folder folder;
  std::uint64_t asked = 0;
  const Law law = law_of([&asked](Level n, std::uint64_t k) {
    ++asked;
    return n == 0 && k == 500 ? broken_on(k) : Finding{k};
  });
  for (int round = 0; round < 2; ++round) {
    Journal journal(folder / "journal", {{"program", "1"}});
    asked = 0;
    const Report report = run_with(law, 1, &journal);
    EXPECT_EQ(report.results.front().verdict, Verdict::broken) << round;
    EXPECT_EQ(report.results.front().cases_run(), 2000u);
  }
  EXPECT_GT(asked, 0u);
  EXPECT_LT(asked, 200u) << "the rest is in the journal";
}

}  // namespace breaks_test
