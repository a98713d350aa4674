// [release] Mip chains and levels of detail as specified.
#include <gtest/gtest.h>

#include <cmath>

#include "spec/attribute/mip.hpp"

namespace mmverify::spec::attribute {
namespace spec_attribute_mip_test {

TEST(SpecMip, roundings_of_four_codes) {
  const auto all = [](std::array<std::uint8_t, 4> codes) {
    std::array<int, 4> found{};
    for (const Rounding r : roundings) found[static_cast<std::size_t>(r)] = mean_code(codes, r);
    return found;
  };
  // half up, half to even, truncate, halves up.
  EXPECT_EQ(all({0, 0, 1, 1}), (std::array{1, 0, 0, 1}));
  EXPECT_EQ(all({1, 1, 2, 2}), (std::array{2, 2, 1, 2}));
  EXPECT_EQ(all({0, 0, 0, 1}), (std::array{0, 0, 0, 1}));
  EXPECT_EQ(all({0, 1, 0, 0}), (std::array{0, 0, 0, 1}));
  EXPECT_EQ(all({0, 1, 1, 1}), (std::array{1, 1, 0, 1}));
  EXPECT_EQ(all({255, 255, 255, 255}), (std::array{255, 255, 255, 255}));
  EXPECT_EQ(all({255, 255, 255, 254}), (std::array{255, 255, 254, 255}));
}

TEST(SpecMip, a_map_below_has_the_means_of_four) {
  const std::vector<Rational> values{Rational(1), Rational(2), Rational(4), Rational(0),
                                     Rational(1), Rational(1), Rational(1), Rational(2)};
  EXPECT_EQ(face_mip<Rational>(values), (std::vector<Rational>{Rational(7, 4), Rational(5, 4)}));
  const std::vector<std::uint8_t> codes{1, 2, 4, 0, 1, 1, 1, 2};
  EXPECT_EQ(face_mip(codes, Rounding::half_up), (std::vector<std::uint8_t>{2, 1}));
}

TEST(SpecMip, chains_counted) {
  EXPECT_EQ(face_chain(0), 0u);
  EXPECT_EQ(face_chain(1), 1u);
  EXPECT_EQ(face_chain(2), 5u);
  EXPECT_EQ(face_chain(9), 87'381u) << "all of levels 0..8";
  // The vertices of all lower levels, in percent of the level's own.
  const std::array<int, 6> percent{50, 60, 53, 45, 40, 37};
  for (Level n = 1; n <= 6; ++n) {
    std::uint64_t sum = 0;
    for (Level m = 0; m < n; ++m) sum += vertex_count(m);
    EXPECT_EQ(vertex_chain(n), sum);
    EXPECT_EQ(std::lround(100.0 * static_cast<double>(sum) / static_cast<double>(vertex_count(n))),
              percent[n - 1]);
  }
}

TEST(SpecMip, vertices_of_a_lower_level_are_where_they_were) {
  for (std::uint32_t k = 0; k < vertex_count(2); ++k)
    EXPECT_EQ(vertex_mip_source(VertexOrder::bird, k, 2, 5), k);
  // W-minor: rows 0, 2 and 4 of level 2, every second one of each.
  const std::array<std::uint64_t, 6> places{0, 3, 5, 10, 12, 14};
  for (std::uint32_t k = 0; k < 6; ++k)
    EXPECT_EQ(vertex_mip_source(VertexOrder::w_minor, k, 1, 2), places[k]);
}

TEST(SpecLod, the_greatest_level_whose_micro_triangles_cover_the_cone) {
  const auto level = [](Rational cone, Rational triangle, Level n) { return lod_level(cone, triangle, n); };
  EXPECT_EQ(level(1, 1, 5), 0u);
  EXPECT_EQ(level(1, Rational(399, 100), 5), 0u);
  EXPECT_EQ(level(1, 4, 5), 1u);
  EXPECT_EQ(level(1, Rational(1599, 100), 5), 1u);
  EXPECT_EQ(level(1, 1024, 5), 5u);
  EXPECT_EQ(level(1, 4096, 5), 5u) << "the base";
  EXPECT_EQ(level(2, 1, 5), 0u) << "the cone exceeds the triangle";
  EXPECT_EQ(level(0, 1, 5), 5u);
  EXPECT_EQ(level(1, 0, 5), 0u);
  EXPECT_EQ(level(0, 0, 5), 5u);
  EXPECT_EQ(level(1, 1024, 0), 0u);
}

TEST(SpecLod, the_paper_can_be_read_in_three_ways) {
  struct Read {
    Rational triangle;
    Level floor, covered, exceeded;
  };
  for (const auto& [triangle, floor, covered, exceeded] :
       {Read{1, 0, 0, 1}, Read{2, 0, 1, 1}, Read{4, 1, 1, 2}, Read{5, 1, 2, 2}, Read{16, 2, 2, 3}}) {
    EXPECT_EQ(lod_level(Rational(1), triangle, 9), floor) << triangle;
    EXPECT_EQ(first_level_covered(Rational(1), triangle), covered) << triangle;
    EXPECT_EQ(first_level_exceeded(Rational(1), triangle), exceeded) << triangle;
  }
}

TEST(SpecLod, blends_between_bounds) {
  const auto blend = [](Rational cone, Rational triangle) {
    const Level m = lod_level(cone, triangle, 16);
    const Bounds b = lod_blend(cone, triangle, m, 50);
    EXPECT_LE(b.low, b.high);
    EXPECT_LE(b.high - b.low, 2);
    return std::ldexp(b.low.convert_to<double>(), -50);
  };
  EXPECT_EQ(blend(1, 1), 0);
  EXPECT_EQ(blend(1, 2), 0.5);
  EXPECT_EQ(blend(3, 6 * 256), 0.5);
  EXPECT_EQ(lod_blend(Rational(1), Rational(2), 0, 50).high, Integer(1) << 49) << "exact";
  EXPECT_NEAR(blend(1, 3), 0.5 * std::log2(3.0), 1e-14);
  EXPECT_NEAR(blend(7, 1000), 0.5 * std::log2(1000 / 7.0) - 3, 1e-14);
  EXPECT_NEAR(blend(1, Rational(399, 100)), 0.5 * std::log2(3.99), 1e-14);
}

}  // namespace spec_attribute_mip_test
// A triangle of area 1 and a cone 1/2 wide: its square 1/4; its disc pi/16; the square on a triangle turned by 60 degrees,
// twice as much; and a cone twice as wide, 1.
TEST(SpecLod, what_the_cones_area_is_decides_the_level) {
  const Rational square(1, 4), disc(355, 113 * 16), turned(1, 2), doubled(1), triangle(1);
  EXPECT_EQ(lod_level(square, triangle, 9), 1u);
  EXPECT_EQ(lod_level(disc, triangle, 9), 1u);
  EXPECT_EQ(lod_level(turned, triangle, 9), 0u);
  EXPECT_EQ(lod_level(doubled, triangle, 9), 0u);
  const auto blend = [&](const Rational& cone, Level m) {
    return std::ldexp(lod_blend(cone, triangle, m, 50).low.convert_to<double>(), -50);
  };
  EXPECT_EQ(blend(square, 1), 0);
  EXPECT_NEAR(blend(disc, 1), 0.17, 0.005);
  EXPECT_EQ(blend(turned, 0), 0.5);
  EXPECT_EQ(blend(doubled, 0), 0);
}

}  // namespace mmverify::spec::attribute
