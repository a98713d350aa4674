// [release] The bounds of impl/bake/sixteen/ that docs/BAKE_SIXTEEN.md derives, each by itself: places, cells, samples, centres.
// What binary32 makes of a node is compared with the same in whole numbers.
#include <gtest/gtest.h>

#include "tests/impl/sixteen_cells.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace {

/// The places that ask_corners() and ask_centroids() compute.
SixteenFloats places(const SixteenInput& in, std::size_t axis, const SixteenFloats& of_i,
                     const SixteenFloats& of_j) {
  SixteenFloats found;
  for (std::size_t k = 0; k < 16; k += hn::Lanes(F()))
    hn::StoreU(place(in, axis, hn::LoadU(F(), of_i.data() + k), hn::LoadU(F(), of_j.data() + k)), F(),
               found.data() + k);
  return found;
}
/// How far a place is from one in thirds of units, in texels.
double off(float x, Unit exact) {
  return std::fabs(static_cast<double>(x) * thirds - static_cast<double>(exact)) / thirds;
}

// delta = delta64 + 2^-20 S: micro-vertices, centroids, and the other ends of edges.
TEST(ImplBakeBounds, PlacesAreWithinDelta) {
  Nodes nodes(21);
  for (int round = 0; round < (sanitized ? 500 : 40000); ++round) {
    Node node = nodes.draw(round % 2 == 0 ? nodes.extent(0x1p-6, 80) : 50 + 30 * nodes.unit(), 255);
    node.in.shape = &node.shape;
    for (const std::size_t axis : {0u, 1u}) {
      const auto of = [axis](Point p) { return axis == 0 ? p.x : p.y; };
      const SixteenFloats vertices = places(node.in, axis, sixteen_lanes.vertex_i, sixteen_lanes.vertex_j),
                          centroids =
                              places(node.in, axis, sixteen_lanes.centroid_i, sixteen_lanes.centroid_j);
      const auto& d = axis == 0 ? node.shape.dx : node.shape.dy;
      for (std::size_t v = 0; v < 15; ++v)
        ASSERT_LE(off(vertices[v], 3 * of(node.vertex(v))), node.delta()) << round << " micro-vertex " << v;
      for (std::size_t k = 0; k < 16; ++k)
        ASSERT_LE(off(centroids[k], of(three_times(node.micro(k)))), node.delta())
            << round << " centroid " << k;
      for (std::size_t e = 0; e < edges_of_node; ++e) {
        const auto first = static_cast<std::size_t>(sixteen_lanes.edges[e] >> 16 & 15),
                   direction = static_cast<std::size_t>(sixteen_lanes.edges[e] >> 24);
        // From a cell near the end, as PieceMarks has it.
        const auto cell = static_cast<int>(of(node.edge(e)[1]) >> unit_bits);
        const float end = (vertices[first] - static_cast<float>(cell)) + d[direction];
        ASSERT_LE(off(end, 3 * (of(node.edge(e)[1]) - cell * texel)), node.delta()) << round << " edge " << e;
      }
    }
  }
}

// S = extent + 6, and what is asked is in the window.
TEST(ImplBakeBounds, WindowsHoldNoLargerCoordinate) {
  Nodes nodes(22);
  for (int round = 0; round < (sanitized ? 500 : 40000); ++round) {
    const Node node = nodes.draw(nodes.extent(0x1p-6, 89), 255);
    const std::int64_t largest = node.window.size - 1;
    ASSERT_LT(static_cast<double>(largest), node.size) << round;
    ASSERT_LE(node.window.size, sixteen_window) << round;
    for (const std::size_t k : {0u, 1u}) {
      const SixteenShape::Micro& m = node.shape.micro[k];
      for (std::size_t n = 0; n < 16; ++n) {
        if ((sixteen_lanes.turned >> n & 1) != k) continue;
        const auto from = [n](double p, double to1, double to2) {
          return p + double{sixteen_lanes.micro_i[n]} * to1 + double{sixteen_lanes.micro_j[n]} * to2;
        };
        const double x = from(node.in.p0[0], node.shape.p01[0], node.shape.p02[0]),
                     y = from(node.in.p0[1], node.shape.p01[1], node.shape.p02[1]), delta = node.delta();
        ASSERT_GT(x + m.left, delta) << round;
        ASSERT_GT(y + m.top, delta) << round;
        ASSERT_LT(x + m.right, static_cast<double>(node.in.columns - 1) - delta) << round;
        ASSERT_LT(y + m.bottom, static_cast<double>(node.in.rows - 1) - delta) << round;
      }
    }
  }
  // The least and the greatest next to whole numbers: as many texels for as little extent as can be.
  const double delta64 = 0x1p-31, low = 9, high = 19 - delta64;
  struct {
    std::int64_t left, right, top, bottom;
  } const box{floored(low - delta64), floored(high + delta64) + 1, 0, 1};
  const SixteenWindow window(box);
  EXPECT_LT(static_cast<double>(window.size - 1), sixteen_size(high - low));
}

