// [release] spec/attribute/lookup.hpp against what was worked out by hand.
#include <gtest/gtest.h>

#include "spec/attribute/lookup.hpp"
#include "spec/fixed.hpp"
#include "spec/rational.hpp"

namespace spec_attribute_lookup_test {

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

TEST(AttributeLookup, the_systems_condition_by_hand) {
  // Level 1, the middle: weights of w, u, v there are (1,1,-1) in some order, so 3. Level 0: the identity.
  EXPECT_EQ(system_condition<Rational>({0, 0, true}, 1), Rational(3));
  EXPECT_EQ(system_condition<Rational>({0, 0, false}, 0), Rational(1));
}

TEST(AttributeLookup, the_systems_condition_is_2N_minus_1) {
  for (Level n = 0; n <= 5; ++n) {
    const std::uint32_t N = side(n);
    Rational greatest(0);
    for (std::uint32_t iu = 0; iu < N; ++iu)
      for (std::uint32_t iv = 0; iu + iv < N; ++iv)
        for (const bool upper : {false, true}) {
          if (upper && iu + iv + 1 >= N) continue;
          const MicroTriangle t{iu, iv, upper};
          const Rational condition = system_condition<Rational>(t, n);
          if (greatest < condition) greatest = condition;
          // The matrix's norm times its inverse's, by cofactors.
          const Corners c = corners_of(t);
          std::array<std::array<Rational, 3>, 3> m, inverse;
          for (std::size_t k = 0; k < 3; ++k)
            m[k] = {ratio(N - c[k].i - c[k].j, N), ratio(c[k].i, N), ratio(c[k].j, N)};
          for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t r = 0; r < 3; ++r) {
              std::array<std::array<Rational, 3>, 3> with = m;
              with[r] = {Rational(0), Rational(0), Rational(0)};
              with[r][k] = Rational(1);
              inverse[k][r] = determinant(with[0], with[1], with[2]) / determinant(m[0], m[1], m[2]);
            }
          const auto norm = [](const std::array<std::array<Rational, 3>, 3>& columns) {
            Rational most(0);
            for (const auto& column : columns) {
              Rational sum(0);
              for (const Rational& x : column) sum = sum + (x < Rational(0) ? Rational(0) - x : x);
              if (most < sum) most = sum;
            }
            return most;
          };
          ASSERT_EQ(condition, norm(m) * norm(inverse)) << "level " << n << ", " << iu << ", " << iv;
        }
    EXPECT_EQ(greatest, Rational(2 * std::int64_t{N} - 1)) << "level " << n;
    EXPECT_EQ(greatest, system_condition<Rational>({0, 0, false}, n));
  }
}

TEST(AttributeLookup, figure_4_and_vulkan_differ_on_lines_of_u) {
  EXPECT_EQ(vulkan_triangle(at(1, 0, 2), 1), (MicroTriangle{1, 0, false}));
  EXPECT_EQ(figure_4_triangle(at(1, 0, 2), 1), (MicroTriangle{0, 0, true}));
  EXPECT_EQ(vulkan_triangle(at(2, 1, 4), 1), (MicroTriangle{1, 0, false}));
  EXPECT_EQ(figure_4_triangle(at(2, 1, 4), 1), (MicroTriangle{0, 0, true}));
  // The two agree on lines of v and on diagonals.
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

}  // namespace spec_attribute_lookup_test
