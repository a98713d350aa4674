// spec/attribute/lookup.hpp against what was worked out by hand.
#include <gtest/gtest.h>

#include "spec/attribute/lookup.hpp"
#include "spec/fixed.hpp"
#include "spec/rational.hpp"

namespace {

using namespace mmverify::spec;
using namespace mmverify::spec::attribute;

Rational ratio(std::int64_t a, std::int64_t b) { return Rational(Integer(a), Integer(b)); }
Point<Rational> at(std::int64_t u, std::int64_t v, std::int64_t over) {
  return {ratio(u, over), ratio(v, over)};
}
Weights<Rational> weights(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t over) {
  return {ratio(a, over), ratio(b, over), ratio(c, over)};
}

TEST(AttributeLookup, weights_of_a_lower_and_an_upper_one_by_hand) {
  // Level 2: (2/5, 1/5) is (1.6, 0.8) in units of 1/4: square (1, 0), 0.6 + 0.8 >= 1.
  const Point<Rational> p = at(2, 1, 5);
  const MicroTriangle t = vulkan_triangle(p, 2);
  EXPECT_EQ(t, (MicroTriangle{1, 0, true}));
  EXPECT_EQ(weights_by_pattern(p, t, 2), weights(2, 2, 1, 5));
  // (1/3, 1/7) is (4/3, 4/7): square (1, 0), 1/3 + 4/7 < 1.
  const Point<Rational> q{ratio(1, 3), ratio(1, 7)};
  EXPECT_EQ(vulkan_triangle(q, 2), (MicroTriangle{1, 0, false}));
  EXPECT_EQ(weights_by_pattern(q, {1, 0, false}, 2), weights(2, 7, 12, 21));
}

TEST(AttributeLookup, all_ways_agree_outside_the_micro_triangle_too) {
  const Point<Rational> p = at(2, 1, 7);
  for (const MicroTriangle t :
       {MicroTriangle{0, 0, false}, {0, 0, true}, {2, 1, false}, {1, 1, true}, {0, 3, false}}) {
    const Weights<Rational> w = weights_by_pattern(p, t, 2);
    EXPECT_EQ(weights_by_two(p, corners_of(t), 2), w);
    EXPECT_EQ(weights_by_cramer(p, corners_of(t), 2), w);
  }
}

TEST(AttributeLookup, the_determinant_is_4_to_the_minus_n) {
  for (Level n = 0; n <= 4; ++n) {
    const std::int64_t N = side(n);
    const auto column = [&](const Vertex& v) {
      const std::int64_t i = v.i, j = v.j;
      return std::array<Rational, 3>{ratio(N - i - j, N), ratio(i, N), ratio(j, N)};
    };
    for (const MicroTriangle t :
         {MicroTriangle{0, 0, false}, {static_cast<std::uint32_t>(N - 1), 0, false}}) {
      const Corners c = corners_of(t);
      EXPECT_EQ(determinant(column(c[0]), column(c[1]), column(c[2])), ratio(1, N * N));
    }
    if (n == 0) continue;
    const Corners c = corners_of({0, 0, true});
    EXPECT_EQ(determinant(column(c[0]), column(c[1]), column(c[2])), ratio(1, N * N));
  }
}

TEST(AttributeLookup, figure_4_and_vulkan_differ_on_lines_of_u) {
  EXPECT_EQ(vulkan_triangle(at(1, 0, 2), 1), (MicroTriangle{1, 0, false}));
  EXPECT_EQ(figure_4_triangle(at(1, 0, 2), 1), (MicroTriangle{0, 0, true}));
  EXPECT_EQ(vulkan_triangle(at(2, 1, 4), 1), (MicroTriangle{1, 0, false}));
  EXPECT_EQ(figure_4_triangle(at(2, 1, 4), 1), (MicroTriangle{0, 0, true}));
  // On lines of v and on diagonals they do not.
  EXPECT_EQ(vulkan_triangle(at(1, 2, 4), 1), figure_4_triangle(at(1, 2, 4), 1));
  EXPECT_EQ(vulkan_triangle(at(1, 1, 4), 1), figure_4_triangle(at(1, 1, 4), 1));
}

TEST(AttributeLookup, vertices_within_an_upper_one_run_backwards) {
  EXPECT_EQ(vertex_within({2, 1, false}, {1, 2}, 2), (Vertex{9, 6}));
  EXPECT_EQ(vertex_within({2, 1, true}, {1, 2}, 2), (Vertex{11, 6}));
}

TEST(AttributeLookup, values_between_vertices) {
  EXPECT_EQ(interpolated(weights(2, 2, 1, 5), {10, 20, 255}), ratio(315, 5));
  const Weights<Fixed64> quarters{Fixed64::dyadic(1, 2), Fixed64::dyadic(1, 2), Fixed64::dyadic(1, 1)};
  EXPECT_EQ(interpolated(quarters, {0, 4, 255}), Fixed64::dyadic(257, 1));  // 1 + 127.5
}

}  // namespace
