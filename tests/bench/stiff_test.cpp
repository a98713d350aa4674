// [release alone] bench/stiff: exact methods are never wrong, and the others are where arithmetic says so.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "bench/stiff/bench.hpp"
#include "bench/stiff/tables.hpp"

namespace bench_stiff_test {

using namespace mmverify::bench;

const StiffBenchOptions small_options{.samples = 8192, .rounds = 1};

const std::vector<StiffFigure>& small_run() {
  static const std::vector<StiffFigure> figures = stiff_figures(small_options);
  return figures;
}

const StiffFigure& named(const std::string& kind, const std::string& method) {
  for (const StiffFigure& f : small_run())
    if (f.kind == kind && f.method == method) return f;
  throw std::runtime_error("no " + kind + ", " + method);
}

TEST(BenchStiff, ExactMethodsAreNeverWrong) {
  std::map<std::string, int> ours;
  int timed_once = 0;
  for (const StiffFigure& f : small_run()) {
    EXPECT_GT(f.cases, 0u) << f.kind << f.method;
    EXPECT_GT(f.ns, 0) << f.kind << f.method;
    EXPECT_LE(f.least_ns.value_or(f.ns), f.ns) << f.kind << f.method;
    EXPECT_GE(f.most_ns.value_or(f.ns), f.ns) << f.kind << f.method;
    timed_once += f.least_ns && f.most_ns ? 0 : 1;
    EXPECT_GT(f.ratio, 0) << f.kind << f.method;
    if (!f.is_ours && f.method.find("rational") == std::string::npos) continue;
    EXPECT_EQ(f.wrong + f.ordinary_wrong, 0u) << f.kind << f.method;
    ours[f.kind] += f.is_ours ? 1 : 0;
  }
  for (const char* kind : {"lines", "sums", "subnormal points", "slivers", "cutoffs", "repeats",
                           "subnormal UVs", "magnitudes", "subnormal texels", "tiny"})
    EXPECT_GT(ours[kind], 0) << kind;
  EXPECT_EQ(ours.size(), 10u);
  EXPECT_EQ(timed_once, 9);  // the rationals, except for points
}

// Half of these points straddle the diagonal by parts of an ulp, and a sum just below 1 rounds up to it.  In binary64 the
// same fractions add up exactly: those of 24 bits with a sum in [1/2, 1) near 1 span 49 bits at most.
TEST(BenchStiff, TheSumOfThePublishedCodeRoundsInBinary32Alone) {
  EXPECT_GT(named("sums", "reference-f32").wrong, 8u);
  EXPECT_EQ(named("sums", "reference-f64").wrong, 0u);
  EXPECT_EQ(named("lines", "reference-f64").wrong, 0u);
  // A subnormal fraction changes no sum of the other, and no grid line lies between it and 0.
  EXPECT_EQ(named("subnormal points", "reference-f32").wrong, 0u);
}

// Cramer's determinants are differences of products of numbers near 1, so each is off by 2^-25 or so, and they are
// divided by 4^-12 = 2^-24; binary64 has 29 bits more.
TEST(BenchStiff, CramersRuleDividesBy4ToTheMinus12) {
  const StiffFigure& f32 = named("tiny", "Cramer, binary32");
  EXPECT_GT(f32.share(), 0.9);
  EXPECT_LT(f32.ordinary_share(), 0.1);
  EXPECT_EQ(named("tiny", "Cramer, binary64").wrong, 0u);
}

// A triangle of subnormal size differs from the point (0, 0) by less than any product in texels keeps: a baker in
// binary64 sees one alpha, which is the cutoff in most textures, where micro-triangles have both sides.
TEST(BenchStiff, SubnormalTrianglesArePointsInBinary64) {
  const StiffFigure& f = named("subnormal UVs", "rasterised, binary64");
  EXPECT_GT(f.share(), 0.1);
  EXPECT_EQ(f.wrong, named("subnormal UVs", "centre sample").wrong);
}

TEST(BenchStiff, TheSameSeedGivesTheSameErrors) {
  const auto again = stiff_figures(small_options);
  ASSERT_EQ(again.size(), small_run().size());
  for (std::size_t k = 0; k < again.size(); ++k) {
    EXPECT_EQ(again[k].wrong, small_run()[k].wrong) << again[k].kind << again[k].method;
    EXPECT_EQ(again[k].ordinary_wrong, small_run()[k].ordinary_wrong) << again[k].kind << again[k].method;
  }
}

TEST(BenchStiff, ThePictureHasAPanelAKind) {
  std::set<std::string> kinds, panels;
  for (const StiffFigure& f : small_run()) kinds.insert(f.kind);
  for (const auto& row : stiff_picture(small_run()).rows)
    for (const auto& panel : row) panels.insert(panel.title);
  EXPECT_EQ(kinds, panels);
}

TEST(BenchStiff, RefusesNoSamplesAndNoRounds) {
  EXPECT_THROW(stiff_figures({.samples = 0}), std::invalid_argument);
  EXPECT_THROW(stiff_figures({.rounds = 0}), std::invalid_argument);
}

}  // namespace bench_stiff_test
