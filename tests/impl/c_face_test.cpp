// [memory] impl/mmverify.h: arrays, useful levels and interleaved pixels from C are those of C++.
#include <gtest/gtest.h>

#include <random>

#include "impl/mmverify.h"
#include "impl/mmverify.hpp"

namespace impl_c_face_test {

using namespace mmverify::impl;

TEST(CFace, CornersOfMoreThanAPieceAreThoseOfEach) {
  std::vector<std::uint32_t> index(1000), corners(6000);
  std::mt19937 random(1);
  for (std::uint32_t& k : index) k = random() % 4096;
  ASSERT_EQ(mmverify_corners(6, index.data(), corners.data(), index.size()), 1);
  for (std::size_t k = 0; k < index.size(); ++k) {
    const auto right = index::corners(index[k], 6);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(corners[6 * k + 2 * c], right[c].i);
      ASSERT_EQ(corners[6 * k + 2 * c + 1], right[c].j);
    }
  }
}

TEST(CFace, ArraysAreThoseOfCpp) {
  // T O UT UO; all O; 0110 in 2-state; the first again.
  const std::uint8_t mixed = 0xe4, opaque = 0x55, band = 0x06;
  const mmverify_map maps[] = {{1, 2, &mixed}, {1, 2, &opaque}, {1, 1, &band}, {1, 2, &mixed}};
  mmverify_array* const array = mmverify_array_new(maps, 4, 16);
  ASSERT_NE(array, nullptr) << mmverify_error();
  mmverify_buffers b;
  mmverify_array_buffers(array, &b);
  ASSERT_EQ(b.record_count, 2u);
  EXPECT_EQ(b.records[1].offset, 1u);
  EXPECT_EQ(b.records[1].level, 1u);
  EXPECT_EQ(b.records[1].format, 1u);
  ASSERT_EQ(b.data_bytes, 2u);
  EXPECT_EQ(b.data[0], mixed);
  EXPECT_EQ(b.data[1], band);
  ASSERT_EQ(b.index_count, 4u);
  const auto* const indices = static_cast<const std::uint16_t*>(b.indices);
  EXPECT_EQ(std::vector(indices, indices + 4), (std::vector<std::uint16_t>{0, 0xfffe, 1, 0}));
  ASSERT_EQ(b.array_usage_count, 2u);
  ASSERT_EQ(b.geometry_usage_count, 2u);
  EXPECT_EQ(b.array_usage[1].count, 1u);
  EXPECT_EQ(b.geometry_usage[1].count, 2u);
  EXPECT_EQ(b.geometry_usage[1].format, 2u);
  // Geometries that share the array: triangles 1 and 2, and triangle 1, whose index is special.
  mmverify_usage usage[26] = {};
  std::size_t found = 9;
  ASSERT_EQ(mmverify_array_geometry_counts(array, 1, 2, usage, 26, &found), 1) << mmverify_error();
  ASSERT_EQ(found, 1u);
  EXPECT_EQ(usage[0].count, 1u);
  EXPECT_EQ(usage[0].level, 1u);
  EXPECT_EQ(usage[0].format, 1u);
  ASSERT_EQ(mmverify_array_geometry_counts(array, 1, 1, usage, 0, &found), 1);
  EXPECT_EQ(found, 0u);
  ASSERT_EQ(mmverify_array_geometry_counts(array, 0, 4, nullptr, 0, &found), 1);
  EXPECT_EQ(found, b.geometry_usage_count);
  found = 9;
  ASSERT_EQ(mmverify_array_geometry_counts(array, 0, 4, usage, 1, &found), 0);
  EXPECT_EQ(found, 9u);
  EXPECT_STREQ(mmverify_error(), "there are more usage counts than usage has room for");
  EXPECT_EQ(mmverify_array_geometry_counts(array, 3, 2, usage, 26, &found), 0);
  EXPECT_STREQ(mmverify_error(), "triangles that the array does not have");
  // The upright child at the first vertex is micro-triangle 0, the one at the third vertex the last.
  std::uint8_t state = 9;
  EXPECT_EQ(mmverify_array_state(array, 0, 0.1f, 0.1f, &state), 1);
  EXPECT_EQ(state, 0u);
  EXPECT_EQ(mmverify_array_state(array, 1, 0.1f, 0.1f, &state), 1);
  EXPECT_EQ(state, 1u);
  EXPECT_EQ(mmverify_array_state(array, 3, 0.1f, 0.8f, &state), 1);
  EXPECT_EQ(state, 3u);
  EXPECT_EQ(mmverify_array_state(array, 4, 0, 0, &state), 0);
  EXPECT_STREQ(mmverify_error(), "a triangle that the array does not have");
  mmverify_array_free(array);
  EXPECT_EQ(mmverify_array_new(maps, 4, 12), nullptr);
  EXPECT_STREQ(mmverify_error(), "indices have 8, 16 or 32 bits");
}

TEST(CFace, PixelsAndUsefulLevelsAreThoseOfCpp) {
  std::vector<std::uint8_t> rgba(33 * 8);
  std::mt19937 random(2);
  for (std::uint8_t& b : rgba) b = static_cast<std::uint8_t>(random());
  const mmverify_pixels mip{rgba.data(), 8, 8, 33, 4, 2};
  mmverify_sampling how{};
  how.texel = MMVERIFY_TEXEL_UNORM8;
  how.factor = how.vertex_factor = 1;
  how.cutoff_numerator = 1, how.cutoff_denominator = 2;
  mmverify_baker* const baker = mmverify_baker_of_pixels(&mip, 1, &how);
  ASSERT_NE(baker, nullptr) << mmverify_error();
  const bake::PixelView view{rgba.data(), 8, 8, 33, 4, 2};
  const bake::TriangleBaker right({&view, 1}, bake::Cutoff{1, 2});
  const float uv[6] = {0, 0, 1, 0.25f, 0.5f, 1};
  std::uint32_t level = 99;
  ASSERT_EQ(mmverify_useful_level(uv, 8, 8, 12, &level), 1);
  EXPECT_EQ(level, 4u);  // The longest edge has (8, 2) texels: 68 <= 4^4.
  ASSERT_EQ(mmverify_useful_level(uv, 8, 8, 2, &level), 1);
  EXPECT_EQ(level, 2u);
  EXPECT_EQ(mmverify_useful_level(uv, 0, 8, 2, &level), 0);
  std::vector<std::uint8_t> map(16), other(16);
  ASSERT_EQ(mmverify_bake(baker, uv, 3, map.data()), 1) << mmverify_error();
  right.bake({{{0, 0}, {1, 0.25f}, {0.5f, 1}}}, 3, other);
  EXPECT_EQ(map, other);
  mmverify_baker_free(baker);
  how.texel = MMVERIFY_TEXEL_UNORM16;
  EXPECT_EQ(mmverify_baker_of_pixels(&mip, 1, &how), nullptr);
  EXPECT_STREQ(mmverify_error(), "texels of interleaved pixels are of 1, 8 bits");
}

}  // namespace impl_c_face_test
