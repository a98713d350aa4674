// [sanitized, first] proofs/engine: the sum of a sweep, the sweep, and what the runner makes of a law.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/kinds.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/engine/runner.hpp"

namespace {

using namespace mmverify::proofs;
using testing::ElementsAre;
using LawRun = Run;  // inside a test, Run is a member function of GoogleTest's

// ---- Random

TEST(Shuffled, IsAPermutationForEachKey) {
  for (const unsigned bits : {2u, 12u, 16u})
    for (std::uint32_t key = 0; key < 5; ++key) {
      std::vector<bool> met(std::size_t{1} << bits);
      for (std::uint32_t x = 0; x < met.size(); ++x) met[shuffled(x, bits, key)] = true;
      EXPECT_THAT(met, testing::Each(true)) << bits << " bits, key " << key;
    }
}

// Laws rely on this: no bit of one channel tells a bit of another. A quarter of the 21,846 numbers is 5,461.
TEST(Shuffled, HasBitsUnderTwoKeysThatAreIndependent) {
  for (std::uint32_t key = 1; key < 4; ++key)
    for (unsigned bit = 0; bit < 256; ++bit) {
      std::array<int, 4> count{};
      for (std::uint32_t x = 0; x < 65'536; x += 3)
        ++count[(shuffled(x, 16, 0) >> bit % 16 & 1) * 2 + (shuffled(x, 16, key) >> bit / 16 & 1)];
      EXPECT_THAT(count, testing::Each(testing::AllOf(testing::Gt(3'500), testing::Lt(7'500))))
          << key << ", " << bit;
    }
}

TEST(Random, HalfOfItsCodesAreCorners) {
  std::array<int, 256> count{};
  Random random(1, 2, 3);
  for (int k = 0; k < 30'000; ++k) ++count[random.code()];
  for (const std::size_t corner : {0u, 1u, 127u, 128u, 254u, 255u}) EXPECT_GT(count[corner], 2'300) << corner;
  EXPECT_THAT(count, testing::Each(testing::Gt(20)));
}

// ---- Tally

Counterexample named(const Simplicity& simplicity, const std::string& at) {
  return {simplicity, 3, at, {}, "1", "2"};
}

void fail(Tally& tally, Kind kind, const Simplicity& simplicity, const std::string& at) {
  tally.mismatch(kind, simplicity, [&] { return named(simplicity, at); });
}

std::vector<std::string> cases_of(const std::vector<Counterexample>& found) {
  std::vector<std::string> cases;
  for (const Counterexample& c : found) cases.push_back(c.at);
  return cases;
}

TEST(Tally, KeepsTheSimplestAndCountsAll) {
  Tally tally(2);
  tally.count(Kind::vertex, 10);
  fail(tally, Kind::vertex, {5, 0, 0}, "c");
  fail(tally, Kind::edge, {2, 9, 0}, "a");
  fail(tally, Kind::edge, {2, 9, 1}, "b");
  fail(tally, Kind::interior, {7, 0, 0}, "d");
  EXPECT_THAT(cases_of(tally.found()), ElementsAre("a", "b"));
  EXPECT_EQ(tally.by_kind(), (CountByKind{Count{10, 1}, Count{0, 2}, Count{0, 1}}));
}

// Describing a case may cost much more than judging it.
TEST(Tally, DescribesOnlyWhatItKeeps) {
  Tally tally(1);
  fail(tally, Kind::edge, {1, 0, 0}, "a");
  tally.mismatch(Kind::edge, {2, 0, 0}, []() -> Counterexample { throw std::logic_error("described"); });
  Tally none(0);
  none.mismatch(Kind::edge, {0, 0, 0}, []() -> Counterexample { throw std::logic_error("described"); });
  EXPECT_EQ(none.by_kind()[1].mismatches, 1u);
}

TEST(Tally, OrderOfMergingDoesNotMatter) {
  std::vector<Tally> parts;
  for (std::uint64_t k = 0; k < 5; ++k) {
    Tally part(3);
    part.count(Kind::interior, k + 1);
    part.digest(k, 7 * k);
    fail(part, Kind::interior, {10 - k, k, 0}, "first of " + std::to_string(k));
    fail(part, Kind::edge, {k, 0, 0}, "second of " + std::to_string(k));
    if (k == 4) fail(part, Kind::vertex, {20, 0, 0}, "a vertex");
    parts.push_back(part);
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  do {
    Tally sum(3);
    for (const std::size_t k : order) sum.merge(parts[k]);
    // 1+2+3+4+5 cases; the simplest are the second ones of 0, 1 and 2.
    ASSERT_EQ(sum.by_kind(), (CountByKind{Count{0, 1}, Count{0, 5}, Count{15, 5}}));
    ASSERT_THAT(cases_of(sum.found()), ElementsAre("second of 0", "second of 1", "second of 2"));
    Tally direct;
    for (std::uint64_t k = 0; k < 5; ++k) direct.digest(k, 7 * k);
    ASSERT_EQ(sum.digest(), direct.digest());
  } while (std::next_permutation(order.begin(), order.end()));
}

// Two inputs may be equally simple (samples are); which of them is kept must not depend on which thread came
// first.
TEST(Tally, EquallySimpleCasesAreKeptByTheirText) {
  Tally one_by_one(1), other_way(1), a(1), b(1);
  fail(one_by_one, Kind::edge, {1, 1, 1}, "b");
  fail(one_by_one, Kind::edge, {1, 1, 1}, "a");
  fail(other_way, Kind::edge, {1, 1, 1}, "a");
  fail(other_way, Kind::edge, {1, 1, 1}, "b");
  fail(a, Kind::edge, {1, 1, 1}, "a");
  fail(b, Kind::edge, {1, 1, 1}, "b");
  b.merge(a);
  EXPECT_THAT(cases_of(b.found()), ElementsAre("a"));
  EXPECT_THAT(cases_of(other_way.found()), ElementsAre("a"));
  EXPECT_THAT(cases_of(one_by_one.found()), ElementsAre("a"));
}

TEST(Tally, DigestSeesAChangedAnswerAndTwoThatChangePlaces) {
  const auto digest = [](std::array<std::uint64_t, 3> answers) {
    Tally tally;
    for (std::uint64_t k = 0; k < 3; ++k) tally.digest(k, answers[k]);
    return tally.digest();
  };
  const std::uint64_t right = digest({4, 5, 6});
  EXPECT_NE(right, digest({4, 5, 7}));
  EXPECT_NE(right, digest({5, 4, 6}));
  EXPECT_NE(digest({0, 0, 0}), Tally().digest());
}

// ---- sweep

/// Clears an interrupt that a test before it in this process left behind.
class Engine : public testing::Test {
 protected:
  Engine() { const InterruptGuard clears_what_was_raised; }
};
using Sweep = Engine;
using Runner = Engine;

constexpr std::uint64_t chunk_size = 64;

// Lets an arena have its threads on a machine with fewer cores.
const oneapi::tbb::global_control more_threads_than_cores(
    oneapi::tbb::global_control::max_allowed_parallelism, 4);

TEST_F(Sweep, JudgesEveryUnitExactlyOnceAtChunkBorders) {
  for (const std::uint64_t units : {0u, 1u, 63u, 64u, 65u, 640u})
    for (const int threads : {0, 1, 2, 3}) {
      oneapi::tbb::task_arena arena(std::max(threads, 1));
      LawRun run;
      run.arena = threads == 0 ? nullptr : &arena;
      std::vector<std::atomic<int>> judged(units);
      std::atomic<std::uint64_t> misplaced = 0, chunks = 0;
      const Tally tally = sweep(run, units, chunk_size, [&](Chunk chunk, Tally& part) {
        ++chunks;
        const bool whole = chunk.end - chunk.begin == chunk_size || chunk.end == units;
        if (chunk.begin % chunk_size != 0 || chunk.end > units || chunk.begin >= chunk.end || !whole)
          ++misplaced;
        for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) ++judged[k];
        part.count(Kind::interior, chunk.end - chunk.begin);
      });
      EXPECT_EQ(misplaced, 0u) << units;
      EXPECT_EQ(chunks, (units + 63) / 64) << units;
      EXPECT_EQ(tally.cases(), units);
      EXPECT_TRUE(std::all_of(judged.begin(), judged.end(), [](const auto& times) { return times == 1; }))
          << units;
    }
}

TEST_F(Sweep, SameTallyForAnyNumberOfThreads) {
  const auto swept = [](oneapi::tbb::task_arena* arena) {
    LawRun run;
    run.arena = arena;
    run.errors = 4;
    return sweep(run, 10'001, 7, [](Chunk chunk, Tally& tally) {
      for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
        tally.count(Kind::vertex, 1);
        tally.digest(k, k * k);
        // Late chunks hold the simpler cases.
        if (k % 97 == 0) fail(tally, Kind::vertex, {20'000 - k, 0, 0}, std::to_string(k));
      }
    });
  };
  const Tally alone = swept(nullptr);
  // 97 * 103 = 9991 is the last multiple.
  EXPECT_THAT(cases_of(alone.found()), ElementsAre("9991", "9894", "9797", "9700"));
  EXPECT_EQ(alone.by_kind()[0], (Count{10'001, 104}));
  for (const int threads : {1, 2, 3}) {
    oneapi::tbb::task_arena arena(threads);
    const Tally tally = swept(&arena);
    EXPECT_EQ(tally.digest(), alone.digest()) << threads;
    EXPECT_EQ(tally.by_kind(), alone.by_kind()) << threads;
    EXPECT_EQ(cases_of(tally.found()), cases_of(alone.found())) << threads;
  }
}

// ---- The runner, on a law of its own

class Named : public Subject {
 public:
  explicit Named(const std::string& name) : Subject("test", name, "for a test") {}
  bool exact() const override { return true; }
};

using Judge = std::function<Tally(const Subject&, Level, const LawRun&)>;

SubjectPtr subject(const std::string& name) { return std::make_shared<Named>(name); }

/// A law of 1000 cases a level.
Law law_judged_by(Judge judge, Method method = Method::exhaustive) {
  Law law;
  law.id = "test.law";
  law.topic = "test";
  law.method = method;
  law.cases = [](Level, const LawRun&) -> std::uint64_t { return 1000; };
  law.domain = [](const Subject&, Level) { return std::string("numbers"); };
  law.how = [](const Subject&, Level) { return std::string("counting"); };
  law.unfit = [](const Subject&, Level) -> std::optional<std::string> { return std::nullopt; };
  law.judge = std::move(judge);
  return law;
}

Tally counting(const LawRun& run, std::uint64_t cases) {
  return sweep(run, cases, 10,
               [](Chunk chunk, Tally& tally) { tally.count(Kind::edge, chunk.end - chunk.begin); });
}

Tally all_right(const Subject&, Level, const LawRun& run) { return counting(run, 1000); }

Tally wrong_from_level_2(const Subject&, Level n, const LawRun& run) {
  Tally tally = counting(run, 1000);
  if (n >= 2) fail(tally, Kind::edge, {n, 0, 0}, "k=" + std::to_string(n));
  return tally;
}

/// `mutant` is wrong from level 2 on, everybody else right.
Tally wrong_if_mutant(const Subject& s, Level n, const LawRun& run) {
  return s.name() == "mutant" ? wrong_from_level_2(s, n, run) : all_right(s, n, run);
}

RunOptions quiet(unsigned threads = 2) {
  RunOptions options;
  options.threads = threads;
  options.show_progress = false;
  return options;
}

void nothing(const Result&) {}

TEST_F(Runner, VerdictsOfAPassAndOfAFailure) {
  EXPECT_EQ(run_level(law_judged_by(all_right), Named("s"), 0, LawRun{}).verdict, Verdict::proved);
  EXPECT_EQ(run_level(law_judged_by(all_right, Method::witness), Named("s"), 0, LawRun{}).verdict,
            Verdict::proved);
  EXPECT_EQ(run_level(law_judged_by(all_right, Method::sample), Named("s"), 0, LawRun{}).verdict,
            Verdict::checked);

  const Result r = run_level(law_judged_by(wrong_from_level_2), Named("s"), 2, LawRun{});
  EXPECT_EQ(r.verdict, Verdict::refuted);
  EXPECT_EQ(r.cases_run(), 1000u);
  EXPECT_EQ(r.cases_expected, 1000u);
  EXPECT_EQ(r.mismatches(), 1u);
  EXPECT_EQ(r.law + " " + r.subject + " " + r.domain + " " + r.method, "test.law s numbers counting");
}

// A law that lost or doubled a case is an error of the program, never a proof.
TEST_F(Runner, MiscountedCasesAreALogicError) {
  for (const std::uint64_t cases : {0u, 999u, 1001u})
    EXPECT_THROW(run_level(law_judged_by([=](const Subject&, Level, const LawRun& run) {
                             return counting(run, cases);
                           }),
                           Named("s"), 0, LawRun{}),
                 std::logic_error)
        << cases;
}

TEST_F(Runner, ASubjectThatBreaksIsBroken) {
  const auto breaks = [](const Subject&, Level, const LawRun& run) -> Tally {
    return sweep(run, 1000, 10, [](Chunk, Tally&) { throw SubjectBroken("it hung at k=5"); });
  };
  const Law law = law_judged_by(breaks);
  const Report report = run_jobs({{&law, subject("s"), {0, 1}, {}}}, quiet(), nothing);
  ASSERT_FALSE(report.results.empty());
  for (const Result& r : report.results) EXPECT_EQ(r.verdict, Verdict::broken);
  EXPECT_EQ(report.results.front().reason, "it hung at k=5");
}

TEST_F(Runner, RunsTheLevelsInOrderAndTellsEach) {
  const Law law = law_judged_by(wrong_from_level_2);
  std::vector<Level> told;
  const Report report = run_jobs({{&law, subject("s"), {1, 3}, {}}}, quiet(),
                                 [&](const Result& r) { told.push_back(r.level); });
  EXPECT_THAT(told, ElementsAre(1, 2, 3));
  ASSERT_EQ(report.results.size(), 3u);
  EXPECT_EQ(report.results[0].verdict, Verdict::proved);
  EXPECT_EQ(report.results[1].verdict, Verdict::refuted);
  EXPECT_EQ(report.results[2].verdict, Verdict::refuted);
  EXPECT_EQ(report.threads, 2u);
  EXPECT_FALSE(report.interrupted);
}

TEST_F(Runner, LevelsThatDoNotFitAreNotApplicable) {
  Law law = law_judged_by(all_right);
  law.unfit = [](const Subject&, Level n) { return n > 1 ? std::optional("too high") : std::nullopt; };
  const Report some = run_jobs({{&law, subject("s"), {1, 2}, {}}}, quiet(), nothing);
  ASSERT_EQ(some.results.size(), 2u);
  EXPECT_EQ(some.results[0].verdict, Verdict::proved);
  EXPECT_EQ(some.results[1].verdict, Verdict::not_applicable);
  EXPECT_EQ(some.results[1].reason, "too high");

  // No level at all: said once.
  const Report none = run_jobs({{&law, subject("s"), {2, 9}, {}}}, quiet(), nothing);
  ASSERT_EQ(none.results.size(), 1u);
  EXPECT_EQ(none.results[0].verdict, Verdict::not_applicable);
  EXPECT_EQ(none.results[0].reason, "too high");
  EXPECT_EQ(none.results[0].cases_run(), 0u);

  const Report other = run_jobs({{&law, subject("s"), {0, 1}, "about others"}}, quiet(), nothing);
  ASSERT_EQ(other.results.size(), 1u);
  EXPECT_EQ(other.results[0].reason, "about others");
}

TEST_F(Runner, MutantsAreKilledAtTheirLowestLevelOrReportedAsSurvivors) {
  Law law = law_judged_by(wrong_if_mutant);
  law.mutants = {{"wrong from 2", subject("mutant"), {0, 5}},
                 {"not wrong yet", subject("mutant"), {0, 1}},
                 {"not wrong", subject("innocent"), {0, 5}}};
  const Report report = run_jobs({{&law, subject("s"), {0, 0}, {}}}, quiet(), nothing);
  ASSERT_EQ(report.mutants.size(), 3u);
  EXPECT_TRUE(report.mutants[0].killed);
  EXPECT_EQ(report.mutants[0].level, 2u);
  EXPECT_EQ(report.mutants[0].at, "k=2");
  EXPECT_EQ(report.mutants[0].law, "test.law");
  EXPECT_FALSE(report.mutants[1].killed);
  EXPECT_FALSE(report.mutants[2].killed);
}

// Otherwise a seed could make a law look unable to fail.
TEST_F(Runner, MutantsRunOnTheDefaultSample) {
  std::mutex lock;
  std::vector<std::pair<std::uint64_t, Tier>> asked;
  Law law = law_judged_by([&](const Subject& s, Level n, const LawRun& run) {
    if (s.name() == "mutant") {
      const std::lock_guard hold(lock);
      asked.emplace_back(run.seed, run.tier);
    }
    return wrong_if_mutant(s, n, run);
  });
  law.mutants = {{"wrong from 2", subject("mutant"), {2, 2}}};
  RunOptions options = quiet();
  options.seed = 7;
  options.tier = Tier::long_run;
  run_jobs({{&law, subject("s"), {0, 0}, {}}}, options, nothing);
  EXPECT_THAT(asked, ElementsAre(std::pair(RunOptions().seed, Tier::fast)));
}

TEST_F(Runner, ALawsMutantsRunOnceHoweverManyJobsItHas) {
  Law law = law_judged_by(wrong_if_mutant);
  law.mutants = {{"wrong from 2", subject("mutant"), {2, 2}}};
  const Report report =
      run_jobs({{&law, subject("a"), {0, 0}, {}}, {&law, subject("b"), {0, 0}, {}}}, quiet(), nothing);
  EXPECT_EQ(report.results.size(), 2u);
  EXPECT_EQ(report.mutants.size(), 1u);
}

// The first law ends only after the second, dearer one has begun: one after another, it would wait in vain.
TEST_F(Runner, JobsSideBySideAreReportedInTheirOrder) {
  std::atomic<bool> second_began = false, met = false;
  Law first = law_judged_by([&](const Subject&, Level n, const LawRun& run) {
    for (int k = 0; n == 0 && k < 10'000 && !second_began; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    met = met || second_began;
    return counting(run, 1000);
  });
  Law second = law_judged_by([&](const Subject& s, Level n, const LawRun& run) {
    second_began = true;
    return wrong_from_level_2(s, n, run);
  });
  second.id = "test.dearer";
  second.tiers.seconds = 1;
  const std::vector<Job> jobs{{&first, subject("s"), {0, 1}, {}},
                              {&first, subject("other"), {0, 0}, "about others"},
                              {&second, subject("s"), {1, 2}, {}}};
  RunOptions options = quiet(2);
  options.side_by_side = true;
  std::vector<std::string> told;
  const auto name = [](const Result& r) { return r.law + " " + std::to_string(r.level); };
  const Report report = run_jobs(jobs, options, [&](const Result& r) { told.push_back(name(r)); });
  EXPECT_TRUE(met);
  EXPECT_THAT(told, ElementsAre("test.law 0", "test.law 1", "test.law 0", "test.dearer 1", "test.dearer 2"));
  ASSERT_EQ(report.results.size(), 5u);
  for (std::size_t k = 0; k < told.size(); ++k) EXPECT_EQ(name(report.results[k]), told[k]);
  EXPECT_EQ(report.results[2].verdict, Verdict::not_applicable);
  EXPECT_EQ(report.results[4].verdict, Verdict::refuted);
}

// The job ends only after the mutant's run has begun: after all jobs, it would wait in vain.
TEST_F(Runner, MutantsRunBesideJobsAndTheirTimesFollow) {
  std::atomic<bool> mutant_began = false, met = false;
  Law law = law_judged_by([&](const Subject& s, Level n, const LawRun& run) {
    if (s.name() == "mutant") {
      mutant_began = true;
    } else {
      for (int k = 0; k < 5'000 && !mutant_began; ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      met = met || mutant_began;
    }
    return wrong_if_mutant(s, n, run);
  });
  law.mutants = {{"wrong from 2", subject("mutant"), {1, 3}}};
  RunOptions options = quiet(2);
  options.side_by_side = true;
  const Report report =
      run_jobs({{&law, subject("s"), {0, 1}, {}}, {&law, subject("t"), {0, 0}, "unfit"}}, options, nothing);
  EXPECT_TRUE(met);
  ASSERT_EQ(report.mutants.size(), 1u);
  EXPECT_EQ(report.mutants[0].level, 2u);
  // An unfit job takes no time that is told.
  ASSERT_EQ(report.spent.size(), 2u);
  EXPECT_EQ(report.spent[0].subject, "s");
  EXPECT_EQ(report.spent[1].subject, "wrong from 2");
  EXPECT_TRUE(report.spent[1].mutant && !report.spent[0].mutant);
}

// The path of a task has the longest part of each sweep, and not the sum of all parts.
TEST_F(Runner, TheTimeOfATaskIsThatOfAllItsThreads) {
  const auto busy = [](const Subject&, Level, const LawRun& run) {
    return sweep(run, 1000, 100, [](Chunk chunk, Tally& tally) {
      const std::clock_t until = std::clock() + CLOCKS_PER_SEC / 50;
      while (std::clock() < until) continue;
      tally.count(Kind::edge, chunk.end - chunk.begin);
    });
  };
  const Law law = law_judged_by(busy);
  const Report report = run_jobs({{&law, subject("s"), {0, 0}, {}}}, quiet(2), nothing);
  ASSERT_EQ(report.spent.size(), 1u);
  EXPECT_GT(report.spent[0].processor, 0.0);
  EXPECT_LE(report.spent[0].path, report.spent[0].processor);
  EXPECT_GT(report.spent[0].path, 0.0);
  EXPECT_LT(report.spent[0].path, 0.9 * report.spent[0].processor);
}

// The machine's lack ends the run: jobs that have not begun have no result, jobs that have finished keep theirs.
TEST_F(Runner, ALackOfResourcesEndsJobsSideBySide) {
  Law lacks =
      law_judged_by([](const Subject&, Level, const LawRun&) -> Tally { throw NoResources("no memory"); });
  lacks.tiers.seconds = 1;
  const Law law = law_judged_by(all_right);
  RunOptions options = quiet(1);
  options.side_by_side = true;
  const Report report =
      run_jobs({{&law, subject("s"), {0, 0}, {}}, {&lacks, subject("s"), {0, 3}, {}}}, options, nothing);
  EXPECT_EQ(report.gave_up, "no memory");
  ASSERT_EQ(report.results.size(), 1u);
  EXPECT_EQ(report.results[0].verdict, Verdict::incomplete);
  EXPECT_EQ(report.results[0].reason, "no memory");
}

// ---- Interrupts

/// Counts its cases; in level 1 raises the signal at case 200 or beyond, where every other chunk waits for
/// it.
Judge raising(int signal) {
  return
      [=, raised = std::make_shared<std::atomic<bool>>(false)](const Subject& s, Level n, const LawRun& run) {
        return sweep(run, 1000, 10, [&](Chunk chunk, Tally& tally) {
          if (n == 1 && chunk.begin >= 200 && s.name() == "s") {
            if (!raised->exchange(true)) std::raise(signal);
            while (!interrupted()) std::this_thread::yield();
          }
          tally.count(Kind::edge, chunk.end - chunk.begin);
        });
      };
}

class Interrupted : public Engine, public testing::WithParamInterface<int> {};

TEST_P(Interrupted, WhatIsUnfinishedIsIncompleteAndNeverProved) {
  for (const unsigned threads : {1u, 2u}) {
    Law law = law_judged_by(raising(GetParam()));
    law.mutants = {{"never judged", subject("mutant"), {0, 5}}};
    const Report report = run_jobs({{&law, subject("s"), {0, 3}, {}}}, quiet(threads), nothing);
    EXPECT_TRUE(report.interrupted);
    ASSERT_EQ(report.results.size(), 4u);
    EXPECT_EQ(report.results[0].verdict, Verdict::proved);
    for (const Level n : {1u, 2u, 3u}) {
      EXPECT_EQ(report.results[n].verdict, Verdict::incomplete) << n;
      EXPECT_EQ(report.results[n].reason, "interrupted");
      EXPECT_LT(report.results[n].cases_run(), 1000u);
    }
    EXPECT_GT(report.results[1].cases_run(), 0u);
    EXPECT_EQ(report.results[2].cases_run(), 0u);
    // A mutant that was not judged has not survived.
    EXPECT_TRUE(report.mutants.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values(SIGINT, SIGTERM),
                         [](const auto& signal) { return signal.param == SIGINT ? "SIGINT" : "SIGTERM"; });

// A failure that was seen stays one.
TEST_F(Runner, AnInterruptedFailureIsRefuted) {
  const Law law = law_judged_by([](const Subject&, Level, const LawRun& run) {
    std::raise(SIGINT);
    Tally tally = counting(run, 1000);
    fail(tally, Kind::edge, {0, 0, 0}, "k=0");
    return tally;
  });
  const Report report = run_jobs({{&law, subject("s"), {0, 0}, {}}}, quiet(), nothing);
  ASSERT_EQ(report.results.size(), 1u);
  EXPECT_EQ(report.results[0].verdict, Verdict::refuted);
  EXPECT_TRUE(report.interrupted);
}

TEST_F(Runner, AnInterruptEndsWithItsRun) {
  const Law raises = law_judged_by(raising(SIGINT)), law = law_judged_by(all_right);
  EXPECT_TRUE(run_jobs({{&raises, subject("s"), {1, 1}, {}}}, quiet(), nothing).interrupted);
  const Report next = run_jobs({{&law, subject("s"), {0, 0}, {}}}, quiet(), nothing);
  EXPECT_FALSE(next.interrupted);
  EXPECT_EQ(next.results[0].verdict, Verdict::proved);
}

// A guard around the run has seen it already, while a library was loaded, say.
TEST_F(Runner, WhatCameBeforeItsRunEndsItToo) {
  const InterruptGuard around;
  std::raise(SIGTERM);
  const Law law = law_judged_by(all_right);
  const Report report = run_jobs({{&law, subject("s"), {0, 0}, {}}}, quiet(), nothing);
  EXPECT_TRUE(report.interrupted);
  EXPECT_EQ(report.results[0].verdict, Verdict::incomplete);
}

// The second Ctrl-C ends the process, whatever it is at.
TEST(InterruptDeathTest, TheSecondSignalEndsTheProcess) {
  EXPECT_EXIT(
      {
        const InterruptGuard guard;
        std::raise(SIGINT);
        std::this_thread::sleep_for(std::chrono::milliseconds(400));
        std::raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

// timeout(1) signals its child, and at once the group that holds it.
TEST(InterruptDeathTest, TwoSignalsAtOnceAreOneWish) {
  EXPECT_EXIT(
      {
        const InterruptGuard guard;
        std::raise(SIGTERM);
        std::raise(SIGTERM);
        std::_Exit(interrupted() ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

// ---- Verdicts

TEST(Verdict, NamesAreThoseOfTheResultFormat) {
  EXPECT_EQ(to_string(Verdict::proved), "proved");
  EXPECT_EQ(to_string(Verdict::refuted), "refuted");
  EXPECT_EQ(to_string(Verdict::checked), "checked");
  EXPECT_EQ(to_string(Verdict::broken), "broken");
  EXPECT_EQ(to_string(Verdict::not_applicable), "not_applicable");
  EXPECT_EQ(to_string(Verdict::incomplete), "incomplete");
}

}  // namespace
