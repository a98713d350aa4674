// [memory] The library's mips against the obvious loop, for all lengths; levels of detail on what no law asks.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "impl/attribute/mip.hpp"
#include "spec/attribute/mip.hpp"

namespace mmverify::impl::attribute {
namespace impl_attribute_mip_test {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();
constexpr std::array roundings{Rounding::half_up, Rounding::half_to_even, Rounding::truncate,
                               Rounding::halves_up};

std::vector<std::uint32_t> values(std::size_t count, std::uint32_t seed) {
  std::vector<std::uint32_t> all(count);
  for (std::uint32_t& x : all) x = seed = seed * 1664525u + 1013904223u;
  return all;
}

std::uint32_t obvious(const std::uint32_t* four, Rounding rounding) {
  std::uint32_t word = 0;
  for (unsigned code = 0; code < 4; ++code) {
    std::array<std::uint8_t, 4> codes{};
    for (std::size_t child = 0; child < 4; ++child)
      codes[child] = static_cast<std::uint8_t>(four[child] >> 8 * code);
    word |= std::uint32_t{spec::attribute::mean_code(codes, static_cast<spec::attribute::Rounding>(rounding))}
            << 8 * code;
  }
  return word;
}

TEST(ImplMip, is_the_obvious_loop_at_every_length_and_alignment) {
  for (const Rounding rounding : roundings)
    for (std::size_t parents = 0; parents <= 70; ++parents)
      for (std::size_t skip = 0; skip < 4; ++skip) {
        const auto children = values(skip + 4 * parents, static_cast<std::uint32_t>(parents + skip));
        std::vector<std::uint32_t> out(parents + 2 + skip, 7);
        face_mip(std::span(children).subspan(skip), rounding, std::span(out).subspan(skip + 1, parents));
        EXPECT_EQ(out[skip], 7u) << "what is before";
        EXPECT_EQ(out.back(), 7u) << "and after";
        for (std::size_t k = 0; k < parents; ++k)
          ASSERT_EQ(out[skip + 1 + k], obvious(&children[skip + 4 * k], rounding)) << parents << ' ' << k;
      }
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

TEST(ImplMip, chains_begin_with_the_coarsest_level) {
  const std::vector<std::uint32_t> base{0, 1, 1, 1, 2, 2, 2, 2, 5, 5, 5, 6, 9, 9, 9, 9};
  std::vector<std::uint32_t> chain(5);
  face_chain(2, base, Rounding::half_up, ChainOf::level_above, chain);
  EXPECT_EQ(chain, (std::vector<std::uint32_t>{4, 1, 2, 5, 9}));
  face_chain(2, base, Rounding::truncate, ChainOf::exact_sums, chain);
  EXPECT_EQ(chain, (std::vector<std::uint32_t>{4, 0, 2, 5, 9}));
  EXPECT_NO_THROW(face_chain(0, std::span(base).first(1), Rounding::half_up, ChainOf::exact_sums, {}));
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
