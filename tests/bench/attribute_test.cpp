// [release alone] bench/attribute: every way is measured, what is exact is never wrong, and what is known to fail does.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <stdexcept>
#include <vector>

#include "bench/attribute/bench.hpp"
#include "bench/attribute/obvious.hpp"
#include "bench/attribute/points.hpp"
#include "impl/attribute/lookup.hpp"

namespace bench_attribute_test {

using namespace mmverify::bench;
namespace fast = mmverify::impl::attribute;

const AttributeBenchOptions small{.first = 3, .last = 3, .samples = 2000, .rounds = 1, .triangles = 8};

TEST(BenchAttribute, MeasuresEveryWayOfALevel) {
  const AttributeFigures figures = attribute_figures(small);
  ASSERT_EQ(figures.lookups.size(), 1u);
  ASSERT_EQ(figures.lookups[0].orders.size(), 6u);
  EXPECT_GT(figures.lookups[0].figure_4_ns, 0);
  for (const AttributeOrderTimes& o : figures.lookups[0].orders) {
    EXPECT_GT(o.index_ns, 0) << o.order;
    EXPECT_GT(o.vertex_ns, 0) << o.order;
    EXPECT_GT(o.triplet_ns, 0) << o.order;
    EXPECT_GT(o.lookup_ns.value(), 0) << o.order;
    EXPECT_GT(o.lookup_to_bilinear.value(), 0) << o.order;
  }
  ASSERT_EQ(figures.bakes.size(), 2u) << "linear and sRGB of the level that is nearest to those of bakes";
  for (const AttributeBakeLevel& level : figures.bakes) {
    EXPECT_EQ(level.level, 3u);
    EXPECT_EQ(level.of(AttributeBakeWay::faces).wrong + level.of(AttributeBakeWay::vertices).wrong, 0u);
    EXPECT_GT(level.of(AttributeBakeWay::centres).wrong, 0u);
    EXPECT_GT(level.face_values, 0u);
  }
  ASSERT_EQ(figures.mips.size(), 1u);
  for (const MipTime& m : figures.mips[0].ways) EXPECT_GT(m.ns, 0) << m.way;
}

TEST(BenchAttribute, OnlyCramersRuleLosesBitsFromLevelToLevel) {
  AttributeBenchOptions o = small;
  o.first = 1;
  o.last = 14;
  const std::vector<RemapLevel> levels = attribute_remaps(o);
  ASSERT_EQ(levels.size(), 14u);
  for (const RemapLevel& l : levels)
    for (const Remap r : {Remap::two_equations, Remap::pattern, Remap::ours}) {
      // Two equations round w1, w2 and both differences of 1 - w1 - w2.
      EXPECT_LE(l.of(r).worst, r == Remap::ours ? 0x1p-24 : 0x1p-23) << to_string(r) << ", level " << l.level;
      EXPECT_EQ(l.of(r).no_number, 0u);
      // An error of 2^-24 is half an ulp of 1, and 2^12 times as many of a weight of 2^-12.
      EXPECT_LE(l.of(r).worst_ulp, l.of(r).worst * 0x1p23 / least_in_ulps);
    }
  for (const RemapFigure& f : levels[7].by) {
    EXPECT_GT(f.least_ns, 0);
    EXPECT_LE(f.least_ns, f.ns);
    EXPECT_LE(f.ns, f.most_ns);
  }
  EXPECT_EQ(levels[7].of(Remap::cramer).condition, 511);
  EXPECT_EQ(levels[7].of(Remap::two_equations).condition, 1);
  EXPECT_FALSE(levels[7].of(Remap::pattern).condition);
  EXPECT_GT(levels[7].of(Remap::cramer).worst, 100 * levels[3].of(Remap::cramer).worst);
}

TEST(BenchAttribute, LevelsOfDetailAreExactButForTheLogarithm) {
  const std::vector<LodFigure> figures = attribute_lods(small);
  ASSERT_EQ(figures.size(), 4u);
  EXPECT_GT(figures[0].wrong, 0u);
  for (std::size_t k = 1; k < figures.size(); ++k) EXPECT_EQ(figures[k].wrong, 0u) << figures[k].way;
}

TEST(BenchAttribute, Figure4IsRightAtLowLevels) {
  std::mt19937_64 random(1);
  const FloatPoints p = uniform_points(4096, random);
  for (std::size_t k = 0; k < p.u.size(); ++k) {
    const auto theirs = figure_4_triplet(p.u[k], p.v[k], 4);
    auto ours = fast::triplet(fast::VertexOrder::w_minor, p.u[k], p.v[k], 4);
    // Theirs begins with the row's first vertex: the base of a lower micro-triangle, the last corner of an upper one.
    EXPECT_EQ(std::set(theirs.begin(), theirs.end()), std::set(ours.begin(), ours.end())) << k;
  }
}

TEST(BenchAttribute, BilinearSamplesAreTheSameInSimd) {
  std::mt19937_64 random(1);
  const FloatPoints p = uniform_points(1003, random);
  for (const std::uint32_t level : {0u, 1u, 5u}) {
    std::vector<std::uint32_t> texels(std::size_t{1} << 2 * level), out(p.u.size());
    for (std::uint32_t& x : texels) x = static_cast<std::uint32_t>(random());
    const SquareTexture texture{texels, level};
    bilinear_rgba8(texture, p.u, p.v, out);
    for (std::size_t k = 0; k < out.size(); ++k)
      EXPECT_EQ(out[k], bilinear_rgba8(texture, p.u[k], p.v[k])) << level << " " << k;
  }
  // A texture of 2 x 2: at the centre of a texel its value, between two the mean.
  const std::vector<std::uint32_t> four{0, 100, 200, 255};
  EXPECT_EQ(bilinear_rgba8({four, 1}, 0.25f, 0.25f), 0u);
  EXPECT_EQ(bilinear_rgba8({four, 1}, 0.5f, 0.25f), 50u);
  EXPECT_EQ(bilinear_rgba8({four, 1}, 0.75f, 0.75f), 255u);
  EXPECT_EQ(bilinear_rgba8({four, 1}, 1.0f, 0.25f), 50u) << "repeated";
}

TEST(BenchAttribute, RefusesWhatItCannotMeasure) {
  EXPECT_THROW(attribute_figures({.samples = 0}), std::invalid_argument);
  EXPECT_THROW(attribute_figures({.rounds = 0}), std::invalid_argument);
  EXPECT_THROW(attribute_figures({.first = 5, .last = 4}), std::invalid_argument);
  EXPECT_THROW(attribute_figures({.last = 17}), std::invalid_argument);
}

}  // namespace bench_attribute_test
