// Laws that no shared library reaches, on subjects of another hand: each fault is refuted, but for
// the gaps that are known, and what is right passes.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "tests/every_law.hpp"
#include "tests/foreign/inside_gaps.hpp"
#include "tests/foreign/inside_topics.hpp"

namespace mmverify::tests::foreign {

/// What GoogleTest says of a row.
inline void PrintTo(const InsideFault& f, std::ostream* out) { *out << f.law << ", " << f.name; }

}  // namespace mmverify::tests::foreign

namespace {

using namespace mmverify::tests;
using namespace mmverify::tests::foreign;

InsideFaults collected(bool right) {
  InsideFaults all;
  for (const InsideTopic& topic : inside_topics)
    for (InsideFault& f : right ? topic.right() : topic.faults()) all.push_back(std::move(f));
  return all;
}

/// Null where it is none.
const InsideGap* gap_of(const InsideFault& f) {
  const auto gap = std::find_if(std::begin(inside_gaps), std::end(inside_gaps), [&](const InsideGap& g) {
    return std::string(g.law) == f.law && std::string(g.name) == f.name;
  });
  return gap == std::end(inside_gaps) ? nullptr : gap;
}

/// A prover's law cannot be run on what it does not cover; there it is enough that nothing is called proved.
bool by_a_prover(const Law& law) {
  return law.method == Method::induction || law.method == Method::bit_vectors;
}

/// A law of the long tier is run on its first 64th.
Result on(const Law& law, const InsideFault& f, Level n) {
  Asked run;
  run.rationals = false;
  run.until_refuted = *f.wrong != '\0';
  Division first_part;
  first_part.shard = Shard{1, 64};
  if (law.long_only) run.division = &first_part;
  return run_level(law, *f.subject, n, run);
}

std::string said(const Result& r) {
  std::string text = to_string(r.verdict) + " at level " + std::to_string(r.level) + " " + r.reason;
  for (const Counterexample& c : r.counterexamples) text += " " + c.at + ": " + c.got + " for " + c.expected;
  return text;
}

std::string name_of(const testing::TestParamInfo<InsideFault>& info) {
  std::string name = std::string(info.param.law) + "_" + info.param.name;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

class InsideWrong : public testing::TestWithParam<InsideFault> {};
class InsideRight : public testing::TestWithParam<InsideFault> {};
INSTANTIATE_TEST_SUITE_P(All, InsideWrong, testing::ValuesIn(collected(false)), name_of);
INSTANTIATE_TEST_SUITE_P(All, InsideRight, testing::ValuesIn(collected(true)), name_of);

TEST_P(InsideWrong, IsRefuted) {
  const InsideFault& f = GetParam();
  const Law* law = find_law(f.law);
  ASSERT_NE(law, nullptr) << f.law;
  ASSERT_STRNE(f.wrong, "");
  bool seen = false;
  for (Level n = f.levels.first; n <= f.levels.last && !seen; ++n) {
    const Result r = on(*law, f, n);
    if (by_a_prover(*law)) {
      EXPECT_TRUE(r.verdict == Verdict::refuted || r.verdict == Verdict::incomplete)
          << f.wrong << ": " << said(r);
      // The prover decides that the altered statement fails: one that it cannot read would say nothing.
      EXPECT_EQ(r.reason.find("the prover says unknown"), std::string::npos) << r.reason;
      continue;
    }
    ASSERT_TRUE(r.verdict == Verdict::refuted || r.verdict == Verdict::proved ||
                r.verdict == Verdict::checked)
        << f.wrong << ": " << said(r);
    seen = r.verdict == Verdict::refuted;
    EXPECT_EQ(r.counterexamples.empty(), !seen) << f.wrong;
  }
  if (gap_of(f) != nullptr)
    EXPECT_FALSE(seen) << "is refuted: its row in inside_gaps.hpp can go";
  else
    EXPECT_TRUE(seen || by_a_prover(*law)) << "passes, though " << f.wrong;
}

TEST_P(InsideRight, Passes) {
  const InsideFault& f = GetParam();
  const Law* law = find_law(f.law);
  ASSERT_NE(law, nullptr) << f.law;
  ASSERT_STREQ(f.wrong, "");
  const bool in_part = law->method == Method::sample || law->long_only;
  const Verdict passed = in_part ? Verdict::checked : Verdict::proved;
  for (Level n = f.levels.first; n <= f.levels.last; ++n) {
    const Result r = on(*law, f, n);
    EXPECT_EQ(r.verdict, passed) << said(r);
  }
}

TEST(Inside, EachLawRefutesThreeFaultsAndPassesSomethingRight) {
  std::map<std::string, std::size_t> refuted, right, gaps;
  for (const InsideFault& f : collected(false)) ++(gap_of(f) == nullptr ? refuted : gaps)[f.law];
  for (const InsideFault& f : collected(true)) ++right[f.law];
  for (const auto& [law, count] : refuted) {
    EXPECT_GE(count, 3u) << law;
    EXPECT_GE(right[law], 1u) << law;
  }
  std::size_t listed = 0;
  for (const auto& [law, count] : gaps) listed += count;
  EXPECT_EQ(listed, std::size(inside_gaps)) << "a gap without its fault";
}

}  // namespace
