// [release, night] impl/bake/triangles.hpp: flat alpha, repeats, shifts, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "impl/bake/triangles.hpp"

namespace impl_bake_triangles_test {

using namespace mmverify::impl::bake;
using Codes = std::vector<int>;

constexpr Wrap every_wrap[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                               Wrap::clamp_to_border, Wrap::mirror_once};

struct Picture {
  std::uint32_t width, height;
  std::vector<std::uint8_t> alpha;

  AlphaView view() const { return {alpha.data(), width, height, width}; }
};

struct Baked {
  Codes codes;
  BakeCounts counts;
};

Baked bake(const Picture& picture, Cutoff cutoff, const Addressing& addressing, const BaseTriangle& uv,
           std::uint32_t level) {
  const std::size_t count = std::size_t{1} << (2 * level);
  std::vector<std::uint8_t> map((count + 3) / 4, 0xee);
  Baked baked;
  baked.counts = TriangleBaker(picture.view(), cutoff, addressing).bake(uv, level, map);
  for (std::size_t k = 0; k < count; ++k) baked.codes.push_back(map[k / 4] >> (2 * (k % 4)) & 3);
  return baked;
}

Picture random_picture(std::mt19937& random, std::uint32_t most) {
  Picture p{
      1 + static_cast<std::uint32_t>(random() % most), 1 + static_cast<std::uint32_t>(random() % most), {}};
  const auto kind = random() % 4;
  for (std::uint32_t k = 0; k < p.width * p.height; ++k) {
    const std::uint32_t r = static_cast<std::uint32_t>(random());
    p.alpha.push_back(static_cast<std::uint8_t>(kind == 0   ? r % 256
                                                : kind == 1 ? 126 + r % 4
                                                : kind == 2 ? r % 2 * 255
                                                            : 51 * (r % 6)));
  }
  return p;
}

constexpr Cutoff cutoffs[] = {
    {1, 2}, {1, 2}, {128, 255}, {51, 255}, {1, 1}, {0, 1}, {1, 3}, {3, 2}, {0x7fffffff, 0xffffffff}};

float up(float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }
float down(float x) { return std::nextafter(x, -std::numeric_limits<float>::infinity()); }

/// On texel lines and centres of 2x2 textures, ulps off them, flipped, over several repeats, slivers, lines,
/// points.
const std::vector<BaseTriangle> family_triangles{
    {{{0, 0}, {1, 0}, {0, 1}}},
    {{{1, 1}, {0, 1}, {1, 0}}},
    {{{0.25f, 0.25f}, {0.75f, 0.25f}, {0.25f, 0.75f}}},
    {{{up(0.25f), down(0.25f)}, {down(0.75f), 0.25f}, {0.25f, up(0.75f)}}},
    {{{down(0.5f), 0.5f}, {up(1.5f), down(0.5f)}, {-0.5f, down(1.0f)}}},
    {{{-1, -1}, {2, -0.5f}, {-0.25f, 1.75f}}},
    {{{0.125f, 0.875f}, {0.625f, 0.375f}, {0.375f, 0.125f}}},
    {{{0.1f, 0.2f}, {0.9f, 0.3f}, {0.4f, 0.8f}}},
    {{{0.25f, 0.25f}, {1.25f, up(0.25f)}, {0.25f, 0.25f}}},
    {{{-0.75f, 1.25f}, {1.25f, -0.75f}, {0.25f, up(0.25f)}}},
    {{{-0.5f, 0.75f}, {1, 0.75f}, {0.5f, 0.75f}}},
    {{{0.75f, 0.25f}, {0.75f, 0.25f}, {0.75f, 0.25f}}},
};

TEST(ImplBakeTriangles, AMillionRepeats) {
  const BaseTriangle vast{{{-500000, -500000}, {500000, -500000}, {-500000, 500000}}};
  const Addressing repeat{Wrap::repeat, Wrap::repeat};
  for (const std::uint8_t byte : std::initializer_list<std::uint8_t>{0, 127, 128, 255})
    EXPECT_EQ(bake({2, 1, {byte, byte}}, {1, 2}, repeat, vast, 2).codes, Codes(16, byte < 128 ? 0 : 1));
  for (const int code : bake({2, 2, {0, 255, 0, 0}}, {1, 2}, repeat, vast, 3).codes) EXPECT_GE(code, 2);
  for (const int code :
       bake({2, 2, {0, 255, 0, 0}}, {1, 2}, {Wrap::mirrored_repeat, Wrap::repeat}, vast, 3).codes)
    EXPECT_GE(code, 2);
}

TEST(ImplBakeTriangles, FlatAlphaAtTheCutoffIsOpaque) {
  for (const Cutoff cutoff : {Cutoff{128, 255}, {256, 510}}) {
    for (const BaseTriangle& uv : family_triangles)
      for (const Wrap wrap : every_wrap) {
        EXPECT_EQ(bake({2, 2, {128, 128, 128, 128}}, cutoff, {wrap, wrap, 128}, uv, 2).codes, Codes(16, 1));
        EXPECT_EQ(bake({2, 2, {127, 127, 127, 127}}, cutoff, {wrap, wrap, 127}, uv, 2).codes, Codes(16, 0));
      }
  }
  // 0 and 255 meet at 127.5, in a line; beyond the outer centres the texture is flat.
  const BaseTriangle left{{{0, 0}, {0.5f, 0}, {0, 1}}}, right{{{1, 0}, {1, 1}, {up(0.5f), 0}}};
  const Addressing clamp{Wrap::clamp_to_edge, Wrap::clamp_to_edge};
  EXPECT_EQ(bake({2, 1, {255, 0}}, {1, 2}, clamp, left, 0).codes, Codes{1});
  EXPECT_EQ(bake({2, 1, {255, 0}}, {1, 2}, clamp, right, 0).codes, Codes{0});
  EXPECT_EQ(bake({2, 1, {255, 0}}, {1, 2}, clamp, {{{0, 0}, {up(0.5f), 0}, {0, 1}}}, 0).codes, Codes{3});
}

TEST(ImplBakeTriangles, WholeNumberShiftsChangeNothingWithRepeat) {
  std::mt19937 random(8);
  for (int round = 0; round < 300; ++round) {
    const Picture picture = random_picture(random, 7);
    BaseTriangle uv, shifted;
    const bool mirrored = round % 2 != 0;
    const float by_u = static_cast<float>(static_cast<int>(random() % 2001) - 1000) * (mirrored ? 2 : 1),
                by_v = static_cast<float>(static_cast<int>(random() % 9) - 4) * (mirrored ? 2 : 1);
    for (std::size_t k = 0; k < 3; ++k) {
      uv[k] = {static_cast<float>(random() % 3001) / 1024, static_cast<float>(random() % 3001) / 1024};
      shifted[k] = {uv[k].u + by_u, uv[k].v + by_v};
    }
    const Wrap wrap = mirrored ? Wrap::mirrored_repeat : Wrap::repeat;
    const Cutoff cutoff = cutoffs[random() % 9];
    ASSERT_EQ(bake(picture, cutoff, {wrap, wrap}, uv, 4).codes,
              bake(picture, cutoff, {wrap, wrap}, shifted, 4).codes)
        << round;
  }
}

TEST(ImplBakeTriangles, RefusesWhatIsNone) {
  const Picture picture{2, 2, {0, 0, 0, 0}};
  const TriangleBaker baker(picture.view(), {});
  std::vector<std::uint8_t> map(4, 0xee);
  const BaseTriangle fine{{{0, 0}, {1, 0}, {0, 1}}};
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), 0x1p20f, -0x1p20f})
    for (std::size_t k = 0; k < 3; ++k)
      for (const bool u : {true, false}) {
        BaseTriangle uv = fine;
        (u ? uv[k].u : uv[k].v) = bad;
        EXPECT_THROW(baker.bake(uv, 2, map), std::invalid_argument);
      }
  EXPECT_THROW(baker.bake(fine, 1, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, 3, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, max_bake_level + 1, map), std::invalid_argument);
  EXPECT_THROW(baker.bake(fine, 0xffffffff, map), std::invalid_argument);
  EXPECT_EQ(map, std::vector<std::uint8_t>(4, 0xee));
  EXPECT_NO_THROW(baker.bake(fine, 2, map));
  for (const auto& [width, height] : {std::pair{0u, 2u}, {2u, 0u}, {16385u, 1u}, {1u, 0xffffffffu}})
    EXPECT_THROW(TriangleBaker({picture.alpha.data(), width, height, 2}, {}), std::invalid_argument);
  EXPECT_THROW(TriangleBaker(picture.view(), {1, 0}), std::invalid_argument);
}

}  // namespace impl_bake_triangles_test
