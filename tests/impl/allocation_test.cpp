// Calls that an engine makes for every ray or triangle allocate no memory.
#include <gtest/gtest.h>

#include <random>

#include "impl/mmverify.h"
#include "impl/mmverify.hpp"
#include "tests/impl/largest_allocation.hpp"

namespace impl_allocation_test {

using namespace mmverify::impl;

/// The largest request of `call`, in bytes.
template <class Call>
std::size_t allocated_by(Call call) {
  mmverify::tests::largest_allocation = 0;
  call();
  return mmverify::tests::largest_allocation;
}

TEST(Allocation, OfLookupsIsNone) {
  const std::vector<float> u(300, 0.25f), v(300, 0.5f);
  std::vector<std::uint32_t> index(300), corners(1800);
  std::vector<std::uint8_t> state(300);
  EXPECT_EQ(allocated_by([&] { index::from_barycentrics(u, v, 7, index); }), 0u);
  EXPECT_EQ(allocated_by([&] { mmverify_index(7, u.data(), v.data(), index.data(), 300); }), 0u);
  EXPECT_EQ(allocated_by([&] { mmverify_corners(7, index.data(), corners.data(), 300); }), 0u);
  EXPECT_EQ(allocated_by([&] { mmverify_row_corners(7, index.data(), corners.data(), 300); }), 0u);
  std::vector<std::uint8_t> map(4096);
  std::mt19937 random(4);
  for (std::uint8_t& b : map) b = static_cast<std::uint8_t>(random());
  const tree::Tree tree = tree::Tree::encode(7, micromap::Format::four_state, map);
  EXPECT_EQ(allocated_by([&] { tree.lookup(index, state); }), 0u);
  const micromap::PackedMap packed{7, micromap::Format::four_state, map};
  const array::Built built = array::build({}, {&packed, 1}, {});
  EXPECT_EQ(allocated_by([&] { array::state_at(built.array, built.part, 0, 0.25f, 0.5f); }), 0u);
}

/// A texture with contours everywhere: but for bilinear BLEND some micro-triangles take whole numbers.
TEST(Allocation, OfABakeIsNoneWithOneMipLevelOrRoom) {
  constexpr std::uint32_t side = 16;
  std::vector<std::uint8_t> texels(std::size_t{side} * side);
  for (std::size_t k = 0; k < texels.size(); ++k) texels[k] = (k + k / side) % 2 == 0 ? 0 : 254;
  const bake::Texels mip = bake::AlphaView{texels.data(), side, side, side};
  const bake::BaseTriangle uv{{{0, 0}, {1, 0}, {0, 1}}};
  std::vector<std::uint8_t> map(1024), room(1024);
  for (const auto filter : {bake::Filter::bilinear, bake::Filter::nearest})
    for (const bake::AlphaMode mode :
         {bake::AlphaMode(bake::Cutoff{127, 255}), bake::AlphaMode(bake::Blend{})})
      for (const float margin : {0.0f, 0.25f}) {
        bake::Sampling how;
        how.filter = filter;
        how.margin = margin;
        const bake::TriangleBaker one({&mip, 1}, mode, how), two(std::array{mip, mip}, mode, how);
        bake::BakeCounts counts;
        EXPECT_EQ(allocated_by([&] { counts = one.bake(uv, 6, map); }), 0u);
        if (filter == bake::Filter::nearest || std::holds_alternative<bake::Cutoff>(mode)) {
          EXPECT_GT(counts.exact, 0u);
        }
        EXPECT_EQ(allocated_by([&] { two.bake(uv, 6, map, room); }), 0u);
        // The test sees what allocates.
        EXPECT_EQ(allocated_by([&] { two.bake(uv, 6, map); }), map.size());
      }
}

TEST(Allocation, OfAUsefulLevelIsNone) {
  // Edges of exactly 5 texels take whole numbers.
  EXPECT_EQ(allocated_by([] { bake::useful_level({{{0, 0}, {0.75f, 0}, {0, 1}}}, 4, 4); }), 0u);
}

}  // namespace impl_allocation_test
