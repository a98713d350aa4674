// [release alone] bench/: its inputs, its judge and its fits.  Nothing here looks at a clock.
#include "spec/index/index.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/exact.hpp"
#include "bench/growth.hpp"
#include "bench/index/bench.hpp"
#include "bench/index/distance.hpp"
#include "bench/index/inputs.hpp"
#include "bench/index/subjects.hpp"
#include "bench/index/times.hpp"
#include "bench/number_type.hpp"
#include "impl/common/binary16.hpp"

namespace bench_index_test {

using namespace mmverify::bench;
namespace spec = mmverify::spec;
using mmverify::impl::Binary16;
using spec::index::Corners;

constexpr std::array all_numbers{binary16, binary32, binary64, fixed64};

const IndexFigures& named(const std::vector<IndexFigures>& figures, const std::string& name) {
  const auto found =
      std::find_if(figures.begin(), figures.end(), [&](const IndexFigures& f) { return f.name == name; });
  if (found == figures.end()) throw std::runtime_error("no subject " + name);
  return *found;
}

const IndexErrors& at_level(const std::vector<IndexErrors>& errors, std::uint32_t level) {
  const auto found =
      std::find_if(errors.begin(), errors.end(), [&](const IndexErrors& e) { return e.level == level; });
  if (found == errors.end()) throw std::runtime_error("no level " + std::to_string(level));
  return *found;
}

bool same(const IndexErrors& a, const IndexErrors& b) {
  return a.level == b.level && a.samples == b.samples && a.mismatches == b.mismatches &&
         a.off_grid == b.off_grid && a.by_kind == b.by_kind && a.worst_heights == b.worst_heights &&
         a.worst_ulp == b.worst_ulp;
}

bool same(const std::vector<IndexFigures>& a, const std::vector<IndexFigures>& b) {
  const auto levels = [](const std::vector<IndexErrors>& x, const std::vector<IndexErrors>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](const IndexErrors& p, const IndexErrors& q) { return same(p, q); });
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const IndexFigures& x, const IndexFigures& y) {
                      return x.name == y.name && levels(x.uniform, y.uniform) && levels(x.stiff, y.stiff);
                    });
}

const std::vector<IndexFigures>& small_run() {
  static const std::vector<IndexFigures> figures = index_errors({.samples = 6000, .first = 1, .last = 16});
  return figures;
}

// -- number types

TEST(BenchNumberType, RoundsAsTheTypesDo) {
  for (int k = 0; k < 20000; ++k) {
    const double x = std::fmod(0.6180339887498949 * k, 1.0) * std::ldexp(1.0, -(k % 40));
    EXPECT_EQ(binary32.rounded(x), static_cast<double>(static_cast<float>(x)));
    EXPECT_EQ(binary16.rounded(x), static_cast<double>(Binary16(x)));
    EXPECT_EQ(binary64.rounded(x), x);
    EXPECT_LE(std::abs(fixed64.rounded(x) - x), 0x1p-31);
    EXPECT_EQ(std::fmod(fixed64.rounded(x), 0x1p-30), 0);
  }
}

TEST(BenchNumberType, NeighboursAreTheNextNumbers) {
  for (const float x : {0x1p-20f, 0.25f, 0.5f, 0x1.fffffep-2f, 1.0f / 3, 1.0f}) {
    EXPECT_EQ(binary32.neighbour(static_cast<double>(x), 1), static_cast<double>(std::nextafter(x, 2.0f)));
    EXPECT_EQ(binary32.neighbour(static_cast<double>(x), -1), static_cast<double>(std::nextafter(x, 0.0f)));
  }
  EXPECT_EQ(binary64.neighbour(0.5, -1), std::nextafter(0.5, 0.0));
  EXPECT_EQ(binary16.neighbour(1, -2), 1 - 0x1p-10);
  EXPECT_EQ(fixed64.neighbour(0.25, 3), 0.25 + 3 * 0x1p-30);
  EXPECT_EQ(binary32.neighbour(0, -3), 0);
}

// -- inputs

TEST(BenchIndexInputs, AreNumbersOfTheirTypeInsideTheTriangle) {
  for (const NumberType& numbers : all_numbers)
    for (const Inputs kind : {Inputs::uniform, Inputs::stiff})
      for (const std::uint32_t level : {0u, 1u, 7u, 16u}) {
        IndexInputs inputs(numbers, kind, level, 5);
        StiffRecipe made{};
        for (int k = 0; k < 4000; ++k) {
          const InputPoint p = inputs.next(made);
          ASSERT_EQ(numbers.rounded(p.u), p.u);
          ASSERT_EQ(numbers.rounded(p.v), p.v);
          ASSERT_GE(p.u, 0);
          ASSERT_GE(p.v, 0);
          ASSERT_LE(exact_rational(p.u) + exact_rational(p.v), spec::Rational(1));
        }
      }
}

