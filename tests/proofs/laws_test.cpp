// [long, first] The laws as a list, and each of them: it holds over its whole domain, and it can fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <set>
#include <string>

#include "proofs/registry/topics.hpp"
#include "tests/proofs/every_law.hpp"

namespace {

using namespace mmverify::tests;

/// The most cases that a test runs; the sanitized build runs small levels only.
constexpr std::uint64_t few = 2'000;
constexpr Level small = 5;

/// The release build's program runs each law over its whole domain, and each mutant: ./run prove says so, and ./run gate holds
/// verdicts, counts, digests and mutants to a baseline.
#define LEAVE_TO_THE_GATE() \
  if (!sanitized) GTEST_SKIP() << "./run gate runs it, and holds it to a baseline"

/// A part of a domain that has many times as many chunks; never empty, as the first parts of a small one are.
constexpr Shard last_eighth{8, 8};

TEST(Laws, TheDesignsOnesAreThere) {
  for (const char* id : {"index.equals_reference", "index.in_range", "index.bijective", "index.nested",
                         "index.contiguous", "index.inverse", "index.exact_on_floats"})
    EXPECT_NE(find_law(id), nullptr) << id;
  EXPECT_FALSE(laws_named("paper").empty());
  EXPECT_EQ(find_law("index"), nullptr);
  EXPECT_FALSE(laws_named("index").empty());
  EXPECT_TRUE(laws_named("index.").empty());
  EXPECT_TRUE(laws_named("").empty());
  EXPECT_TRUE(laws_named("no.such.law").empty());
}

TEST(Laws, TheDesignsSubjectsAreThere) {
  for (const char* name : {"reference", "step", "step-appendix-middle", "step-appendix-ties",
                           "step-appendix-names", "step-restarted", "reference-f16", "reference-f32",
                           "reference-f64", "step-f16", "step-f32", "step-f64", "reference-wide", "impl"})
    EXPECT_NE(find_subject(name), nullptr) << name;
  EXPECT_EQ(find_subject("nobody"), nullptr);
}

// Each row of the table of topics is true: nothing else looks a topic's laws and subjects up.
TEST(Topics, ARowSaysWhatItsTopicHas) {
  std::set<std::string> names, kinds, benches;
  for (const Topic& topic : topics()) {
    EXPECT_TRUE(names.insert(topic.name).second) << topic.name;
    for (const std::string& kind : topic.kinds) EXPECT_TRUE(kinds.insert(kind).second) << kind;
    if (topic.bench != nullptr) {
      EXPECT_TRUE(benches.insert(topic.bench).second) << topic.bench;
    }
    std::set<std::string> families;
    for (const Law& law : topic.laws()) {
      EXPECT_EQ(find_law(law.id)->topic, topic.name) << law.id;
      EXPECT_LE(law.tiers.long_run.last, topic.highest) << law.id;
      families.insert(law.id.substr(0, law.id.find('.')));
    }
    EXPECT_EQ(families, std::set<std::string>(topic.families.begin(), topic.families.end())) << topic.name;
    EXPECT_FALSE(topic.subjects().empty()) << topic.name;
    for (const SubjectPtr& subject : topic.subjects())
      EXPECT_EQ(subject->topic(), topic.name) << subject->name();
  }
}

TEST(Laws, IdsAndSubjectsAreUnique) {
  std::set<std::string> ids, names;
  for (const Law& law : laws()) EXPECT_TRUE(ids.insert(law.id).second) << law.id;
  for (const SubjectPtr& s : subjects()) EXPECT_TRUE(names.insert(s->name()).second) << s->name();
}

/// The laws that a test can afford to run.
using FastLaw = EveryLaw;
INSTANTIATE_TEST_SUITE_P(All, FastLaw,
                         testing::ValuesIn(ids_of_laws([](const Law& law) { return !law.long_only; })),
                         test_name);
INSTANTIATE_TEST_SUITE_P(All, EveryLaw, testing::ValuesIn(ids_of_laws([](const Law&) { return true; })),
                         test_name);

TEST_P(EveryLaw, SaysWhatItIs) {
  EXPECT_FALSE(law.says.empty());
  EXPECT_FALSE(law.source.empty());
  EXPECT_TRUE(law.id.starts_with(law.topic + ".") || law.id.starts_with("paper.") ||
              law.id.starts_with("lossy.") || law.id.starts_with("vq2.") || law.id.starts_with("vq4."));
  EXPECT_LE(law.tiers.fast.first, law.tiers.fast.last);
  EXPECT_LE(law.tiers.long_run.first, law.tiers.fast.first);
  EXPECT_LE(law.tiers.fast.last, law.tiers.long_run.last);
  EXPECT_LE(law.tiers.long_run.last, max_level());
  EXPECT_TRUE(law.long_only || law.tiers.seconds > 0);
  EXPECT_FALSE(law.subjects.empty());
  for (const std::string& name : law.subjects) {
    ASSERT_NE(find_subject(name), nullptr) << name;
    EXPECT_EQ(find_subject(name)->topic(), law.topic) << name;
  }
  if (!law.companion.empty()) {
    EXPECT_NE(find_law(law.companion), nullptr);
  }
}

TEST_P(FastLaw, HoldsOfItsOwnSubject) {
  LEAVE_TO_THE_GATE();
  SKIP_WHAT_THIS_BUILD_LACKS(law);
  SKIP_WHAT_TAKES_TOO_LONG_UNDER_SANITIZERS(law);
  const Verdict passed = law.method == Method::sample ? Verdict::checked : Verdict::proved;
  const Level last = std::max(std::min(law.tiers.fast.last, small), law.tiers.fast.first);
  // A sample is as large at every level; the first and the last one will do.
  const Level stride = law.method == Method::sample ? std::max(last, 1u) : 1;
  // The law's code is the same for each, and each subject has tests of its own.
  const std::string& name = law.subjects.front();
  std::uint64_t applied = 0;
  for (Level n = 0; n <= last; n += stride) {
    if (applied > 0 && law.cases(n, LawRun{}) > few) break;
    LawRun run;
    // Each case walks the same code, and the release build judges them all.
    Division part{last_eighth, nullptr, {}, {}, 0, false};
    if (law.divisible) run.division = &part;
    const Result r = run_level(law, *find_subject(name), n, run);
    if (r.verdict == Verdict::not_applicable) {
      // Levels of its own it must run.
      EXPECT_LT(n, law.tiers.fast.first) << r.reason;
      continue;
    }
    ++applied;
    const bool whole = !r.share || r.share->whole();
    EXPECT_EQ(r.verdict, whole ? passed : Verdict::checked)
        << "level " << n << (r.counterexamples.empty() ? "" : " " + r.counterexamples.front().at);
    if (whole) {
      EXPECT_EQ(r.cases_run(), law.cases(n, LawRun{}));
      EXPECT_EQ(r.cases_expected, r.cases_run());
    }
    EXPECT_GT(r.cases_run(), 0u);
    EXPECT_EQ(r.mismatches(), 0u);
  }
  EXPECT_GT(applied, 0u);
}

// Nor does it pass: a law that asks for a difference has not seen that there is none.
TEST_P(FastLaw, RefutesNothingThatAnInterruptCutShort) {
  SKIP_WHAT_TAKES_TOO_LONG_UNDER_SANITIZERS(law);
  std::raise(SIGINT);
  for (const std::string& name : law.subjects) {
    const Result r = run_level(law, *find_subject(name), law.tiers.fast.last, LawRun{});
    EXPECT_NE(r.verdict, Verdict::refuted) << name;
    if (r.verdict != Verdict::incomplete) {
      EXPECT_EQ(r.cases_run(), r.cases_expected) << name;
    }
  }
}

/// The laws that faults of another hand name, as "LAW@LEVEL" in lists.
const std::string laws_of_foreign_faults =
#define MMVERIFY_FAULT(name, wrong, laws) " " laws
#include "tests/foreign/attribute_faults.def"
#include "tests/foreign/bake_faults.def"
#include "tests/foreign/index_faults.def"
#include "tests/foreign/micromap_faults.def"
#include "tests/foreign/traverse_faults.def"
#include "tests/foreign/tree_faults.def"
#include "tests/foreign/vq_faults.def"
#undef MMVERIFY_FAULT
    " ";

TEST_P(EveryLaw, HasThreeMutantsOrFaultsOfAnotherHandAndOneThatOnlyHigherLevelsShow) {
  const bool has_faults = laws_of_foreign_faults.find(" " + law.id + "@") != std::string::npos ||
                          laws_of_foreign_faults.find(" " + law.id + " ") != std::string::npos;
  EXPECT_GE(law.mutants.size(), has_faults ? 1u : 3u);
  if (law.tiers.fast.last > 3 && !has_faults) {
    EXPECT_TRUE(std::any_of(law.mutants.begin(), law.mutants.end(),
                            [](const Mutant& m) { return m.levels.last > 3; }));
  }
  std::set<std::string> names;
  for (const Mutant& m : law.mutants) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_LE(m.levels.first, m.levels.last);
  }
}

