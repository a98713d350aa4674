// Laws that no shared library reaches refute another hand's wrong subjects, but for the gaps that are known, and
// pass its right ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <utility>

#include "proofs/engine/runner.hpp"
#include "proofs/index/options.hpp"
#include "proofs/registry/registry.hpp"
#include "tests/foreign/inside/gaps.hpp"
#include "tests/foreign/inside/inside.hpp"

namespace mmverify::tests::foreign {
/// ctest lists a test by its parameter.
void PrintTo(const InsideFault& f, std::ostream* out) { *out << f.law << ' ' << f.name; }
}  // namespace mmverify::tests::foreign

namespace {

using namespace mmverify::proofs;
using namespace mmverify::tests::foreign;
using LawRun = mmverify::proofs::Run;

/// A prover's law, whose statements name no case: one that fails leaves the law unproved.
bool by_prover(const Law& law) {
  return law.method == Method::induction || law.method == Method::bit_vectors;
}

using Source = InsideRows (*)();
constexpr Source sources_of_faults[] = {
    inside_faults_of_index, inside_faults_of_provers, inside_faults_of_micromap,
    inside_faults_of_tree,  inside_faults_of_vq,      inside_faults_of_rays,
};
constexpr Source sources_of_right[] = {
    inside_right_of_index, inside_right_of_provers, inside_right_of_micromap,
    inside_right_of_tree,  inside_right_of_vq,      inside_right_of_rays,
};

InsideRows all(std::span<const Source> sources) {
  InsideRows sum;
  for (const Source of_topic : sources)
    for (InsideFault& f : of_topic()) sum.push_back(std::move(f));
  return sum;
}
InsideRows faults() { return all(sources_of_faults); }
InsideRows right() { return all(sources_of_right); }

/// Whether its law is known to let it live.
bool known_gap(const InsideFault& f) {
  return std::any_of(std::begin(inside_gaps), std::end(inside_gaps), [&](const InsideGap& g) {
    return std::string(g.law) == f.law && std::string(g.name) == f.name;
  });
}

std::string name_of(const testing::TestParamInfo<InsideFault>& f) {
  std::string name = std::string(f.param.law) + "_" + f.param.name;
  for (char& c : name)
    if (c == '.') c = '_';
  return name;
}

/// A law of the long tier is run on its first 64th.
Result run(const InsideFault& f, Level n) {
  LawRun asked;
  asked.options = {&index::in_fixed_point_alone};
  Division first_part;
  first_part.shard = Shard{1, 64};
  if (find_law(f.law)->long_only) asked.division = &first_part;
  return run_level(*find_law(f.law), *f.subject, n, asked);
}

class InsideRight : public testing::TestWithParam<InsideFault> {};
INSTANTIATE_TEST_SUITE_P(All, InsideRight, testing::ValuesIn(right()), name_of);

TEST_P(InsideRight, Passes) {
  const InsideFault& f = GetParam();
  const Law* law = find_law(f.law);
  ASSERT_NE(law, nullptr);
  const bool in_part = law->method == Method::sample || law->long_only;
  const Verdict passed = in_part ? Verdict::checked : Verdict::proved;
  for (Level n = f.levels.first; n <= f.levels.last; ++n) {
    const Result r = run(f, n);
    EXPECT_EQ(r.verdict, passed) << n << " " << r.reason
                                 << (r.counterexamples.empty() ? "" : r.counterexamples.front().at);
  }
}

class InsideFaults : public testing::TestWithParam<InsideFault> {};
INSTANTIATE_TEST_SUITE_P(All, InsideFaults, testing::ValuesIn(faults()), name_of);

TEST_P(InsideFaults, IsFound) {
  const InsideFault& f = GetParam();
  const Law* law = find_law(f.law);
  ASSERT_NE(law, nullptr);
  for (Level n = f.levels.first; n <= f.levels.last; ++n) {
    const Result r = run(f, n);
    if (by_prover(*law)) {
      // The prover decides that the altered statement fails: one that it cannot read would say nothing.
      EXPECT_TRUE(r.verdict == Verdict::refuted || r.verdict == Verdict::incomplete) << f.wrong;
      EXPECT_EQ(r.reason.find("the prover says unknown"), std::string::npos) << r.reason;
      return;
    }
    ASSERT_TRUE(r.verdict == Verdict::refuted || r.verdict == Verdict::proved ||
                r.verdict == Verdict::checked)
        << to_string(r.verdict) << " " << r.reason;
    if (r.verdict != Verdict::refuted) continue;
    ASSERT_FALSE(r.counterexamples.empty());
    EXPECT_FALSE(r.counterexamples.front().at.empty());
    EXPECT_FALSE(known_gap(f)) << "is refuted now: its row in inside/gaps.hpp can go";
    return;
  }
  EXPECT_TRUE(known_gap(f)) << f.law << " lets live: " << f.wrong;
}

TEST(Inside, EachLawHasThreeFaultsAndARightSubject) {
  std::map<std::string, int> found, passing;
  std::size_t gaps = 0;
  for (const InsideFault& f : faults()) {
    if (known_gap(f))
      ++gaps;
    else
      ++found[f.law];
    EXPECT_NE(std::string(f.wrong), "") << f.name;
  }
  for (const InsideFault& f : right()) ++passing[f.law];
  for (const auto& [law, number] : found) {
    EXPECT_GE(number, 3) << law;
    EXPECT_TRUE(passing.contains(law)) << law;
  }
  for (const auto& [law, number] : passing) EXPECT_TRUE(found.contains(law)) << law;
  EXPECT_EQ(gaps, std::size(inside_gaps)) << "a gap without its fault";
}

}  // namespace