TEST(BenchIndexInputs, AreTheSameForOneSeedAndOthersForAnother) {
  IndexInputs a(binary32, Inputs::stiff, 8, 1), b(binary32, Inputs::stiff, 8, 1),
      c(binary32, Inputs::stiff, 8, 2);
  int others = 0;
  StiffRecipe kind{};
  for (int k = 0; k < 100; ++k) {
    const InputPoint p = a.next(kind), q = b.next(kind), r = c.next(kind);
    EXPECT_EQ(p.u, q.u);
    EXPECT_EQ(p.v, q.v);
    others += p.u != r.u || p.v != r.v;
  }
  EXPECT_GT(others, 90);
}

TEST(BenchIndexInputs, HardPointsLieBesideLinesOnEitherSide) {
  constexpr std::uint32_t level = 6;
  constexpr double N = 64;
  IndexInputs inputs(binary32, Inputs::stiff, level, 1);
  std::set<std::pair<StiffRecipe, bool>> met;
  for (int k = 0; k < 4000; ++k) {
    StiffRecipe kind{};
    const InputPoint p = inputs.next(kind);
    // Exact: both have 24 bits between 2^-50 and 1.
    const double sum = N * p.u + N * p.v, beside = sum - std::nearbyint(sum);
    if (kind == StiffRecipe::hypotenuse) {
      EXPECT_LE(1 - (p.u + p.v), 0x1p-21);
    }
    if (kind == StiffRecipe::straddling && std::abs(beside) < 0x1p-15 && beside != 0)
      met.insert({kind, beside > 0});
    if (kind == StiffRecipe::diagonal && beside != 0) met.insert({kind, beside > 0});
    if (kind == StiffRecipe::lines) {
      const double off = N * p.u - std::nearbyint(N * p.u);
      EXPECT_LE(std::abs(off), N * 3 * 0x1p-23);
      if (off != 0) met.insert({kind, off > 0});
    }
  }
  EXPECT_EQ(met.size(), 6u);
}

// -- distances

TEST(BenchIndexDistance, IsZeroInTheClosedMicroTriangle) {
  for (const NumberType& numbers : {binary32, binary64})
    for (const std::uint32_t n : {1u, 5u, 16u}) {
      IndexInputs inputs(numbers, Inputs::stiff, n, 3);
      StiffRecipe kind{};
      for (int k = 0; k < 2000; ++k) {
        const InputPoint p = inputs.next(kind);
        const auto curve = on_exact(p.u, p.v, [n](const auto& q) { return spec::index::reference(q, n); });
        const auto rows = on_exact(p.u, p.v, [n](const auto& q) { return spec::index::w_minor(q, n); });
        for (const Corners& corners : {spec::index::corners(curve, n), spec::index::w_minor_corners(rows)}) {
          ASSERT_TRUE(on_grid(corners, n));
          const Distance d = distance(p, corners, n, numbers);
          ASSERT_EQ(d.heights, 0);
          ASSERT_EQ(d.ulp, 0);
        }
      }
    }
}

TEST(BenchIndexDistance, OfAKnownWrongAnswer) {
  // u+v = 1/2 - 2^-25 + 2^-26 = 1/2 - 2^-26 lies below the line 1/2 of level 1, in micro-triangle 0. In
  // binary32 the fractions' sum 1 - 2^-25 rounds to 1, which makes it 1, the middle one: u+v >= 1/2.
  const InputPoint p{(1 - 0x1p-24) / 2, 0x1p-26};
  const spec::Point<float> rounded{static_cast<float>(p.u), static_cast<float>(p.v)};
  ASSERT_EQ(spec::index::reference(rounded, 1), 1u);
  ASSERT_EQ(on_exact(p.u, p.v, [](const auto& q) { return spec::index::reference(q, 1); }), 0u);

  const Distance d = distance(p, spec::index::corners(1, 1), 1, binary32);
  EXPECT_EQ(d.heights, 0x1p-25);  // 2^-26 short, in halves
  EXPECT_EQ(d.ulp, 0.25);         // 2^-26 in units of 2^-24, the ulp at 1/2
}