TEST_P(FastLaw, CountsAndDigestAreTheSameForOneThreadAndTwo) {
  SKIP_WHAT_THIS_BUILD_LACKS(law);
  if (sanitized) GTEST_SKIP() << "the same runs once more; these sanitizers see nothing of threads";
  if (law.method == Method::induction || law.method == Method::bit_vectors)
    GTEST_SKIP()
        << "a prover's statements are no chunks; ./run gate holds their count and digest on all threads";
  // Several chunks, so that two threads have something to share.
  Level n = law.method != Method::exhaustive ? std::min(law.tiers.fast.first + 1, law.tiers.fast.last) : 8;
  if (law.id.starts_with("paper.")) n = 7;  // each wrong answer costs a counterexample
  if (law.topic != "index") n = std::min(n, law.tiers.fast.last);
  if (law.id == "tree.malformed") n = 1;  // each of level 2's 65,536 maps is decoded dozens of times
  const SubjectPtr subject = find_subject(law.subjects.front());
  // An eighth has chunks enough: hundreds of chunks of 16 for thousands of optima, and many for a million cells.
  const std::uint64_t enough = law.topic == "vq" ? 4'000 : 500'000;
  const std::optional<Shard> part =
      law.divisible && law.cases(n, LawRun{}) > enough ? std::optional(last_eighth) : std::nullopt;
  const Report one = run_alone(law, subject, n, 1, 1, part), two = run_alone(law, subject, n, 2, 1, part);
  EXPECT_EQ(outcome(one), outcome(two));
  EXPECT_NE(one.results.front().digest, 0u);
}

}  // namespace
