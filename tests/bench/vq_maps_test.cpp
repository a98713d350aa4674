// [release alone] bench/vq_maps: maps of leaves and of real textures keep what alpha's continuity and nested regions promise.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "bench/textures/leaf_texture.hpp"
#include "bench/vq/maps.hpp"
#include "spec/vq/vq.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::bench;
using mmverify::impl::vq::State;
namespace spec = mmverify::spec::vq;

template <std::size_t side, class States>
bool valid(const States& states) {
  spec::Vector<side> v{};
  for (std::size_t k = 0; k < v.size(); ++k) v[k] = static_cast<spec::State>(states[k]);
  return spec::valid<side>(v);
}

/// A region that is O or T has the same state in each of the four regions that it is cut into.
template <std::size_t side, class Coarse, class Fine>
void expect_nested(const Coarse& coarse, const Fine& fine) {
  for (std::size_t y = 0; y < 2 * side; ++y)
    for (std::size_t x = 0; x < 2 * side; ++x) {
      const State above = coarse[x / 2 + side * (y / 2)];
      ASSERT_TRUE(above == State::C || fine[x + 2 * side * y] == above) << x << ' ' << y;
    }
}

void expect_sound(const OpacityMaps& maps) {
  SCOPED_TRACE(maps.of);
  EXPECT_TRUE(valid<8>(maps.regions_8));
  EXPECT_TRUE(valid<16>(maps.regions_16));
  EXPECT_TRUE(valid<32>(maps.regions_32));
  expect_nested<8>(maps.regions_8, maps.regions_16);
  expect_nested<16>(maps.regions_16, maps.regions_32);
  for (std::size_t k = 0; k < 64; ++k) {
    const State lower = maps.sub_triangles_64x2[2 * k], upper = maps.sub_triangles_64x2[2 * k + 1];
    EXPECT_EQ(maps.regions_8[k], lower == upper ? lower : State::C);
    EXPECT_TRUE(lower == upper || lower == State::C || upper == State::C);
  }
  EXPECT_LE(savings(maps.regions_8), savings(maps.sub_triangles_64x2));
  EXPECT_LE(savings(maps.regions_8), savings(maps.regions_16));
  EXPECT_LE(savings(maps.regions_16), savings(maps.regions_32));
}

TEST(BenchVqMaps, LeavesAreSound) {
  const auto all = leaf_opacity_maps(sanitized ? 5 : 100, 1);
  EXPECT_EQ(all.size(), sanitized ? 5u : 100u);
  std::set<mmverify::impl::vq::Map4> distinct;
  for (const OpacityMaps& maps : all) {
    expect_sound(maps);
    distinct.insert(maps.regions_32);
    // Cropped: something opaque reaches each edge of the map.
    const auto& m = maps.regions_32;
    bool left = false, right = false, bottom = false, top = false;
    for (std::size_t k = 0; k < 32; ++k) {
      left = left || m[32 * k] != State::T;
      right = right || m[31 + 32 * k] != State::T;
      bottom = bottom || m[k] != State::T;
      top = top || m[k + 32 * 31] != State::T;
    }
    EXPECT_TRUE(left && right && bottom && top) << maps.of;
  }
  EXPECT_EQ(distinct.size(), all.size());
  // A seed means one picture.
  EXPECT_EQ(leaf_texture(7).alpha, leaf_texture(7).alpha);
  EXPECT_EQ(leaf_opacity_maps(1, 5)[0].regions_32, all[4].regions_32);
}

TEST(BenchVqMaps, WithoutAnOpaqueTexelThereIsNoMap) {
  const std::vector<AlphaTexture> textures{{"clear", 2, 1, {127, 0}}, {"speck", 3, 2, {0, 0, 0, 0, 128, 0}}};
  const auto maps = opacity_maps(textures);
  ASSERT_EQ(maps.size(), 1u);
  EXPECT_EQ(maps[0].of, "speck");
  EXPECT_EQ(savings(maps[0].regions_16), 1);
  EXPECT_EQ(maps[0].regions_16[0], State::O);
}

TEST(BenchVqMaps, SavingsAreTheShareOfOpaqueAndTransparent) {
  const State states[] = {State::O, State::C, State::T, State::O};
  EXPECT_EQ(savings(states), 0.75);
}

// Real foliage textures, skipped where the checkout has none beside it.
TEST(BenchVqMaps, RealTexturesAreSound) {
  const std::string folder = MMVERIFY_ALPHA_TEXTURES;
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no textures in " << folder;
  const auto textures = alpha_textures(folder);
  const auto all = opacity_maps(textures);
  EXPECT_EQ(all.size(), textures.size());
  for (const OpacityMaps& maps : all) expect_sound(maps);
}

}  // namespace
