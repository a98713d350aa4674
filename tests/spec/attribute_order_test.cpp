// [release] spec/attribute/order.hpp against what was worked out by hand, counted, or published.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "spec/attribute/order.hpp"

namespace spec_attribute_order_test {

using namespace mmverify::spec;
using namespace mmverify::spec::attribute;

static_assert(std::array{vertex_count(0), vertex_count(1), vertex_count(2), vertex_count(16)} ==
              std::array<std::uint64_t, 4>{3, 6, 15, 2'147'581'953});

// Read off a triangle drawn with its vertices numbered: w below on the left, u to the right, v above.
TEST(AttributeOrders, of_level_1_by_hand) {
  const auto order = [](VertexOrder of) {
    std::vector<std::uint64_t> index;
    for (const Vertex at : {Vertex{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {0, 2}})
      index.push_back(vertex_index(of, at, 1));
    return index;
  };
  EXPECT_EQ(order(VertexOrder::w_minor), (std::vector<std::uint64_t>{0, 1, 3, 2, 4, 5}));
  EXPECT_EQ(order(VertexOrder::u_major), (std::vector<std::uint64_t>{0, 3, 5, 1, 4, 2}));
  EXPECT_EQ(order(VertexOrder::bird), (std::vector<std::uint64_t>{0, 5, 1, 3, 4, 2}));
}

TEST(AttributeOrders, of_faces_of_level_1_by_hand) {
  const auto order = [](FaceOrder of) {
    std::vector<std::uint64_t> index;
    for (const MicroTriangle t : {MicroTriangle{0, 0, false}, {0, 0, true}, {1, 0, false}, {0, 1, false}})
      index.push_back(face_index(of, t, 1));
    return index;
  };
  EXPECT_EQ(order(FaceOrder::curve), (std::vector<std::uint64_t>{0, 1, 2, 3}));
  EXPECT_EQ(order(FaceOrder::rows), (std::vector<std::uint64_t>{0, 2, 1, 3}));
  EXPECT_EQ(order(FaceOrder::u_major), (std::vector<std::uint64_t>{0, 1, 3, 2}));
}

// The corrections a level of VK_NV_displacement_micromap's blocks.
TEST(AttributeOrders, a_level_adds_as_many_vertices_as_the_displacement_extension_corrects) {
  const std::vector<std::uint64_t> corrections{3, 9, 30, 108, 408};
  for (Level m = 1; m <= 5; ++m) {
    EXPECT_EQ(vertex_count(m) - vertex_count(m - 1), corrections[m - 1]) << m;
    EXPECT_EQ(vertex_count(m) - vertex_count(m - 1), 3 * upright_before(face_count(m - 1), m - 1)) << m;
  }
}

TEST(AttributeOrders, upright_ones_are_counted_one_by_one) {
  for (Level d = 0; d <= 6; ++d) {
    std::uint64_t before = 0;
    for (std::uint64_t x = 0; x < face_count(d); ++x) {
      ASSERT_EQ(upright_before(x, d), before) << d << " " << x;
      if (curve_triangle(x, d).upper) continue;
      ASSERT_EQ(upright_number(before, d), x) << d << " " << x;
      ++before;
    }
    EXPECT_EQ(upright_before(face_count(d), d), before);
  }
}

// impl/ uses this closed form of the count.
TEST(AttributeOrders, upright_ones_before_a_lower_one_are_half_of_its_number_and_iv) {
  for (Level d = 0; d <= 7; ++d)
    for (std::uint64_t x = 0; x < face_count(d); ++x) {
      const MicroTriangle t = curve_triangle(x, d);
      EXPECT_EQ(2 * upright_before(x, d), x + t.iv + (t.upper ? 1 : 0)) << d << " " << x;
    }
}

/// The numbers of the four micro-triangles of the next level whose corners lie in t, found by their middles.
std::vector<std::uint64_t> children(const MicroTriangle& t, Level n, FaceOrder order) {
  // Units are 1/6 of a micro-edge of level n+1: the middle of a lower one is 2 from its base in u and in v, of an upper
  // one 4.
  const auto middle = [](std::uint32_t square, bool upper) {
    return 6 * std::int64_t{square} + (upper ? 4 : 2);
  };
  std::vector<std::uint64_t> found;
  for (std::uint64_t k = 0; k < face_count(n + 1); ++k) {
    const MicroTriangle c = triangle_at(order, k, n + 1);
    const std::int64_t u = middle(c.iu, c.upper) - 12 * std::int64_t{t.iu},
                       v = middle(c.iv, c.upper) - 12 * std::int64_t{t.iv};
    if (u >= 0 && v >= 0 && u <= 12 && v <= 12 && (u + v > 12) == t.upper) found.push_back(k);
  }
  return found;
}

TEST(AttributeOrders, children_are_four_in_a_row_on_the_curve_alone) {
  using Four = std::vector<std::uint64_t>;
  for (std::uint64_t k = 0; k < 4; ++k)
    EXPECT_EQ(children(triangle_at(FaceOrder::curve, k, 1), 1, FaceOrder::curve),
              (Four{4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3}));
  EXPECT_EQ(children(triangle_at(FaceOrder::rows, 1, 1), 1, FaceOrder::rows), (Four{4, 9, 10, 11}));
  EXPECT_EQ(children(triangle_at(FaceOrder::u_major, 0, 1), 1, FaceOrder::u_major), (Four{0, 1, 2, 7}));
}

TEST(AttributeOrders, triangular_roots_at_their_borders) {
  for (std::uint64_t r = 1; r <= 70'000; r += r < 300 ? 1 : 997) {
    EXPECT_EQ(triangular_root(r * (r + 1) / 2), r);
    EXPECT_EQ(triangular_root(r * (r + 1) / 2 - 1), r - 1);
  }
}

// BaryFile computes U-major in 32 bits; docs/ERRATA.md.
TEST(AttributeOrders, of_level_16_leave_32_bits) {
  constexpr std::uint32_t N = 65'536;
  EXPECT_EQ(u_major_index<std::uint64_t>(N, 0, 16), 2'147'581'952u);
  EXPECT_EQ(u_major_index<std::uint32_t>(N, 0, 16), 98'304u);
  EXPECT_EQ(w_minor_index<std::uint64_t>(0, N), 2'147'581'952u);
  EXPECT_EQ(w_minor_index<std::uint32_t>(0, N), 98'304u);
  EXPECT_EQ(w_minor_index<std::uint32_t>(0, N - 1), w_minor_index<std::uint64_t>(0, N - 1));
}

TEST(AttributeOrders, corners_wind_like_the_base_triangle) {
  for (const MicroTriangle t : {MicroTriangle{3, 4, false}, {3, 4, true}}) {
    const Corners c = corners_of(t);
    const auto along = [&](std::size_t k) {
      return std::pair{static_cast<int>(c[k].i) - static_cast<int>(c[0].i),
                       static_cast<int>(c[k].j) - static_cast<int>(c[0].j)};
    };
    const auto [i1, j1] = along(1);
    const auto [i2, j2] = along(2);
    EXPECT_EQ(i1 * j2 - i2 * j1, 1);
    EXPECT_EQ(triangle_of(c), t);
  }
}

// Figure 4's rows: an odd column's triplet is ours begun a corner later.
TEST(AttributeOrders, corners_are_figure_4s_but_for_where_odd_ones_begin) {
  for (std::uint32_t x = 0; x < 256; ++x) {
    const Corners theirs = index::w_minor_corners(x), ours = corners_of(row_triangle(x));
    const bool odd = row_triangle(x).upper;
    EXPECT_EQ(theirs, odd ? (Corners{ours[2], ours[0], ours[1]}) : ours) << x;
  }
}

TEST(AttributeOrders, ends_of_level_16) {
  for (const VertexOrder order : vertex_orders)
    for (const std::uint64_t x :
         {std::uint64_t{0}, std::uint64_t{3}, vertex_count(15) - 1, vertex_count(15), vertex_count(16) - 1}) {
      const Vertex at = vertex_at(order, x, 16);
      EXPECT_LE(at.i + at.j, 65'536u);
      EXPECT_EQ(vertex_index(order, at, 16), x);
    }
  for (const FaceOrder order : face_orders)
    for (const std::uint64_t x : {std::uint64_t{0}, face_count(16) / 3, face_count(16) - 1})
      EXPECT_EQ(face_index(order, triangle_at(order, x, 16), 16), x);
}

}  // namespace spec_attribute_order_test
