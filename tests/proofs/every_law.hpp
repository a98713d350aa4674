// Helpers of the tests that go through every law.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {

using namespace proofs;
using LawRun = Run;  // inside a test, Run is a member function of GoogleTest's

inline LawRun keeping(std::size_t errors) {
  LawRun run;
  run.errors = errors;
  return run;
}

/// run_jobs on one law, subject and level, silently and without mutants.
inline Report run_alone(Law law, const SubjectPtr& subject, Level level, unsigned threads,
                        std::size_t errors = 1, std::optional<Shard> shard = {}) {
  law.mutants.clear();
  RunOptions options;
  options.threads = threads;
  options.shard = shard;
  options.errors = errors;
  options.show_progress = false;
  return run_jobs({{&law, subject, {level, level}, {}}}, options, [](const Result&) {});
}

/// Verdict, counts, digest and counterexamples as one text.
inline std::string outcome(const Report& report) {
  std::string text;
  for (const Result& r : report.results) {
    text += to_string(r.verdict) + " " + std::to_string(r.digest);
    for (const Count& c : r.by_kind)
      text += " " + std::to_string(c.cases) + "/" + std::to_string(c.mismatches);
    for (const Counterexample& c : r.counterexamples) text += " " + c.at + " " + c.expected + " " + c.got;
  }
  return text;
}

/// Samples and exhaustive laws of blocks and bakers have as many cases at each level, and so no smaller one to run;
/// a prover has one size alone.  The library's own tests and the fuzzers call the same code of ours under sanitizers.
inline bool too_long_under_sanitizers(const Law& law) {
  if (!sanitized) return false;
  if (law.topic == "vq" || law.topic == "bake")
    return law.id == "vq.vectors" || law.method == Method::sample ||
           law.cases(law.tiers.fast.last, LawRun{}) > 5'000;
  return law.id == "tree.all_levels" || law.id == "dag.all_levels" || law.id == "index.wide_is_vulkan" ||
         law.id == "index.floats" || law.id == "index.row_floats" ||
         law.id == "index.published_differs_where" ||
         (law.topic == "attribute" && law.method == Method::induction) ||
         (law.method == Method::sample && law.cases(law.tiers.fast.first, LawRun{}) > 50'000);
}
#define SKIP_WHAT_TAKES_TOO_LONG_UNDER_SANITIZERS(law) \
  if (too_long_under_sanitizers(law)) GTEST_SKIP() << "too long; the release build runs it"

/// Why none of a law's own subjects has what it needs in this build; empty: some has.
inline std::string lacking(const Law& law) {
  std::string why;
  for (const std::string& name : law.subjects) {
    const auto unfit = law.unfit ? law.unfit(*find_subject(name), law.tiers.fast.first) : std::nullopt;
    if (!unfit) return {};
    why = *unfit;
  }
  return why;
}
#define SKIP_WHAT_THIS_BUILD_LACKS(law) \
  if (const std::string why = lacking(law); !why.empty()) GTEST_SKIP() << why

/// A suite over laws: the parameter is the law's id.
class EveryLaw : public testing::TestWithParam<std::string> {
 protected:
  const Law& law = *find_law(GetParam());

 private:
  const InterruptGuard clears_what_a_test_before_left_;
};

template <class Predicate>
std::vector<std::string> ids_of_laws(Predicate chosen) {
  std::vector<std::string> ids;
  for (const Law& law : laws())
    if (chosen(law)) ids.push_back(law.id);
  return ids;
}

inline std::string test_name(const testing::TestParamInfo<std::string>& id) {
  std::string name = id.param;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

}  // namespace mmverify::tests
