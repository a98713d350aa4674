// Laws that no shared library reaches pass another hand's right subjects and refute its wrong ones.
#include <gtest/gtest.h>

#include <map>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "proofs/engine/runner.hpp"
#include "proofs/registry.hpp"
#include "tests/foreign/inside.hpp"

namespace mmverify::tests::foreign {
/// ctest lists a test by its parameter.
void PrintTo(const InsideFault& f, std::ostream* out) { *out << f.law << ' ' << f.name; }
}  // namespace mmverify::tests::foreign

namespace {

using namespace mmverify::proofs;
using namespace mmverify::tests::foreign;
using Asked = mmverify::proofs::Run;

/// A prover's law, whose statements name no case: one that fails leaves the law unproved.
bool by_prover(const Law& law) {
  return law.method == Method::induction || law.method == Method::bit_vectors;
}

using Source = std::vector<InsideFault> (*)();
constexpr Source sources_of_faults[] = {
    inside_faults_of_index,
    inside_faults_of_provers,
};
constexpr Source sources_of_right[] = {
    inside_right_of_index,
    inside_right_of_provers,
};

std::vector<InsideFault> all(std::span<const Source> sources) {
  std::vector<InsideFault> sum;
  for (const Source of_topic : sources)
    for (InsideFault& f : of_topic()) sum.push_back(std::move(f));
  return sum;
}
std::vector<InsideFault> faults() { return all(sources_of_faults); }
std::vector<InsideFault> right() { return all(sources_of_right); }

std::string name_of(const testing::TestParamInfo<InsideFault>& f) {
  std::string name = std::string(f.param.law) + "_" + f.param.name;
  for (char& c : name)
    if (c == '.') c = '_';
  return name;
}

/// A law of the long tier is run on its first 64th.
Result run(const InsideFault& f, Level n) {
  Asked asked;
  asked.rationals = false;
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
    if (r.verdict != Verdict::refuted) continue;
    ASSERT_FALSE(r.counterexamples.empty());
    EXPECT_FALSE(r.counterexamples.front().at.empty());
    return;
  }
  FAIL() << f.law << " lets live: " << f.wrong;
}

TEST(Inside, EachLawHasThreeFaultsAndARightSubject) {
  std::map<std::string, int> faulty, passing;
  for (const InsideFault& f : faults()) {
    ++faulty[f.law];
    EXPECT_NE(std::string(f.wrong), "") << f.name;
  }
  for (const InsideFault& f : right()) ++passing[f.law];
  for (const auto& [law, number] : faulty) {
    EXPECT_GE(number, 3) << law;
    EXPECT_TRUE(passing.contains(law)) << law;
  }
  for (const auto& [law, number] : passing) EXPECT_TRUE(faulty.contains(law)) << law;
}

}  // namespace