/// Which micro-triangles met.words have at the grid's cell (i, j).
std::uint32_t kept(const MetCells& met, int i, int j) {
  const int at = (j - met.grid.row) * (met.grid.is_narrow ? 8 : 16) + i - met.grid.column;
  std::uint32_t found = 0;
  for (std::size_t p = 0; p < parts; ++p)
    found |= bits_of(have_any(met.words[static_cast<std::size_t>(at / 32)][p], 1u << (at % 32)),
                     p * hn::Lanes(F()));
  return found;
}
// margin (1 + |s|): each cell that a micro-triangle meets is asked, alone and in the grid of few.
TEST(ImplBakeBounds, LinesLeaveOutNoCellThatIsMet) {
  Nodes nodes(23);
  std::uint64_t asked = 0, in_grid = 0;
  for (int round = 0; round < (sanitized ? 100 : 12000); ++round) {
    Node node = nodes.draw(round % 30 == 0 ? nodes.extent(20, 89) : nodes.extent(0x1p-6, 20), 255);
    node.in.shape = &node.shape;
    const auto micro = micros(node);
    OneCell one(node.in);
    for (int j = 0; j + 1 < node.in.rows; ++j)
      for (int i = 0; i + 1 < node.in.columns; ++i) {
        const std::uint32_t met = meeting(micro, cell_box(i, j));
        // Few of those where rounding does not matter.
        if (met == 0 ||
            (met == meeting(micro, cell_box(i, j).grown(-texel / 128)) && nodes.random() % 8 != 0))
          continue;
        one.turn(i, j);
        const Words words(node.in);
        MetCells cells;
        const CellMarks marks = cells_of<false>(node.in, words, cells);
        ASSERT_EQ(met & marks.fit & ~marks.meets_mixed, 0u) << round << " cell " << i << ' ' << j;
        ++asked;
        if (node.shape.is_small && words.is_small) {
          FewCells few;
          few.take(node.in, words);
          ASSERT_LE(few.grid.words, CellGrid::most_words) << round;
          ASSERT_FALSE(few.are_none) << round << " cell " << i << ' ' << j;
          cells.grid = few.grid;
          const CellMarks again = cells_of<true>(node.in, words, cells);
          ASSERT_EQ(again.meets_mixed, marks.meets_mixed);
          ASSERT_EQ(met & ~kept(cells, i, j), 0u) << round << " cell " << i << ' ' << j;
          ++in_grid;
        }
        one.turn(i, j);
      }
  }
  EXPECT_GT(asked, sanitized ? 200u : 10000u);
  EXPECT_GT(in_grid, sanitized ? 100u : 5000u);
}

/// Samples at micro-vertices and centroids.
template <class Texel>
void expect_samples_within_their_bound(Nodes& nodes, int rounds) {
  constexpr double R = std::numeric_limits<Texel>::max(), square = thirds * thirds;
  Texels<Texel> texels;
  for (int round = 0; round < rounds; ++round) {
    if (round % 64 == 0) fill(texels, nodes.random);
    const bool is_exact = round % 4 == 0;
    Node node = is_exact ? nodes.draw_exact(nodes.extent(0.25, 80), R)
                         : nodes.draw(nodes.extent(round % 4 == 1 ? 20 : 0x1p-6, 80), R);
    // A cutoff of n / 999; 2 stands for one that is beyond all.
    const auto n = static_cast<std::int64_t>(nodes.random() % 1000);
    const Wide one = Wide(3) << unit_bits,
               threshold = n == 0 ? 2 * Wide(R) * one * one : Wide(R) * n * one * one / 999;
    node.shape.threshold = static_cast<float>(static_cast<double>(threshold) / square);
    node.in.shape = &node.shape;
    node.in.texels = texels.of.data();
    node.in.pitch = Texels<Texel>::pitch;
    const auto expect = [&](const SixteenFloats& of_i, const SixteenFloats& of_j, auto exact_place,
                            std::size_t count) {
      for (std::size_t k = 0; k < 16; k += hn::Lanes(F())) {
        const Float i = hn::LoadU(F(), of_i.data() + k), j = hn::LoadU(F(), of_j.data() + k);
        const Located at(place(node.in, 0, i, j), place(node.in, 1, i, j));
        SixteenFloats g;
        hn::StoreU(sampled<Texel>(node.in, at), F(), g.data());
        for (std::size_t l = 0; l < hn::Lanes(F()) && k + l < count; ++l) {
          const Wide exact = sampled_exactly(texels, exact_place(k + l)) - threshold;
          const Wide error = static_cast<Wide>(static_cast<double>(g[l]) * square) - exact;
          ASSERT_LE(std::fabs(static_cast<double>(error)) / square, double{node.shape.bound})
              << round << ' ' << k + l;
        }
      }
    };
    expect(
        sixteen_lanes.vertex_i, sixteen_lanes.vertex_j,
        [&](std::size_t v) {
          const Point p = node.vertex(v);
          return Point{3 * p.x, 3 * p.y};
        },
        15);
    if (is_exact) continue;  // thirds are not
    expect(
        sixteen_lanes.centroid_i, sixteen_lanes.centroid_j,
        [&](std::size_t k) { return three_times(node.micro(k)); }, 16);
    if (testing::Test::HasFatalFailure()) return;
  }
}

