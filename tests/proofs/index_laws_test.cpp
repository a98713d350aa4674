// [release, night, first] The laws of topic index: their cases are the cells that the words of a domain promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "proofs/index/options.hpp"
#include "tests/proofs/every_law.hpp"

namespace index_laws_test {

using namespace mmverify::tests;

using IndexLaw = EveryLaw;
INSTANTIATE_TEST_SUITE_P(All, IndexLaw, testing::ValuesIn(ids_of_laws([](const Law& law) {
                           return law.topic == "index" && !law.long_only;
                         })),
                         test_name);

using ExhaustiveIndexLaw = EveryLaw;
INSTANTIATE_TEST_SUITE_P(All, ExhaustiveIndexLaw, testing::ValuesIn(ids_of_laws([](const Law& law) {
                           return law.topic == "index" && law.method == Method::exhaustive && !law.long_only;
                         })),
                         test_name);

/// The closed form that the words of a domain promise, 0 where they promise a sample or a witness.
std::uint64_t promised(const std::string& domain, Level n) {
  if (domain.find("level n+1") != std::string::npos) ++n;
  const std::uint64_t N = std::uint64_t{1} << n;
  if (domain.find("3N^2+3N+1") != std::string::npos) return 3 * N * N + 3 * N + 1;
  if (domain.find("4^n") != std::string::npos) return N * N;
  return 0;
}

TEST_P(ExhaustiveIndexLaw, CountsTheCasesThatItsDomainPromises) {
  for (const std::string& name : law.subjects)
    for (Level n = law.tiers.fast.first;
         n <= std::max(law.tiers.fast.first, std::min(law.tiers.fast.last, 4u)); ++n) {
      const Result r = run_level(law, *find_subject(name), n, LawRun{});
      if (r.verdict == Verdict::not_applicable) continue;
      EXPECT_EQ(r.cases_run(), promised(r.domain, n)) << name << " level " << n << ": " << r.domain;
    }
}

TEST_P(IndexLaw, CountsItsCellsByKind) {
  const Result r = run_level(law, *find_subject(law.subjects.front()), 2, LawRun{});
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
TEST_P(IndexLaw, LeavesTheLinesOutWhereAsked) {
  LawRun inside;
  inside.options = {&index::interiors_only};
  const SubjectPtr subject = find_subject(law.subjects.front());
  const Result all = run_level(law, *subject, 2, LawRun{}), r = run_level(law, *subject, 2, inside);
  EXPECT_EQ(r.verdict, all.verdict);
  if (!has(law.heeds, index::interiors_only) || !law.general) {
    EXPECT_EQ(r.by_kind, all.by_kind);
    return;
  }
  // The 4^n interiors (nested: those of the next level), or a sample as large as before.
  const std::uint64_t inside_cases = law.method == Method::sample ? all.cases_run() : all.by_kind[2].cases;
  // The published code on floats is not exact in interiors, either.
  EXPECT_EQ(r.by_kind, (CountByKind{Count{0, 0}, Count{0, 0}, Count{inside_cases, 0, 0, r.allowed()}}));
  EXPECT_NE(r.domain, all.domain);
}

}  // namespace index_laws_test
