// [release alone] bench/bake: every baker is measured beside the exact states, and what the figures say of them holds.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "bench/bake/bench.hpp"
#include "bench/bake/obvious.hpp"

namespace bench_bake_test {

using namespace mmverify::bench;
using mmverify::impl::bake::AlphaView;
using mmverify::impl::bake::BaseTriangle;

TEST(BenchBake, FiguresKeepTheirOrder) {
  const BakeFigures figures = bake_figures({.first = 4, .last = 5, .maps = 1, .rounds = 3, .largest = 64});
  ASSERT_EQ(figures.levels.size(), 2u);
  EXPECT_GT(figures.compared, 40u);
  for (const BakeLevel& level : figures.levels) {
    const std::uint64_t states = 2u << 2 * level.level;
    for (const Baker b :
         {Baker::centre, Baker::corners, Baker::sixteen_samples, Baker::rasterised, Baker::ours}) {
      EXPECT_EQ(level.of(b).micro_triangles, states);
      EXPECT_GT(level.of(b).least_ns, 0);
      EXPECT_LE(level.of(b).least_ns, level.of(b).ns);
      EXPECT_LE(level.of(b).ns, level.of(b).most_ns);
    }
    EXPECT_EQ(level.of(Baker::ours).wrong + level.of(Baker::ours).needless, 0u);
    EXPECT_EQ(level.of(Baker::centre).needless, 0u) << "it calls nothing unknown";
    // The centre baker settles every micro-triangle, so it is wrong on exactly the unknown ones.
    EXPECT_DOUBLE_EQ(level.of(Baker::centre).wrong_per_million(), 1e6 * level.unknown);
    EXPECT_GT(level.of(Baker::corners).wrong, 0u);
    EXPECT_LT(level.of(Baker::rasterised).wrong_per_million(), 1000);
    EXPECT_GT(level.of(Baker::rational).ns, level.of(Baker::ours).ns);
    EXPECT_LT(level.of(Baker::ours).least_ns, level.of(Baker::ours).most_ns)
        << "no two of three rounds take the same";
  }
  for (std::size_t k = 1; k < figures.margins.size(); ++k)
    EXPECT_GE(figures.margins[k].unknown, figures.margins[k - 1].unknown) << "a wider margin settles nothing";
  ASSERT_EQ(figures.sizes.size(), 1u);
  EXPECT_GT(figures.sizes[0].ready_ms, 0);
}

// Along x, in texels, alpha goes up and down in straight lines: 0 at 1/2, 1 at 3/2, 0 at 5/2.
TEST(BenchBake, ObviousBakersOnATextureWorkedByHand) {
  const std::array<std::uint8_t, 4> texels{0, 255, 0, 255};
  const AlphaView view{texels.data(), 2, 2, 2};
  const BaseTriangle all{{{0.3f, 0}, {0.45f, 0}, {0.3f, 0.2f}}};    // 0.6 to 0.9 texels: 0.1 to 0.4
  const BaseTriangle across{{{0.3f, 0}, {0.7f, 0}, {0.3f, 0.2f}}};  // up to 1.4 texels: 0.9
  const BaseTriangle peak{{{0.25f, 0}, {0.25f, 1}, {1.25f, 0}}};    // centre to centre, over the peak at 3/4
  for (const BakeInto bake : {bake_centre, bake_corners, bake_sixteen, bake_rasterised}) {
    std::array<std::uint8_t, 1> state{9};
    bake({view, 0.5}, all, 0, state);
    EXPECT_EQ(state[0], 0);
    bake({view, 0.05}, all, 0, state);
    EXPECT_EQ(state[0], 1);
    bake({view, 0.5}, across, 0, state);
    EXPECT_EQ(state[0], bake == bake_centre ? 0 : 2);
    bake({view, 0.5}, peak, 0, state);
    EXPECT_EQ(state[0], bake == bake_centre ? 1 : bake == bake_corners ? 0 : 3);
  }
}

TEST(BenchBake, RefusesWhatItCannotMeasure) {
  EXPECT_THROW(bake_figures({.maps = 0}), std::invalid_argument);
  EXPECT_THROW(bake_figures({.rounds = 0}), std::invalid_argument);
  EXPECT_THROW(bake_figures({.first = 5, .last = 4}), std::invalid_argument);
  EXPECT_THROW(bake_figures({.last = 13}), std::invalid_argument);
  EXPECT_THROW(bake_figures({.textures = "no/such/folder"}), std::runtime_error);
}

}  // namespace bench_bake_test