// R (2 delta + 2^-19).
TEST(ImplBakeBounds, SamplesAreWithinTheirBound) {
  Nodes nodes(24, coarse);
  ASSERT_NO_FATAL_FAILURE(expect_samples_within_their_bound<std::uint8_t>(nodes, sanitized ? 200 : 10000));
  ASSERT_NO_FATAL_FAILURE(expect_samples_within_their_bound<std::uint16_t>(nodes, sanitized ? 200 : 10000));
}

// A centre that is taken in is within 1.6 delta of the triangle, or twice that beside a flat edge; one that is left out
// is within 3 delta of an edge.  Either is less than texels are clear of their limits.
TEST(ImplBakeBounds, CentresTakenInAreNearTheTriangle) {
  Nodes nodes(25);
  std::uint64_t taken_in = 0, left_out = 0;
  for (int round = 0; round < (sanitized ? 500 : 400000); ++round) {
    // All centres of some nodes; of the others the one that was aimed at.
    const bool all = round % 32 == 0;
    Node node = nodes.draw(round % 1024 == 0 ? nodes.extent(20, 89) : nodes.extent(0.25, 20), 255);
    node.in.shape = &node.shape;
    const auto micro = micros(node);
    const double R = 255, delta = node.delta(), reach = 1.6 * delta * (node.shape.has_flat ? 2 : 1);
    take_bounds(node.shape, R, 2 * R * reach, delta);
    ASSERT_FALSE(node.shape.clear) << "marks of centres that are not the triangle's count";
    WindowBits opaque;
    node.in.strip = WindowBits::strip;
    node.in.opaque = node.in.visible = opaque.words();
    const auto expect = [&](int i, int j) {
      const Point centre{i * texel, j * texel};
      const std::uint32_t may = meeting(micro, square_about(centre, units(reach)));
      std::uint32_t must = 0;
      for (std::size_t k = 0; k < 16; ++k)
        must |= std::uint32_t{micro[k].holds(square_about(centre, units(3 * delta)))} << k;
      // Few of those where rounding does not matter.
      if (all && may == must && nodes.random() % 8 != 0) return;
      opaque.fill(0);
      opaque.flip(node.in, i, j);
      MetCells none;
      const CellMarks lit = cells_of<false>(node.in, Words(node.in), none);
      opaque.fill(~0u);
      opaque.flip(node.in, i, j);
      const CellMarks dark = cells_of<false>(node.in, Words(node.in), none);
      ASSERT_EQ((lit.have | dark.have_not) & lit.fit & ~may, 0u) << round << " centre " << i << ' ' << j;
      ASSERT_EQ(must & lit.fit & ~(lit.perhaps & dark.perhaps_not), 0u)
          << round << " centre " << i << ' ' << j;
      taken_in += lit.have != 0;
      left_out += lit.have != may;
    };
    const auto nearest = [](Unit x) { return static_cast<int>((x + texel / 2) >> unit_bits); };
    const int aim_i = nearest(node.aimed.x), aim_j = nearest(node.aimed.y);
    for (int j = all ? 1 : aim_j; j <= (all ? node.in.rows - 2 : aim_j); ++j)
      for (int i = all ? 1 : aim_i; i <= (all ? node.in.columns - 2 : aim_i); ++i)
        if (i >= 1 && j >= 1 && i <= node.in.columns - 2 && j <= node.in.rows - 2) expect(i, j);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(taken_in, sanitized ? 50u : 10000u);
  EXPECT_GT(left_out, sanitized ? 50u : 10000u);
}

}  // namespace
}  // namespace mmverify::tests
