// The laws as a list, and each of them: it holds over its whole domain, and it can fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "proofs/index.hpp"
#include "tests/every_law.hpp"

namespace {

using namespace mmverify::tests;

constexpr Level small = 5;

TEST(Laws, TheDesignsOnesAreThere) {
  for (const char* id : {"index.equals_reference", "index.in_range", "index.bijective", "index.nested",
                         "index.contiguous", "index.inverse", "index.exact_on_floats"})
    EXPECT_NE(find_law(id), nullptr) << id;
  EXPECT_FALSE(laws_named("paper").empty());
  EXPECT_EQ(find_law("index"), nullptr);
  EXPECT_EQ(laws_named("index").size(), laws().size());
  EXPECT_TRUE(laws_named("index.").empty());
  EXPECT_TRUE(laws_named("").empty());
  EXPECT_TRUE(laws_named("no.such.law").empty());
}

TEST(Laws, TheDesignsSubjectsAreThere) {
  for (const char* name : {"reference", "step", "step-appendix-middle", "step-appendix-ties",
                           "step-appendix-names", "reference-f16", "reference-f32", "reference-f64",
                           "step-f16", "step-f32", "step-f64", "reference-wide", "impl"})
    EXPECT_NE(find_subject(name), nullptr) << name;
  EXPECT_EQ(find_subject("nobody"), nullptr);
}

TEST(Laws, IdsAndSubjectsAreUnique) {
  std::set<std::string> ids, names;
  for (const Law& law : laws()) EXPECT_TRUE(ids.insert(law.id).second) << law.id;
  for (const SubjectPtr& s : subjects()) EXPECT_TRUE(names.insert(s->name()).second) << s->name();
}

/// Those that a test can afford to run.
using FastLaw = EveryLaw;
INSTANTIATE_TEST_SUITE_P(All, FastLaw,
                         testing::ValuesIn(ids_of_laws([](const Law& law) { return !law.long_only; })),
                         test_name);
INSTANTIATE_TEST_SUITE_P(All, EveryLaw, testing::ValuesIn(ids_of_laws([](const Law&) { return true; })),
                         test_name);

TEST_P(EveryLaw, SaysWhatItIs) {
  EXPECT_FALSE(law.says.empty());
  EXPECT_FALSE(law.source.empty());
  EXPECT_TRUE(law.id.starts_with(law.topic + ".") || law.id.starts_with("paper."));
  EXPECT_LE(law.fast.first, law.fast.last);
  EXPECT_LE(law.long_run.first, law.fast.first);
  EXPECT_LE(law.fast.last, law.long_run.last);
  EXPECT_LE(law.long_run.last, mmverify::proofs::index::max_level);
  EXPECT_TRUE(law.long_only || law.fast_seconds > 0);
  EXPECT_FALSE(law.subjects.empty());
  for (const std::string& name : law.subjects) EXPECT_NE(find_subject(name), nullptr) << name;
  if (!law.float_companion.empty()) {
    EXPECT_NE(find_law(law.float_companion), nullptr);
  }
}

/// The closed form that the words of a domain promise, 0 where they promise a sample or a witness.
std::uint64_t promised(const std::string& domain, Level n) {
  if (domain.find("level n+1") != std::string::npos) ++n;
  const std::uint64_t N = std::uint64_t{1} << n;
  if (domain.find("3N^2+3N+1") != std::string::npos) return 3 * N * N + 3 * N + 1;
  if (domain.find("4^n") != std::string::npos) return N * N;
  return 0;
}

TEST_P(FastLaw, HoldsOfItsOwnSubjectsOverItsWholeDomain) {
  const Verdict passed = law.method == Method::sample ? Verdict::checked : Verdict::proved;
  const Level last = std::max(std::min(law.fast.last, small), law.fast.first);
  // A sample is as large at every level; the first and the last one will do.
  const Level stride = law.method == Method::sample ? std::max(last, 1u) : 1;
  for (const std::string& name : law.subjects) {
    std::uint64_t applied = 0;
    for (Level n = 0; n <= last; n += stride) {
      const Result r = run_level(law, *find_subject(name), n, Asked{});
      if (r.verdict == Verdict::not_applicable) {
        // Levels of its own it must run.
        EXPECT_LT(n, law.fast.first) << name << ": " << r.reason;
        continue;
      }
      ++applied;
      EXPECT_EQ(r.verdict, passed) << name << " level " << n
                                   << (r.counterexamples.empty() ? "" : " " + r.counterexamples.front().at);
      EXPECT_EQ(r.cases_run(), law.cases(n, Asked{}));
      EXPECT_EQ(r.cases_expected, r.cases_run());
      EXPECT_GT(r.cases_run(), 0u);
      EXPECT_EQ(r.mismatches(), 0u);
      if (law.method == Method::exhaustive) {
        EXPECT_EQ(r.cases_run(), promised(r.domain, n)) << r.domain;
      }
    }
    EXPECT_GT(applied, 0u) << name;
  }
}

TEST_P(FastLaw, CountsItsCellsByKind) {
  const Result r = run_level(law, *find_subject(law.subjects.front()), 2, Asked{});
  const std::uint64_t N = r.domain.find("level n+1") != std::string::npos ? 8 : 4;
  if (r.domain.find("3N^2+3N+1") != std::string::npos) {
    EXPECT_EQ(r.by_kind[0].cases, (N + 1) * (N + 2) / 2);
    EXPECT_EQ(r.by_kind[1].cases, 3 * N * (N + 1) / 2);
    EXPECT_EQ(r.by_kind[2].cases, N * N);
  } else if (law.method != Method::sample) {
    EXPECT_EQ(r.by_kind[0].cases + r.by_kind[1].cases, 0u);
  }
}

// prove --cells interior: the same law for who promises nothing on lines.
TEST_P(FastLaw, LeavesTheLinesOutWhereAsked) {
  Asked inside;
  inside.interiors_only = true;
  const SubjectPtr subject = find_subject(law.subjects.front());
  const Result all = run_level(law, *subject, 2, Asked{}), r = run_level(law, *subject, 2, inside);
  EXPECT_EQ(r.verdict, all.verdict);
  if (!law.on_lines || !law.general) {
    EXPECT_EQ(r.by_kind, all.by_kind);
    return;
  }
  // The 4^n interiors (nested: those of the next level), or a sample as large as before.
  const std::uint64_t inside_cases = law.method == Method::sample ? all.cases_run() : all.by_kind[2].cases;
  EXPECT_EQ(r.by_kind, (CountByKind{Count{0, 0}, Count{0, 0}, Count{inside_cases, 0}}));
  EXPECT_NE(r.domain, all.domain);
}

TEST_P(EveryLaw, HasThreeMutantsAndOneThatOnlyHigherLevelsShow) {
  EXPECT_GE(law.mutants.size(), 3u);
  EXPECT_TRUE(
      std::any_of(law.mutants.begin(), law.mutants.end(), [](const Mutant& m) { return m.levels.last > 3; }));
  std::set<std::string> names;
  for (const Mutant& m : law.mutants) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_LE(m.levels.first, m.levels.last);
  }
}

TEST_P(FastLaw, KillsEveryMutant) {
  const std::vector<MutantResult> results = run_mutants(law, Asked{});
  ASSERT_EQ(results.size(), law.mutants.size());
  for (std::size_t k = 0; k < results.size(); ++k) {
    EXPECT_TRUE(results[k].killed) << results[k].mutant;
    EXPECT_GE(results[k].level, law.mutants[k].levels.first);
    EXPECT_LE(results[k].level, law.mutants[k].levels.last);
    EXPECT_FALSE(results[k].at.empty()) << results[k].mutant;
  }
}

TEST_P(FastLaw, CountsAndDigestAreTheSameForOneThreadAndTwo) {
  // Several chunks, so that two threads have something to share; one level less where every case is rational.
  const Level n = law.method != Method::exhaustive      ? std::min(law.fast.first + 1, law.fast.last)
                  : law.id == "index.fixed_is_rational" ? 8
                                                        : 9;
  const SubjectPtr subject = find_subject(law.subjects.front());
  const Report one = run_alone(law, subject, n, 1), two = run_alone(law, subject, n, 2);
  EXPECT_EQ(outcome(one), outcome(two));
  EXPECT_NE(one.results.front().digest, 0u);
}

}  // namespace