TEST(BenchIndexDistance, TakesTheWorstSideOfTheTriangleItself) {
  // Level 1, micro-triangle 3 at the v-corner: v >= 1/2. Its other sides hold at the w-corner; the line
  // u+v = 1/2 through its lower corners is none of its sides.
  const Distance d = distance({0, 0}, spec::index::corners(3, 1), 1, binary32);
  EXPECT_EQ(d.heights, 1);
  // The middle one is inverted: u <= 1/2, v <= 1/2, u+v >= 1/2. (3/4, 0) is half a height beyond u <= 1/2.
  EXPECT_EQ(distance({0.75, 0}, spec::index::corners(1, 1), 1, binary16).heights, 0.5);
  EXPECT_EQ(distance({0.75, 0}, spec::index::corners(1, 1), 1, binary16).ulp, 0x1p-2 / 0x1p-11);
}

TEST(BenchIndexDistance, KnowsWhatIsNoMicroTriangle) {
  EXPECT_TRUE(on_grid({{{0, 0}, {1, 0}, {0, 1}}}, 0));
  EXPECT_FALSE(on_grid({{{1, 0}, {2, 0}, {1, 1}}}, 0));
  EXPECT_FALSE(on_grid({{{0, 0}, {1, 0}, {2, 0}}}, 3));
  EXPECT_FALSE(on_grid({{{0, 0}, {0xffffffffu, 1}, {1, 0}}}, 3));
  // The first index whose binary32 root is a row too far: 4097^2 - 2.
  const auto subjects = index_subjects<float>();
  const auto rooted = std::find_if(subjects.begin(), subjects.end(),
                                   [](const auto& s) { return s.name == "w-minor-f32-sqrt"; });
  ASSERT_NE(rooted, subjects.end());
  EXPECT_TRUE(on_grid(rooted->triangle(16'785'406, 13), 13));
  EXPECT_FALSE(on_grid(rooted->triangle(16'785'407, 13), 13));
}

// -- fits

TEST(BenchGrowth, NamesDoubling) {
  std::vector<LevelValue> values;
  for (std::uint32_t level = 1; level <= 16; ++level) values.push_back({level, std::exp2(level)});
  const Growth g = fit_growth(values);
  EXPECT_EQ(g.law, GrowthLaw::exponential);
  EXPECT_NEAR(g.exponential.slope, 1, 1e-12);
  EXPECT_NEAR(g.exponential.intercept, 0, 1e-12);
  EXPECT_NEAR(g.exponential.residual, 0, 1e-12);
  EXPECT_EQ(g.levels, 16u);
  EXPECT_EQ(to_string(g), "doubles each level");
}

TEST(BenchGrowth, NamesPowersAndFlatOnes) {
  std::vector<LevelValue> square, flat, quarter;
  for (std::uint32_t level = 1; level <= 16; ++level) {
    square.push_back({level, 3e-6 * level * level});
    flat.push_back({level, level % 2 == 0 ? 0.2 : 0.21});
    quarter.push_back({level, std::exp2(-2.0 * level)});
  }
  const Growth g = fit_growth(square);
  EXPECT_EQ(g.law, GrowthLaw::power);
  EXPECT_NEAR(g.power.slope, 2, 1e-9);
  EXPECT_EQ(to_string(g), "as level^2.0");
  EXPECT_EQ(to_string(fit_growth(flat)), "flat");
  EXPECT_EQ(to_string(fit_growth(quarter)), "x0.25 each level");
}

TEST(BenchGrowth, DrawsNoLineThroughNothing) {
  EXPECT_EQ(to_string(fit_growth({})), "none found");
  const std::vector<LevelValue> zeros{{1, 0}, {2, 0}, {3, 0}}, two{{0, 1}, {1, 0}, {2, 1}, {3, 2}};
  EXPECT_EQ(fit_growth(zeros).law, GrowthLaw::none);
  EXPECT_EQ(to_string(fit_growth(two)), "too few to fit");
  EXPECT_EQ(fit_growth(two).levels, 2u);
}

TEST(BenchGrowth, ReportsTheResidual) {
  // log2: 0, 1, 0, 1 on levels 1..4: the line is level/5, and they are off it by -0.2, 0.6, -0.6, 0.2.
  const std::vector<LevelValue> zigzag{{1, 1}, {2, 2}, {3, 1}, {4, 2}};
  const Growth g = fit_growth(zigzag);
  EXPECT_NEAR(g.exponential.slope, 0.2, 1e-12);
  EXPECT_NEAR(g.exponential.residual, std::sqrt((0.04 + 0.36 + 0.36 + 0.04) / 4), 1e-12);
}

// -- errors

