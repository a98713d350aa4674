// [release, night, long, first] A counterexample that a run prints is the same one when it is replayed.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "proofs/points/cells.hpp"
#include "tests/proofs/every_law.hpp"

namespace {

using namespace mmverify::tests;
using mmverify::proofs::points::cell_count;

/// The laws of the fast tier that are judged case by case.
using Replay = EveryLaw;
INSTANTIATE_TEST_SUITE_P(All, Replay, testing::ValuesIn(ids_of_laws([](const Law& law) {
                           return law.replay && !law.long_only;
                         })),
                         test_name);

/// A sweep ends with the first chunk that has a counterexample: a domain's other thousands are replayed the same way.
LawRun until_refuted(std::size_t errors) {
  LawRun run = keeping(errors);
  run.until_refuted = true;
  return run;
}

void expect_replayed(const Law& law, const Subject& subject, const Result& r) {
  for (const Counterexample& c : r.counterexamples) {
    const std::string where =
        law.id + " " + subject.name() + " level " + std::to_string(c.level) + " " + c.at;
    if (law.at_once.empty()) {
      EXPECT_EQ(c.level, r.level) << where;
    }
    EXPECT_FALSE(c.at.empty()) << where;
    try {
      const Replayed again = law.replay(subject, c.level, c.at);
      EXPECT_FALSE(again.holds) << where;
      EXPECT_EQ(again.expected, c.expected) << where;
      EXPECT_EQ(again.got, c.got) << where;
    } catch (const BadCase& error) {
      ADD_FAILURE() << where << ": " << error.what();
    }
  }
}

TEST_P(Replay, KillsItsMutantsShowsTheirCounterexamplesAndAcquitsTheRightSubject) {
  SKIP_WHAT_THIS_BUILD_LACKS(law);
  if (!law.at_once.empty()) SKIP_A_PROVERS_WORK_UNDER_SANITIZERS();
  SKIP_WHAT_TAKES_TOO_LONG_UNDER_SANITIZERS(law);
  Level highest = 0;
  for (const Mutant& mutant : law.mutants) {
    bool killed = false;
    if (sanitized && &mutant != &law.mutants.front()) break;  // the others run the same code
    for (Level n = mutant.levels.first; n <= mutant.levels.last; ++n) {
      Result r = run_level(law, *mutant.subject, n, until_refuted(5));
      if (r.verdict != Verdict::refuted) continue;
      ASSERT_FALSE(r.counterexamples.empty());
      killed = true;
      highest = std::max(highest, n);
      expect_replayed(law, *mutant.subject, r);
      if (sanitized) r.counterexamples.resize(1);
      for (const Counterexample& c : r.counterexamples) {
        const Replayed right = law.replay(*find_subject(law.subjects.front()), c.level, c.at);
        EXPECT_TRUE(right.holds) << mutant.name << " " << c.at;
        // Maps have no picture yet, the command line says so; of bakes, those that are judged at points have
        // one, and of attributes a crack.
        EXPECT_EQ(right.picture.starts_with("<?xml"), !right.picture.empty()) << mutant.name << " " << c.at;
        if (law.topic != "bake") {
          EXPECT_EQ(!right.picture.empty(), law.topic == "index" || law.id == "paper.two_levels_crack")
              << mutant.name << " " << c.at;
        }
      }
      break;
    }
    EXPECT_TRUE(killed) << mutant.name;
  }
  // A law whose other mutants are faults of tests/foreign has one of its own, at any level.
  if (!sanitized && law.tiers.fast.last > 3 && law.mutants.size() > 1) {
    EXPECT_GT(highest, 3u);
  }
}

// Also where an answer is wrong in rounded arithmetic, and where rounding moves the points themselves.
TEST_P(Replay, ShowsTheCounterexamplesOfEverySubject) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  // Representatives of level n have n+2 bits, binary16 holds 11; nested runs on those of level n+1.
  const Level rounded_by_binary16 = law.cases(9, LawRun{}) > cell_count(9) ? 9 : 10;
  for (const SubjectPtr& s : subjects()) {
    // Long samples run only the subjects that they are sure to refute.
    if (s->topic() != law.topic) continue;
    if (std::find(law.subjects.begin(), law.subjects.end(), s->name()) != law.subjects.end()) continue;
    if (law.topic == "bake" && s->name() != "centre-sample") continue;
    if (law.method == Method::sample && !s->name().starts_with("step-f")) continue;
    std::vector<Level> levels{4};
    if (law.method == Method::exhaustive) levels = {1, 2, 3, 4};
    if (law.topic == "vq") levels = {law.tiers.fast.first};  // each has as many cases
    if (law.topic == "bake") levels = {1};                   // in rationals, and with a picture each
    if (law.id == "tree.malformed") levels = {1};  // each of level 2's 65,536 maps is decoded dozens of times
    if (law.topic == "attribute") std::erase_if(levels, [&](Level n) { return n > law.tiers.fast.last; });
    if (s->name().ends_with("-f16")) levels.push_back(rounded_by_binary16);
    for (const Level n : levels) {
      const Result r = run_level(law, *s, n, until_refuted(law.topic == "bake" ? 4 : 40));
      if (r.verdict == Verdict::refuted) expect_replayed(law, *s, r);
    }
  }
}

TEST_P(Replay, RefusesACaseThatIsNone) {
  const Subject& subject = *find_subject(law.subjects.front());
  for (const char* at : {"", "nonsense", "k=", "k=-1", "k=64", "k=5x", "u=1/2", "u=2,v=0", "u=1/0,v=0"})
    EXPECT_THROW(law.replay(subject, 3, at), BadCase) << at;
}

}  // namespace
