// [release, night] Bakes with room: textures far larger than a micro-triangle, and micro-triangles of many texels; every target of
// Highway makes the same map.
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
class ImplBakeRoom : public testing::Test {};
using TexelTypes = testing::Types<std::uint8_t, std::uint16_t, float>;
TYPED_TEST_SUITE(ImplBakeRoom, TexelTypes);

/// A texture that has room around most micro-triangles, which the vector code asks for: noise, flat but for a
/// few texels, or slanted; at a limit or across it.
template <class Texel>
Image<Texel> roomy_image(Random& random) {
  const auto side = [&random] { return 24 + static_cast<std::uint32_t>(random() % 30); };
  Image<Texel> image{side(), side(), {}};
  constexpr bool floats = std::is_same_v<Texel, float>;
  constexpr double full = floats ? 1 : static_cast<double>(std::numeric_limits<Texel>::max());
  const auto kind = random() % 4;
  // At a cutoff, or far above it: what differs inside of a micro-triangle may then be all that tells.
  const Texel flat = static_cast<Texel>(random() % 2 == 0 ? full : floats ? 0.5 : full / 2 + 1);
  const double slope_x = static_cast<int>(random() % 9) - 4, slope_y = static_cast<int>(random() % 9) - 4;
  for (std::uint32_t k = 0; k < image.width * image.height; ++k) {
    const double slant = 0.5 + (slope_x * (k % image.width - 20.0) + slope_y * (k / image.width - 20.0)) / 64;
    const double alpha = std::clamp(slant, 0.0, 1.0) * full;
    image.texels.push_back(kind == 0   ? random_texel<Texel>(random, 2)
                           : kind == 1 ? random_texel<Texel>(random, 1)
                           : kind == 2 ? (random() % 40 == 0 ? random_texel<Texel>(random, 1) : flat)
                                       : static_cast<Texel>(floats ? alpha : std::floor(alpha)));
  }
  return image;
}

/// Of one shape, from slivers to right angles, on texel lines, on centres and off them.
template <class Texel>
Job<Texel> roomy_job(Random& random) {
  Job<Texel> job{{roomy_image<Texel>(random)},
                 random() % 3 == 0 ? AlphaMode{Blend{}} : AlphaMode{Mask{0.5f}},
                 {},
                 {},
                 2 + static_cast<std::uint32_t>(random() % 3)};
  // At the flat texels.
  if (random() % 3 == 0 && std::is_same_v<Texel, std::uint8_t>) job.mode = Cutoff{128, 255};
  if (random() % 3 == 0 && std::is_same_v<Texel, std::uint16_t>) job.mode = Cutoff{32768, 65535};
  job.sampling.u = every_wrap[random() % 5];
  job.sampling.v = every_wrap[random() % 5];
  if (random() % 4 == 0) job.sampling.factors[0] = 0.75f;
  const auto near = [&](std::uint32_t size) {
    const int kind = static_cast<int>(random() % 4);
    if (kind == 0) return 0.1f + 0.8f * (static_cast<float>(random() >> 8) * 0x1p-24f);
    const auto on = static_cast<float>(4 + random() % (2 * size - 8)) / static_cast<float>(2 * size);
    return kind == 1 ? on : kind == 2 ? up(on) : down(on);
  };
  for (TexturePoint& p : job.uv) p = {near(job.mips[0].width), near(job.mips[0].height)};
  if (random() % 6 == 0) job.uv[2] = {up(job.uv[0].u), down(job.uv[1].v)};
  if (random() % 12 == 0) job.uv[2] = job.uv[0];
  if (random() % 4 == 0)
    for (TexturePoint& p : job.uv) p = {p.u + 3, p.v - 5};
  return job;
}

TYPED_TEST(ImplBakeRoom, TexturesWithRoomAreTheSpecifications) {
  Random random(7);
  Seen seen;
  for (int round = 0; round < (sanitized ? 20 : 200); ++round) {
    const Job<TypeParam> job = roomy_job<TypeParam>(random);
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen, 7 + static_cast<std::uint32_t>(random() % 5)));
  }
  expect_varied(seen);
}

// Micro-triangles of forty texels, most of them alike, which are judged by their parts.
TYPED_TEST(ImplBakeRoom, LargeMicroTrianglesAreTheSpecifications) {
  Random random(9);
  Seen seen;
  for (int round = 0; round < (sanitized ? 2 : 12); ++round) {
    constexpr std::uint32_t side = 180;
    Job<TypeParam> job{{{side, side, {}}}, Mask{0.5f}, {}, {}, 2};
    const auto full = random_texel<TypeParam>(random, 1);
    constexpr TypeParam most =
        std::is_same_v<TypeParam, float> ? TypeParam{1} : std::numeric_limits<TypeParam>::max();
    const TypeParam other = full > 0 ? TypeParam{0} : most;
    // Half of it, or ten texels of it, are different.
    for (std::uint32_t k = 0; k < side * side; ++k)
      job.mips[0].texels.push_back(round % 2 == 0 && k % side + k / side > side ? other : full);
    for (int k = 0; k < 10; ++k) job.mips[0].texels[random() % (side * side)] = other;
    for (TexturePoint& p : job.uv)
      p = {static_cast<float>(random() % 1001) / 1000, static_cast<float>(random() % 1001) / 1000};
    ASSERT_NO_FATAL_FAILURE(expect_specified(job, seen, 5));
  }
}

// Whatever the vectors' width, and at levels where micro-triangles are far smaller than a texel.
TYPED_TEST(ImplBakeRoom, EveryTargetMakesTheSameMap) {
  using Maps = std::vector<std::vector<std::uint8_t>>;
  const auto bake = [] {
    Random random(8);
    Maps maps;
    for (int round = 0; round < (sanitized ? 10 : 60); ++round) {
      Job<TypeParam> job = roomy_job<TypeParam>(random);
      job.level = static_cast<std::uint32_t>(random() % 8);
      maps.emplace_back(job.level == 0 ? 1 : std::size_t{1} << (2 * job.level - 2));
      baker(job).bake(job.uv, job.level, maps.back());
    }
    return maps;
  };
  const Maps expected = bake();
  on_every_target([&] { EXPECT_EQ(bake(), expected); });
}

}  // namespace