TEST(BenchIndexErrors, ExactSubjectsHaveNone) {
  for (const char* name : {"impl-scalar", "impl-batched", "w-minor-impl", "reference-fixed", "step-fixed",
                           "reference-rational", "step-rational"}) {
    const IndexFigures& f = named(small_run(), name);
    for (const auto& errors : {f.uniform, f.stiff}) {
      ASSERT_EQ(errors.size(), 16u);
      for (const IndexErrors& e : errors) {
        EXPECT_EQ(e.mismatches, 0u) << name << " level " << e.level;
        EXPECT_EQ(e.worst_ulp, 0);
        EXPECT_GT(e.samples, 0u);
      }
    }
    EXPECT_EQ(to_string(f.stiff_rate), "none found");
  }
}

TEST(BenchIndexErrors, RoundedSubjectsAreCaughtOnHardPoints) {
  for (const char* name : {"reference-f16", "step-f16", "reference-f32", "step-f32", "reference-f64",
                           "step-f64", "w-minor-f32", "w-minor-f32-sqrt"}) {
    const IndexErrors& e = at_level(named(small_run(), name).stiff, 8);
    EXPECT_GT(e.mismatches, 0u) << name;
    EXPECT_GT(e.worst_heights, 0) << name;
    std::uint64_t sum = 0;
    for (const std::uint64_t one : e.by_kind) sum += one;
    EXPECT_EQ(sum, e.mismatches) << name;
  }
}

TEST(BenchIndexErrors, WorstDistancesFollowTheirLaws) {
  // The reference's one rounding is half an ulp of 1 at most, in heights, whatever the level.
  for (const IndexErrors& e : named(small_run(), "reference-f32").stiff) EXPECT_LE(e.worst_heights, 0x1p-25);
  EXPECT_EQ(to_string(named(small_run(), "reference-f32").stiff_heights), "flat");
  EXPECT_EQ(to_string(named(small_run(), "step-f32").stiff_heights), "doubles each level");
}

TEST(BenchIndexErrors, FloatRootLeavesTheGridFromLevel13) {
  for (const IndexErrors& e : named(small_run(), "w-minor-f32-sqrt").stiff)
    EXPECT_EQ(e.off_grid > 0, e.level >= 13) << e.level;
  for (const IndexErrors& e : named(small_run(), "w-minor-f32").stiff) EXPECT_EQ(e.off_grid, 0u);
}

TEST(BenchIndexErrors, Binary16EndsAtLevel15) {
  EXPECT_EQ(named(small_run(), "step-f16").stiff.size(), 15u);
  const auto top = index_errors({.samples = 10, .first = 16, .last = 16});
  EXPECT_TRUE(named(top, "step-f16").stiff.empty());
  EXPECT_EQ(named(top, "step-f32").stiff.size(), 1u);
}

TEST(BenchIndexErrors, AreTheSameForAnyNumberOfThreads) {
  const IndexBenchOptions options{.samples = 5000, .seed = 9, .first = 7, .last = 9};
  const auto several = index_errors(options);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_TRUE(same(several, index_errors(options)));
  IndexBenchOptions other = options;
  other.seed = 10;
  EXPECT_FALSE(same(several, index_errors(other)));
}

TEST(BenchIndexErrors, ProgressCountsEveryPoint) {
  std::atomic<std::uint64_t> told = 0;
  IndexBenchOptions options{.samples = 700, .first = 14, .last = 16};
  options.progress = [&told](std::uint64_t points) { told += points; };
  index_errors(options);
  EXPECT_EQ(told, index_points(options));
}

TEST(BenchIndexTimes, ComeWithTheFastestAndTheSlowestRound) {
  IndexBenchOptions options{.samples = 100, .first = 4, .last = 4};
  options.rounds = 3;
  std::vector<IndexFigures> figures = index_errors(options);
  add_index_times(options, figures);
  for (const IndexFigures& f : figures) {
    ASSERT_EQ(f.times.size(), 1u) << f.name;
    EXPECT_GT(f.times[0].least_ns, 0) << f.name;
    EXPECT_LE(f.times[0].least_ns, f.times[0].ns_per_index) << f.name;
    EXPECT_LE(f.times[0].ns_per_index, f.times[0].most_ns) << f.name;
  }
}

TEST(BenchIndexErrors, RefusesLevelsAndSamplesThatMeanNothing) {
  EXPECT_THROW(index_errors({.samples = 0}), std::invalid_argument);
  EXPECT_THROW(index_errors({.samples = 1, .first = 3, .last = 2}), std::invalid_argument);
  EXPECT_THROW(index_errors({.samples = 1, .first = 3, .last = 17}), std::invalid_argument);
}

}  // namespace bench_index_test
