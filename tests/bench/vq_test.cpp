// [release alone] bench/vq: every encoder is measured on every map, and what the figures say of them holds.
#include "impl/vq/vq.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "bench/vq/bench.hpp"

namespace bench_vq_test {

using namespace mmverify::bench;

TEST(BenchVq, FiguresKeepTheirOrder) {
  const VqFigures figures = vq_figures({.maps = 3, .rounds = 1});
  ASSERT_EQ(figures.rows.size(), 3u);
  const std::vector<OpacityMaps> maps = leaf_opacity_maps(3, 1);
  for (std::size_t k = 0; k < 3; ++k) {
    const VqRow& row = figures.rows[k];
    const auto counted = [](const auto& map) {
      return static_cast<std::uint32_t>(
          std::count_if(map.begin(), map.end(), [](auto s) { return s != mmverify::impl::vq::State::C; }));
    };
    EXPECT_EQ(row.states_16, counted(maps[k].regions_16));
    EXPECT_EQ(row.states_32, counted(maps[k].regions_32));
    EXPECT_EQ(row.discontinuous, 0u) << "alpha is continuous";
    EXPECT_LE(row.by(Vq2Encoder::optimal).substitutions, row.by(Vq2Encoder::paper).substitutions);
    for (const Vq4Encoder e : {Vq4Encoder::paper, Vq4Encoder::paper_free_c, Vq4Encoder::fast,
                               Vq4Encoder::balanced, Vq4Encoder::thorough, Vq4Encoder::proved}) {
      EXPECT_GE(row.by(e).substitutions, row.least);
      EXPECT_LE(row.savings(e), row.savings_32);
      EXPECT_GT(row.by(e).least_ms, 0);
      EXPECT_LE(row.by(e).least_ms, row.by(e).ms);
      EXPECT_LE(row.by(e).ms, row.by(e).most_ms);
    }
    EXPECT_LE(row.by(Vq4Encoder::balanced).substitutions, row.by(Vq4Encoder::fast).substitutions);
    EXPECT_LE(row.by(Vq4Encoder::proved).substitutions, row.by(Vq4Encoder::thorough).substitutions);
  }
  EXPECT_GT(figures.vq4.map_by_regions_ns, 0);
}

TEST(BenchVq, CountsTransforms) {
  std::vector<VqRow> rows(5);
  const std::uint32_t chosen[] = {7, 511, 7, 0, 7};
  for (std::size_t k = 0; k < 5; ++k) rows[k].vq2[0].transforms = chosen[k];
  const auto counts =
      transform_counts(rows, [](const VqRow& row) { return row.by(Vq2Encoder::paper).transforms; });
  const std::vector<std::pair<std::uint32_t, std::size_t>> expected{{7, 3}, {0, 1}, {511, 1}};
  EXPECT_EQ(counts, expected);
}

TEST(BenchVq, RefusesWhatItCannotMeasure) {
  EXPECT_THROW(vq_figures({.maps = 0}), std::invalid_argument);
  EXPECT_THROW(vq_figures({.rounds = 0}), std::invalid_argument);
  EXPECT_THROW(vq_figures({.textures = "no/such/folder"}), std::runtime_error);
}

}  // namespace bench_vq_test
