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

TYPED_TEST(ImplBakeKinds, StatesAreTheSpecifications) {
  Random random(1);
  Seen seen;
  for (int round = 0; round < (sanitized ? 60 : 800); ++round)
    ASSERT_NO_FATAL_FAILURE(expect_specified(random_job<TypeParam>(random), seen));
  expect_varied(seen);
}

TYPED_TEST(ImplBakeKinds, SeveralMipsAreTheSpecifications) {
  Random random(2);
  Seen seen;
  for (int round = 0; round < (sanitized ? 20 : 200); ++round) {
    Job<TypeParam> job = random_job<TypeParam>(random);
    job.mips.push_back(random_image<TypeParam>(random, 2, 1));
    if (random() % 2 == 0) job.mips.push_back(random_image<TypeParam>(random, 1, 1));
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
  expect_varied(seen);
}

TYPED_TEST(ImplBakeKinds, DilatedTheyAreTheSpecifications) {
  constexpr float margins[] = {0.25f, 1, 0.5f, 0x1p-8f, 1.0f / 3, 2.5f, 0x1p-149f, 0x1.fffffep-2f};
  Random random(3);
  Seen seen;
  for (int round = 0; round < (sanitized ? 20 : 200); ++round) {
    Job<TypeParam> job = random_job<TypeParam>(random);
    job.sampling.margin = margins[random() % 8];
    if (random() % 4 == 0) job.mips.push_back(random_image<TypeParam>(random, 2, 2));
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
  expect_varied(seen);
}

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

TEST(ImplBakeFamily, AllTexturesOf2x2ThreeLettersAreTheSpecifications) {
  Seen seen;
  std::uint64_t turn = 0;
  for (const AlphaMode& mode : {AlphaMode{Blend{}}, AlphaMode{Mask{0.5f}}})
    for (int filling = 0; filling < 81; ++filling)
      for (const Filter filter : {Filter::bilinear, Filter::nearest})
        for (const Wrap x : every_wrap) {
          if (sanitized && ++turn % 10 != 0) continue;
          Job<std::uint8_t> job{{{2, 2, {}}}, mode, {}, {}, 0};
          constexpr std::uint8_t letters[] = {0, 128, 255};
          for (int k = 0, rest = filling; k < 4; ++k, rest /= 3)
            job.mips[0].texels.push_back(letters[rest % 3]);
          job.sampling = {x, every_wrap[(filling + static_cast<int>(x)) % 5], filter,
                          static_cast<float>(letters[filling % 3])};
          for (std::size_t t = 0; t < family_triangles.size(); ++t) {
            job.uv = family_triangles[t];
            // Each of the levels for each of the triangles, over the fillings.
            job.level = static_cast<std::uint32_t>((static_cast<std::size_t>(filling) + t) % 3);
            ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
          }
        }
  expect_varied(seen);
}

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

// ---------------------------------------------------------------------------------------------------------------------
// Hostile
// ---------------------------------------------------------------------------------------------------------------------

TYPED_TEST(ImplBakeKinds, SliversAreTheSpecifications) {
  Random random(4);
  Seen seen;
  for (int round = 0; round < (sanitized ? 10 : 100); ++round) {
    Job<TypeParam> job = random_job<TypeParam>(random);
    const float x = static_cast<float>(random() % 8) / 8, y = static_cast<float>(random() % 8) / 8,
                thin = 0x1p-20f * static_cast<float>(1 + random() % 3),
                length = 1 + static_cast<float>(random() % 3);
    job.uv = {{{x, y}, {x + length, random() % 2 == 0 ? y + length : y}, {x, y + thin}}};
    if (random() % 2 == 0)
      for (TexturePoint& p : job.uv) std::swap(p.u, p.v);
    if (random() % 4 == 0) job.sampling.margin = 0x1p-20f;
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
  }
}

TYPED_TEST(ImplBakeKinds, ExtremeCoordinatesAreTheSpecifications) {
  constexpr float least = std::numeric_limits<float>::denorm_min();
  const float greatest = down(0x1p20f), normal_one = std::numeric_limits<float>::min();
  const std::vector<BaseTriangle> triangles{
      {{{least, 0}, {0, -least}, {1, 1}}},
      {{{0.25f, 0.25f}, {1, least}, {-normal_one, 1}}},
      {{{0.25f, 0.25f}, {0.75f, 0x1p-30f}, {-0x1p-28f, 0.75f}}},
      {{{greatest, -greatest}, {down(greatest), -greatest}, {greatest, -down(down(greatest))}}},
      {{{100000.25f, 7.5f}, {100001, 7.25f}, {100000, 8}}},
  };
  Random random(5);
  Seen seen;
  for (const BaseTriangle& uv : triangles)
    for (int round = 0; round < (sanitized ? 2 : 12); ++round) {
      Job<TypeParam> job = random_job<TypeParam>(random);
      job.uv = uv;
      ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen));
    }
}

// Real sizes, at a level where micro-triangles are about a texel.
TYPED_TEST(ImplBakeKinds, DeepLevelsAreTheSpecifications) {
  Random random(6);
  Seen seen;
  constexpr bool floats = std::is_same_v<TypeParam, float>;
  constexpr double full = floats ? 1 : static_cast<double>(std::numeric_limits<TypeParam>::max());
  Job<TypeParam> job{{{61, 47, {}}}, Mask{0.5f}, {}, {{{0.11f, 0.07f}, {0.93f, 0.31f}, {0.38f, 0.97f}}}, 6};
  for (std::uint32_t k = 0; k < 61 * 47; ++k) {
    const double alpha = 0.5 + 0.05 * (20 - std::hypot(k % 61 - 30.0, k / 61 - 23.0)) +
                         static_cast<int>(random() % 20) * 0.005;
    const double stored = full * std::clamp(alpha, 0.0, 1.0);
    job.mips[0].texels.push_back(static_cast<TypeParam>(floats ? stored : std::floor(stored)));
  }
  for (const AlphaMode& mode : {AlphaMode{Mask{0.5f}}, AlphaMode{Blend{}}})
    for (const Filter filter : {Filter::bilinear, Filter::nearest})
      for (const float margin : {0.0f, 0.5f}) {
        job.mode = mode;
        job.sampling.filter = filter;
        job.sampling.margin = margin;
        ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen, sanitized ? 997 : 83));
      }
  for (const std::uint64_t n : seen.states) EXPECT_GT(n, 0u);
  EXPECT_LT(seen.exact, seen.leaves);
}

}  // namespace
