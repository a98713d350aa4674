// [release, night] Every law about this library's functions, once on each SIMD target that the processor has: the same answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/impl/every_target.hpp"
#include "tests/proofs/every_law.hpp"

namespace laws_on_targets_test {

using namespace mmverify::tests;

/// Cases of a level that a test can afford on each target.
constexpr std::uint64_t few = 1'000;

/// Subjects whose names begin so are specifications, or formulas of papers in plain C++.
constexpr const char* without_vectors[] = {"reference", "step", "w-minor", "published"};

std::vector<std::string> subjects_with_vectors(const Law& law) {
  std::vector<std::string> names = law.subjects;
  std::erase_if(names, [](const std::string& name) {
    return name.ends_with("-spec") || std::any_of(std::begin(without_vectors), std::end(without_vectors),
                                                  [&](const char* begin) { return name.starts_with(begin); });
  });
  return names;
}

bool is_run(const Law& law) {
  return !law.long_only && law.method != Method::induction && law.method != Method::bit_vectors &&
         !subjects_with_vectors(law).empty();
}

/// The highest level, and the one below, with few cases; the lowest level if each has many.
std::vector<Level> levels_of(const Law& law) {
  std::vector<Level> levels;
  for (Level n = law.tiers.fast.last + 1; n-- > law.tiers.fast.first && levels.size() < 2;)
    if (law.cases(n, LawRun{}) <= few) levels.push_back(n);
  if (levels.empty()) levels.push_back(law.tiers.fast.first);
  return levels;
}

using LawOnTargets = EveryLaw;
INSTANTIATE_TEST_SUITE_P(All, LawOnTargets, testing::ValuesIn(ids_of_laws(is_run)), test_name);

TEST_P(LawOnTargets, HoldsWithTheSameAnswers) {
  SKIP_WHAT_THIS_BUILD_LACKS(law);
  const auto refuted = [](const Report& report) {
    return std::any_of(report.results.begin(), report.results.end(), [](const Result& r) {
      return r.verdict == Verdict::refuted || r.verdict == Verdict::broken;
    });
  };
  for (const std::string& name : subjects_with_vectors(law))
    for (const Level n : levels_of(law)) {
      const Report expected = run_alone(law, find_subject(name), n, 1);
      EXPECT_FALSE(refuted(expected)) << name << ", level " << n;
      on_every_target([&] {
        EXPECT_EQ(outcome(run_alone(law, find_subject(name), n, 1)), outcome(expected))
            << name << ", level " << n;
      });
    }
}

}  // namespace laws_on_targets_test
