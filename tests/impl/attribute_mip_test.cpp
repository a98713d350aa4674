// [memory] The library's mips and levels of detail on what no law asks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "impl/attribute/mip.hpp"

namespace mmverify::impl::attribute {
namespace impl_attribute_mip_test {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();

std::vector<std::uint32_t> values(std::size_t count, std::uint32_t seed) {
  std::vector<std::uint32_t> all(count);
  for (std::uint32_t& x : all) x = seed = seed * 1664525u + 1013904223u;
  return all;
}

TEST(ImplMip, may_be_written_where_the_children_begin) {
  auto map = values(4096, 5);
  std::vector<std::uint32_t> apart(1024);
  face_mip(map, Rounding::half_up, apart);
  face_mip(map, Rounding::half_up, std::span(map).first(1024));
  EXPECT_TRUE(std::equal(apart.begin(), apart.end(), map.begin()));
}

TEST(ImplMip, refuses_other_sizes_and_writes_nothing) {
  const std::vector<std::uint32_t> children(9, 1);
  std::vector<std::uint32_t> out(2, 7);
  EXPECT_THROW(face_mip(children, Rounding::half_up, out), std::invalid_argument);
  EXPECT_THROW(face_mip(std::span(children).first(4), Rounding::half_up, out), std::invalid_argument);
  EXPECT_THROW(face_mip(std::span(children).first(8), static_cast<Rounding>(4), out), std::invalid_argument);
  EXPECT_THROW(face_chain(1, std::span(children).first(4), Rounding::half_up, ChainOf::level_above, out),
               std::invalid_argument);
  EXPECT_THROW(face_chain(13, children, Rounding::half_up, ChainOf::level_above, out), std::invalid_argument);
  EXPECT_THROW(face_chain(0, std::span(children).first(1), Rounding::halves_up, ChainOf::exact_sums, {}),
               std::invalid_argument);
  EXPECT_EQ(out, (std::vector<std::uint32_t>{7, 7}));
}

TEST(ImplMip, level_12_of_the_brightest_keeps_its_sum) {
  const std::vector<std::uint32_t> base(std::size_t{1} << 24, ~0u);
  std::vector<std::uint32_t> chain(face_chain_size(12));
  face_chain(12, base, Rounding::half_up, ChainOf::exact_sums, chain);
  EXPECT_EQ(chain.front(), ~0u);
}

TEST(ImplLod, what_is_no_area_counts_as_0) {
  EXPECT_EQ(lod_level(nan, 1, 5), 5u);
  EXPECT_EQ(lod_level(-1, 1, 5), 5u);
  EXPECT_EQ(lod_level(-0.0f, 1, 5), 5u);
  EXPECT_EQ(lod_level(1, nan, 5), 0u);
  EXPECT_EQ(lod_level(1, -4, 5), 0u);
  EXPECT_EQ(lod_level(0, 0, 5), 5u);
  EXPECT_EQ(lod_level(infinite, 1, 5), 0u);
  EXPECT_EQ(lod_level(1, infinite, 5), 5u);
  EXPECT_EQ(lod_level(1, 0x1p60f, 99), 16u) << "more is 16";
  for (const float cone : {nan, infinite, -infinite, 0.0f, 1.0f})
    for (const float triangle : {nan, infinite, -infinite, 0.0f, 1.0f}) {
      const Lod l = lod(cone, triangle, 5);
      EXPECT_LE(l.level, 5u);
      EXPECT_TRUE(l.blend >= 0 && l.blend < 1);
    }
}

TEST(ImplLod, an_ulp_below_a_power_of_4_is_the_level_below) {
  for (int m = 1; m <= 16; ++m) {
    const float four = std::ldexp(1.0f, 2 * m), below = std::nextafter(four, 0.0f);
    EXPECT_EQ(lod_level(1, four, 16), static_cast<Level>(m));
    EXPECT_EQ(lod_level(1, below, 16), static_cast<Level>(m - 1));
    const Lod l = lod(1, below, 16);
    EXPECT_EQ(l.level, static_cast<Level>(m - 1));
    EXPECT_EQ(l.blend, 0x1.fffffep-1f);
  }
  EXPECT_EQ(lod(1, 8, 16).blend, 0.5f);
}

TEST(ImplLod, spans_are_the_same) {
  const std::vector<float> cone{1, 2, 0, 3}, triangle{16, 1, 1, 48};
  std::vector<Level> levels(4);
  lod_level(cone, triangle, 5, levels);
  EXPECT_EQ(levels, (std::vector<Level>{2, 0, 5, 2}));
  EXPECT_THROW(lod_level(cone, std::span(triangle).first(3), 5, levels), std::invalid_argument);
}

}  // namespace impl_attribute_mip_test
}  // namespace mmverify::impl::attribute
