// [release] Edge decimation as specified, against the mesh that it makes, edge by edge.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "spec/attribute/decimation.hpp"
#include "spec/fixed.hpp"

namespace mmverify::spec::attribute {
namespace spec_attribute_decimation_test {

using Rule = std::function<Vertex(Vertex, Level, EdgeFlags)>;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

Pair pair(const Vertex& x) { return {x.i, x.j}; }

/// Whether the live micro-triangles have each inner edge twice, in opposite directions, and each base edge once.
bool is_watertight(Level n, EdgeFlags flags, const Rule& rule) {
  const std::uint32_t N = side(n);
  std::map<std::pair<Pair, Pair>, int> edges;
  for (std::uint32_t iu = 0; iu < N; ++iu)
    for (std::uint32_t iv = 0; iu + iv < N; ++iv)
      for (const bool upper : {false, true}) {
        if (iu + iv + (upper ? 1 : 0) >= N) continue;
        Corners c = corners_of(MicroTriangle{iu, iv, upper});
        for (Vertex& x : c) x = rule(x, n, flags);
        if (doubled_area(c) < 0) return false;
        if (doubled_area(c) == 0) continue;
        for (std::size_t k = 0; k < 3; ++k) ++edges[{pair(c[k]), pair(c[(k + 1) % 3])}];
      }
  const auto on_base = [N](const Pair& a, const Pair& b) {
    return (a.second == 0 && b.second == 0) || (a.first == 0 && b.first == 0) ||
           (a.first + a.second == N && b.first + b.second == N);
  };
  for (const auto& [edge, count] : edges) {
    const auto& [a, b] = edge;
    if (count != 1 || edges.count({b, a}) != (on_base(a, b) ? 0u : 1u)) return false;
  }
  for (std::uint32_t edge = 0; edge < 3; ++edge) {
    const std::uint32_t step = (flags >> edge & 1) != 0 && n != 0 ? 2 : 1;
    for (std::uint32_t at = 0; at < N; at += step)
      if (edges.count({pair(on_edge(edge, at, n)), pair(on_edge(edge, at + step, n))}) != 1) return false;
  }
  return true;
}

Rule towards(std::function<std::uint32_t(Level, std::uint32_t edge, std::uint32_t at)> to) {
  return [to](Vertex x, Level n, EdgeFlags flags) {
    const EdgePlace place = decimated_at(x, n, flags);
    return place.decimated ? on_edge(place.edge, to(n, place.edge, place.at), n) : x;
  };
}

int failing(const Rule& rule) {
  int count = 0;
  for (Level n = 1; n <= 6; ++n)
    for (EdgeFlags flags = 0; flags < edge_flag_sets; ++flags) count += is_watertight(n, flags, rule) ? 0 : 1;
  return count;
}

TEST(SpecDecimation, is_watertight_by_the_rule_and_by_its_kin_and_not_by_two_others) {
  EXPECT_EQ(failing([](Vertex x, Level n, EdgeFlags f) { return snapped(x, n, f); }), 0);
  EXPECT_EQ(failing(towards([](Level, std::uint32_t, std::uint32_t at) { return at - 1; })), 0)
      << "to the first end";
  EXPECT_EQ(failing(towards(
                [](Level n, std::uint32_t, std::uint32_t at) { return at < side(n) / 2 ? at + 1 : at - 1; })),
            20)
      << "towards the middle: flags 3, 5, 6 and 7 from level 2 on";
  EXPECT_EQ(failing(towards(
                [](Level, std::uint32_t edge, std::uint32_t at) { return edge == 2 ? at + 1 : at - 1; })),
            11)
      << "indices rounded down";
  EXPECT_TRUE(is_watertight(0, 7, [](Vertex x, Level n, EdgeFlags f) { return snapped(x, n, f); }));
}

TEST(SpecDecimation, level_1_and_2_by_hand) {
  const auto to = [](Level n, EdgeFlags flags, Vertex x) { return pair(snapped(x, n, flags)); };
  EXPECT_EQ(to(1, 1, {1, 0}), Pair(0, 0)) << "the middle of w-u goes to w";
  EXPECT_EQ(to(1, 2, {1, 1}), Pair(2, 0)) << "of u-v to u";
  EXPECT_EQ(to(1, 4, {0, 1}), Pair(0, 2)) << "of v-w to v";
  EXPECT_EQ(to(1, 6, {1, 0}), Pair(1, 0)) << "its edge has no flag";
  EXPECT_EQ(to(2, 1, {1, 0}), Pair(0, 0));
  EXPECT_EQ(to(2, 1, {2, 0}), Pair(2, 0));
  EXPECT_EQ(to(2, 1, {3, 0}), Pair(4, 0)) << "away from the middle";
  EXPECT_EQ(to(2, 2, {3, 1}), Pair(4, 0));
  EXPECT_EQ(to(2, 2, {1, 3}), Pair(0, 4));
  EXPECT_EQ(to(2, 4, {0, 3}), Pair(0, 4));
  EXPECT_EQ(to(2, 4, {0, 1}), Pair(0, 0));
  EXPECT_EQ(to(2, 7, {1, 1}), Pair(1, 1)) << "inside";
  EXPECT_EQ(to(0, 7, {1, 0}), Pair(1, 0)) << "level 0 has no odd vertex";
}

TEST(SpecDecimation, means_are_of_both_even_neighbours) {
  const auto [a, b] = averaged({5, 3}, 3, 2);
  EXPECT_EQ(pair(a), Pair(6, 2));
  EXPECT_EQ(pair(b), Pair(4, 4));
  const auto [c, d] = averaged({5, 3}, 3, 5);
  EXPECT_EQ(pair(c), Pair(5, 3));
  EXPECT_EQ(pair(d), Pair(5, 3));
}

TEST(SpecDecimation, a_vertex_has_the_micro_triangles_around_it) {
  const auto count = [](Vertex x, Level n) {
    int found = 0;
    around(x, n, [&](const MicroTriangle& t) {
      const Corners c = corners_of(t);
      EXPECT_TRUE(c[0] == x || c[1] == x || c[2] == x);
      ++found;
    });
    return found;
  };
  EXPECT_EQ(count({1, 1}, 2), 6);
  EXPECT_EQ(count({1, 0}, 2), 3);
  EXPECT_EQ(count({0, 0}, 2), 1);
  EXPECT_EQ(count({4, 0}, 2), 1);
  EXPECT_EQ(count({2, 2}, 2), 3);
}

/// The point of level 1 that loses its micro-triangle: (1/4, 1/8) lay in the one at w, which is a line now.
TEST(SpecDecimation, finds_the_micro_triangle_that_took_over) {
  const Point<Fixed64> p{Fixed64::dyadic(2, 3), Fixed64::dyadic(1, 3)};
  const MicroTriangle before = vulkan_triangle(p, 1);
  EXPECT_EQ(doubled_area(snapped(before, 1, 1)), 0);
  const auto place = decimated_place(p, 1, 1);
  EXPECT_TRUE(place.holds());
  EXPECT_EQ(place.area, 2);
  // The point on (w, u, the middle of u-v): 2p = (1/2, 1/4) = a (2, 0) + b (1, 1).
  std::map<Pair, std::int64_t> weights;
  for (std::size_t c = 0; c < 3; ++c)
    if (!(place.shares[c] == Fixed64(0))) weights[pair(place.corners[c])] = place.shares[c].raw() >> 24;
  // The weights are in 2^-6: they add up to the doubled area, 2.
  EXPECT_EQ(weights, (std::map<Pair, std::int64_t>{{{0, 0}, 80}, {{1, 1}, 32}, {{2, 0}, 16}}));
}

}  // namespace spec_attribute_decimation_test
}  // namespace mmverify::spec::attribute
