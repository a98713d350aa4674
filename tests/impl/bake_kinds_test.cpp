// [release, night] impl/bake/triangles.hpp: every kind of texel, mode, filter, factor, mip and margin as spec/bake/state.hpp
// has it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/impl/bake_jobs.hpp"
#include "tests/impl/every_target.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::tests;

template <class Texel>
class ImplBakeKinds : public testing::Test {};
using Kinds = testing::Types<std::uint8_t, std::uint16_t, float>;
TYPED_TEST_SUITE(ImplBakeKinds, Kinds);

// ---------------------------------------------------------------------------------------------------------------------
// Families, all of them
// ---------------------------------------------------------------------------------------------------------------------

const std::vector<BaseTriangle> family_triangles{
    {{{0, 0}, {1, 0}, {0, 1}}},
    {{{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}}},
    {{{up(0.25f), down(0.25f)}, {down(0.75f), 0.25f}, {0.25f, up(0.75f)}}},
    {{{-0.75f, 1.25f}, {1.25f, -0.75f}, {0.25f, up(0.25f)}}},
    {{{0.1f, 0.2f}, {0.9f, 0.3f}, {0.4f, 0.8f}}},
    {{{0.75f, 0.25f}, {0.75f, 0.25f}, {0.75f, 0.25f}}},
};

// A third of a cutoff and of 1, and 0 itself: flat alpha at a limit is opaque there, and transparent at 0.
TEST(ImplBakeFamily, FlatAlphaAtALimitIsOnItsSide) {
  const auto states = [](float texel, const AlphaMode& mode, std::array<float, 2> factors, float margin) {
    Job<float> job{{{2, 2, {texel, texel, texel, texel}}}, mode, {}, family_triangles[2], 2};
    job.sampling.border = texel;
    job.sampling.factors = factors;
    job.sampling.margin = margin;
    std::vector<std::uint8_t> map(4);
    baker(job).bake(job.uv, job.level, map);
    for (const std::uint8_t byte : map) EXPECT_EQ(byte, map[0]);
    return map[0];
  };
  constexpr std::uint8_t T = 0, O = 0x55, UT = 0xaa, UO = 0xff;
  for (const float margin : {0.0f, 0.75f}) {
    EXPECT_EQ(states(0.5f, Mask{0.25f}, {0.5f, 1}, margin), O);
    EXPECT_EQ(states(down(0.5f), Mask{0.25f}, {0.5f, 1}, margin), T);
    EXPECT_EQ(states(0.5f, Mask{0.25f}, {down(0.5f), 1}, margin), T);
    EXPECT_EQ(states(0x1p-100f, Mask{0x1p-149f}, {0x1p-49f, 1}, margin), O);
    EXPECT_EQ(states(0x1p-100f, Mask{0x1p-149f}, {0x1p-25f, down(0x1p-24f)}, margin), T);
    EXPECT_EQ(states(0, Mask{0}, {0, 1}, margin), O);
    EXPECT_EQ(states(1, Mask{0x1p-149f}, {0, 1}, margin), T);
    EXPECT_EQ(states(-1, Mask{-1}, {1, 1}, margin), O);
    EXPECT_EQ(states(4, Blend{}, {0.5f, 0.5f}, margin), O);
    EXPECT_EQ(states(down(4.0f), Blend{}, {0.5f, 0.5f}, margin), UO);
    EXPECT_EQ(states(down(2.0f), Blend{}, {0.5f, 0.5f}, margin), UT);
    EXPECT_EQ(states(2, Blend{}, {0.5f, 0.5f}, margin), UO);
    EXPECT_EQ(states(0x1p-149f, Blend{}, {0x1p-149f, 1}, margin), UT);
    EXPECT_EQ(states(-0.0f, Blend{}, {1, 1}, margin), T);
    EXPECT_EQ(states(-3, Blend{}, {1, 1}, margin), T);
    EXPECT_EQ(states(3, Blend{}, {0, 1}, margin), T);
  }
}

}  // namespace
