// The bounds of impl/bake/sixteen/ that docs/BAKE_SIXTEEN.md derives, each by itself: edges, pieces, few cells.
#include <gtest/gtest.h>

#include "tests/impl/sixteen_cells.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::tests {
namespace {

using boost::multiprecision::cpp_int;

/// Which edges find a piece in mixed cells: bit e.  Domain: alpha is opaque all over.
std::uint32_t with_pieces(const SixteenInput& in, const Words& words) {
  std::uint32_t found = 0;
  for (std::size_t from = 0; from < edges_of_node; from += 16) {
    // Each is of a micro-triangle of its own here.
    HWY_ALIGN std::array<std::int32_t, 16> list{};
    const std::size_t count = std::min<std::size_t>(16, edges_of_node - from);
    for (std::size_t n = 0; n < count; ++n) list[n] = (sixteen_lanes.edges[from + n] & ~0xffff) | 1 << n;
    Pieces<std::uint8_t> pieces(in);
    for (std::size_t n = 0; n < count; n += hn::Lanes(F()))
      add_pieces(in, words, list.data() + n, count - n, pieces);
    found |= pieces.marks().opaque << from;
  }
  return found;
}

// 16 delta (1 + |s|) of a line, and a box: each cell that an edge meets is asked.
TEST(ImplBakeBounds, EdgesLeaveOutNoCellThatIsMet) {
  const std::vector<std::uint8_t> row(sixteen_window + 8, 255);
  Nodes nodes(31);
  std::uint64_t asked = 0;
  for (int round = 0; round < (sanitized ? 100 : 8000); ++round) {
    Node node = nodes.draw(round % 30 == 0 ? nodes.extent(20, 89) : nodes.extent(0x1p-6, 20), 255);
    node.in.shape = &node.shape;
    node.in.texels = row.data();
    node.in.pitch = 0;
    OneCell one(node.in);
    std::array<std::array<Point, 2>, edges_of_node> edges;
    for (std::size_t e = 0; e < edges_of_node; ++e) edges[e] = node.edge(e);
    const auto meeting = [&](const Box& box) {
      std::uint32_t met = 0;
      for (std::size_t e = 0; e < edges_of_node; ++e) met |= std::uint32_t{meets(edges[e], box)} << e;
      return met;
    };
    for (int j = 0; j + 1 < node.in.rows; ++j)
      for (int i = 0; i + 1 < node.in.columns; ++i) {
        const std::uint32_t met = meeting(cell_box(i, j));
        // Few of those where rounding does not matter.
        if (met == 0 || (met == meeting(cell_box(i, j).grown(-texel / 128)) && nodes.random() % 8 != 0))
          continue;
        one.turn(i, j);
        ASSERT_EQ(met & ~with_pieces(node.in, Words(node.in)), 0u) << round << " cell " << i << ' ' << j;
        one.turn(i, j);
        ++asked;
      }
  }
  EXPECT_GT(asked, sanitized ? 200u : 10000u);
}

/// n / d of the way along an edge, d > 0.
struct Part {
  Wide n, d;
  friend bool operator<(const Part& a, const Part& b) { return a.n * b.d < b.n * a.d; }
};
/// The part of an edge in a closed box; is_none where there is none.
struct Piece {
  Part from{0, 1}, to{1, 1};
  bool is_none = false;

  Piece(const std::array<Point, 2>& e, const Box& box) {
    cut(e[0].x, e[1].x - e[0].x, box.left, box.right);
    cut(e[0].y, e[1].y - e[0].y, box.top, box.bottom);
    is_none = is_none || to < from;
  }

 private:
  void cut(Unit p, Unit d, Unit low, Unit high) {
    if (d == 0) {
      is_none = is_none || p < low || p > high;
      return;
    }
    const Part enters = d > 0 ? Part{low - p, d} : Part{p - high, -d},
               leaves = d > 0 ? Part{high - p, d} : Part{p - low, -d};
    from = std::max(from, enters);
    to = std::min(to, leaves);
  }
};
/// The same place on another segment, along an axis, in texels.
double at(const Part& t, Unit from, Unit by) {
  return static_cast<double>(t.d * from + t.n * by) / static_cast<double>(t.d) * 0x1p-36;
}
/// The next number in binary32.
float just_above(double x) {
  const auto near = static_cast<float>(x);
  return double{near} > x ? near : std::nextafter(near, HUGE_VALF);
}
float just_below(double x) { return -just_above(-x); }

/// The marks that PieceMarks gives edge e of a node in a cell that has this alpha.
EdgeMarks judged(const Node& node, std::size_t e, int i, int j, const Cell& alpha, float threshold) {
  SixteenShape shape = node.shape;
  shape.threshold = threshold;
  const auto first = static_cast<std::size_t>(sixteen_lanes.edges[e] >> 16 & 15);
  const Float of_i = set(sixteen_lanes.vertex_i[first]), of_j = set(sixteen_lanes.vertex_j[first]);
  PieceMarks marks;
  marks.judge(shape, set((sixteen_lanes.edges[e] & ~0xffff) | 1), alpha,
              hn::Sub(place(node.in, 0, of_i, of_j), set(static_cast<float>(i))),
              hn::Sub(place(node.in, 1, of_i, of_j), set(static_cast<float>(j))));
  return marks.marks();
}
/// The cells about what a node was aimed at, and the edges that come within `reach` of them.
template <class Ask>
void about_aim(const Node& node, double reach, const Ask& ask) {
  const auto cell = [](Unit x, double by) { return static_cast<int>((x + units(by)) >> unit_bits); };
  const auto [x, y] = node.aimed;
  for (int j = cell(y, -reach); j <= cell(y, reach); ++j)
    for (int i = cell(x, -reach); i <= cell(x, reach); ++i) {
      if (i < 1 || j < 1 || i + 2 >= node.in.columns || j + 2 >= node.in.rows) continue;
      for (std::size_t e = 0; e < edges_of_node; ++e)
        if (meets(node.edge(e), cell_box(i, j).grown(units(reach)))) ask(e, i, j);
    }
}

// Grown by 4 delta: the part of the true edge in the true cell is in the piece, seen by alphas that rise along x and
// along y.
TEST(ImplBakeBounds, PiecesHoldTheTrueEdge) {
  Nodes nodes(32, coarse);
  std::uint64_t held = 0;
  for (int round = 0; round < (sanitized ? 200 : 40000); ++round) {
    Node node = nodes.draw(nodes.extent(0x1p-6, 89), 1);
    node.in.shape = &node.shape;
    node.shape.edge_bound = 0;
    about_aim(node, 2 * node.delta(), [&](std::size_t e, int i, int j) {
      const std::array<Point, 2> edge = node.edge(e);
      const Piece piece(edge, cell_box(i, j));
      if (piece.is_none) return;
      const auto direction = static_cast<std::size_t>(sixteen_lanes.edges[e] >> 24),
                 first = static_cast<std::size_t>(sixteen_lanes.edges[e] >> 16 & 15);
      for (const std::size_t axis : {0u, 1u}) {
        const Float start =
            place(node.in, axis, set(sixteen_lanes.vertex_i[first]), set(sixteen_lanes.vertex_j[first]));
        const Unit p = units(static_cast<double>(hn::GetLane(start))) - (axis == 0 ? i : j) * texel,
                   d = units(
                       static_cast<double>(axis == 0 ? node.shape.dx[direction] : node.shape.dy[direction]));
        // The computed edge at the ends of the true piece; alpha there is off by a few roundings.
        const double one = at(piece.from, p, d), other = at(piece.to, p, d),
                     off = 0x1p-20 + 0x1p-21 * std::fabs(static_cast<double>(p) * 0x1p-36);
        const Float zero = hn::Zero(F()), rise = set(1.0f);
        const Cell alpha{zero, axis == 0 ? rise : zero, axis == 0 ? zero : rise, zero};
        const auto greatest = static_cast<float>(std::max(one, other) - off),
                   least = static_cast<float>(std::min(one, other) + off);
        ASSERT_EQ(judged(node, e, i, j, alpha, greatest).opaque, 1u) << round << " edge " << e;
        ASSERT_EQ(judged(node, e, i, j, alpha, least).below, 1u) << round << " edge " << e;
      }
      ++held;
    });
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(held, sanitized ? 100u : 40000u);
}

/// The least and the greatest of one cell's own alpha.
struct Range {
  double least = HUGE_VAL, greatest = -HUGE_VAL;

  void take(double x) {
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
  /// Along a part of an edge, exactly; rounded to binary64 once.  a + b t + c t^2, in squares of units.
  template <class Texel>
  void take(Texels<Texel>& texels, int i, int j, const std::array<Point, 2>& e, const Part& from,
            const Part& to) {
    const Wide stored = texels.at(i, j), right = texels.at(i + 1, j) - stored,
               below = texels.at(i, j + 1) - stored,
               twist = texels.at(i + 1, j + 1) - texels.at(i, j + 1) - right;
    const Wide x = e[0].x - i * texel, y = e[0].y - j * texel, dx = e[1].x - e[0].x, dy = e[1].y - e[0].y;
    const cpp_int a{stored * texel * texel + (right * x + below * y) * texel + twist * x * y},
        b{(right * dx + below * dy) * texel + twist * (x * dy + y * dx)}, c{twist * dx * dy};
    const auto put = [this](const cpp_int& n, const cpp_int& d) {
      take(static_cast<double>(n) / static_cast<double>(d) * 0x1p-72);
    };
    for (const Part& t : {from, to}) {
      const cpp_int n{t.n}, d{t.d};
      put(a * d * d + b * d * n + c * n * n, d * d);
    }
    if (c == 0) return;
    // It stands still at -b / (2 c).
    const cpp_int n = c > 0 ? cpp_int(-b) : b, d = 2 * abs(c);
    if (n * cpp_int(from.d) > d * cpp_int(from.n) && n * cpp_int(to.d) < d * cpp_int(to.n))
      put(4 * a * c - b * b, 4 * c);
  }
};

/// Ends included.
bool holds(const Box& box, Point p) {
  return p.x >= box.left && p.x <= box.right && p.y >= box.top && p.y <= box.bottom;
}

/// A piece's marks against alpha along the true edge in the true cell, and about it.
template <class Texel>
void expect_piece_within_its_bound(const Node& node, Texels<Texel>& texels, std::size_t e, int i, int j,
                                   double reach) {
  const std::array<Point, 2> edge = node.edge(e);
  const Cell alpha = cell<Texel>(node.in, set(i), set(j));
  Range about;
  for (int y = j - 1; y <= j + 1; ++y)
    for (int x = i - 1; x <= i + 1; ++x) {
      const Box near = cell_box(i, j).grown(units(reach)), there = cell_box(x, y);
      const Piece piece(edge, {std::max(near.left, there.left), std::min(near.right, there.right),
                               std::max(near.top, there.top), std::min(near.bottom, there.bottom)});
      if (!piece.is_none) about.take(texels, x, y, edge, piece.from, piece.to);
    }
  ASSERT_EQ(judged(node, e, i, j, alpha, just_below(about.least)).below, 0u);
  ASSERT_EQ(judged(node, e, i, j, alpha, just_above(about.greatest)).opaque, 0u);
  const Piece piece(edge, cell_box(i, j));
  if (piece.is_none) return;
  Range within;
  within.take(texels, i, j, edge, piece.from, piece.to);
  ASSERT_EQ(judged(node, e, i, j, alpha, just_above(within.least)).perhaps_below, 1u);
  ASSERT_EQ(judged(node, e, i, j, alpha, just_below(within.greatest)).perhaps_opaque, 1u);
}
/// Count: of pieces.
template <class Texel>
void expect_pieces_within_their_bound(Nodes& nodes, int rounds, std::uint64_t& count) {
  Texels<Texel> texels;
  for (int round = 0; round < rounds; ++round) {
    if (round % 16 == 0) fill(texels, nodes.random);
    const bool is_exact = round % 4 == 0;
    const double R = std::numeric_limits<Texel>::max();
    Node node =
        is_exact ? nodes.draw_exact(nodes.extent(0.25, 4), R) : nodes.draw(nodes.extent(0x1p-6, 89), R);
    node.in.shape = &node.shape;
    node.in.texels = texels.of.data();
    node.in.pitch = Texels<Texel>::pitch;
    const double reach = 6 * node.delta();
    about_aim(node, reach, [&](std::size_t e, int i, int j) {
      // A cut edge ends off its true end by up to the error that delta stands for.
      const Box box = cell_box(i, j);
      if (is_exact && !(holds(box, node.edge(e)[0]) && holds(box, node.edge(e)[1]))) return;
      ASSERT_NO_FATAL_FAILURE(expect_piece_within_its_bound(node, texels, e, i, j, reach))
          << round << " edge " << e;
      ++count;
    });
    if (testing::Test::HasFatalFailure()) return;
  }
}

// R (24 delta + 2^-17).
TEST(ImplBakeBounds, PiecesAreWithinTheirBound) {
  Nodes nodes(33, coarse);
  std::uint64_t count = 0;
  ASSERT_NO_FATAL_FAILURE(
      expect_pieces_within_their_bound<std::uint8_t>(nodes, sanitized ? 100 : 10000, count));
  ASSERT_NO_FATAL_FAILURE(
      expect_pieces_within_their_bound<std::uint16_t>(nodes, sanitized ? 100 : 10000, count));
  EXPECT_GT(count, sanitized ? 100u : 20000u);
}

/// A cell's own alpha, continued over the micro-triangles that meet it.
template <class Texel>
void expect_continued_alpha_within_its_bound(Nodes& nodes, int rounds, std::uint64_t& count) {
  Texels<Texel> texels;
  for (int round = 0; round < rounds; ++round) {
    if (round % 16 == 0) fill(texels, nodes.random);
    const double extent = nodes.extent(round % 2 == 0 ? 0.25 : 6, 12), R = std::numeric_limits<Texel>::max();
    Node node = round % 4 < 2 ? nodes.draw_exact(extent, R) : nodes.draw(extent, R);
    if (!node.shape.is_small) continue;
    node.in.texels = texels.of.data();
    node.in.pitch = Texels<Texel>::pitch;
    OneCell one(node.in);
    const auto micro = micros(node);
    const int j = static_cast<int>(nodes.random() % static_cast<std::uint32_t>(node.in.rows - 1)),
              i = static_cast<int>(nodes.random() % static_cast<std::uint32_t>(node.in.columns - 1));
    const std::uint32_t met = meeting(micro, cell_box(i, j));
    if (met == 0) continue;
    one.turn(i, j);
    node.in.shape = &node.shape;
    const Words words(node.in);
    FewCells few;
    few.take(node.in, words);
    ASSERT_LE(few.grid.words, CellGrid::most_words) << round;
    for (std::size_t k = 0; k < 16; ++k) {
      if ((met >> k & 1) == 0) continue;
      Range over;
      for (std::size_t c = 0; c < 3; ++c)
        over.take(texels, i, j, {micro[k].corner[c], micro[k].corner[(c + 1) % 3]}, {0, 1}, {1, 1});
      const auto found = [&](float threshold) {
        SixteenShape shape = node.shape;
        shape.threshold = threshold;
        SixteenInput in = node.in;
        in.shape = &shape;
        MetCells cells;
        cells.grid = few.grid;
        cells_of<true>(in, words, cells);
        FewAlpha alpha;
        alpha.take<Texel>(in, few);
        return ask_few(in, words, cells, alpha);
      };
      ASSERT_NE(found(just_above(over.least)).below_in[0] & 1u << k, 0u) << round << " micro-triangle " << k;
      ASSERT_NE(found(just_below(over.greatest)).opaque_in[0] & 1u << k, 0u)
          << round << " micro-triangle " << k;
      ++count;
    }
  }
}

// R (2^5 delta + 2^-14), of micro-triangles below 2.5 texels.
TEST(ImplBakeBounds, ContinuedAlphaIsWithinItsBound) {
  Nodes nodes(34, coarse);
  std::uint64_t count = 0;
  ASSERT_NO_FATAL_FAILURE(
      expect_continued_alpha_within_its_bound<std::uint8_t>(nodes, sanitized ? 200 : 60000, count));
  ASSERT_NO_FATAL_FAILURE(
      expect_continued_alpha_within_its_bound<std::uint16_t>(nodes, sanitized ? 200 : 60000, count));
  EXPECT_GT(count, sanitized ? 100u : 20000u);
}

// 2 delta inside: a place is not told by a cell that is not its own, but where alpha is 8 R delta from the limit.
TEST(ImplBakeBounds, PlacesNearABorderAreNotTold) {
  Nodes nodes(35, coarse);
  WindowBits none;
  std::uint64_t told = 0, not_told = 0;
  for (int round = 0; round < (sanitized ? 500 : 40000); ++round) {
    Node node = nodes.draw(nodes.extent(0x1p-6, 26), 255);
    node.in.shape = &node.shape;
    node.in.strip = WindowBits::strip;
    node.in.opaque = node.in.visible = none.words();
    node.shape.clear = false;
    const Words words(node.in);
    if (!words.is_small) continue;
    const auto expect = [&](const SixteenFloats& of_i, const SixteenFloats& of_j, auto exact_place,
                            std::size_t count) {
      for (std::size_t k = 0; k < 16; k += hn::Lanes(F())) {
        const Float i = hn::LoadU(F(), of_i.data() + k), j = hn::LoadU(F(), of_j.data() + k);
        const Located at(place(node.in, 0, i, j), place(node.in, 1, i, j));
        SixteenLanes::Ints marks{}, column{}, row{};
        hn::StoreU(unmixed(node.in, words, at), I(), marks.data());
        hn::StoreU(at.i, I(), column.data());
        hn::StoreU(at.j, I(), row.data());
        for (std::size_t l = 0; l < hn::Lanes(F()) && k + l < count; ++l) {
          const Point p = exact_place(k + l);
          const Unit x = p.x - column[l] * 3 * texel, y = p.y - row[l] * 3 * texel;
          const Unit from_border = std::min({x, y, 3 * texel - x, 3 * texel - y});
          // A place 4 delta inside is decided; without this the test could not fail.
          if (static_cast<double>(from_border) > 4 * node.delta() * thirds) {
            ASSERT_EQ(marks[l], 1 + 8) << round;
          }
          if (from_border <= 0) {
            ASSERT_EQ(marks[l], 0) << round << ' ' << k + l;
          }
          (marks[l] == 0 ? not_told : told) += 1;
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
    expect(
        sixteen_lanes.centroid_i, sixteen_lanes.centroid_j,
        [&](std::size_t k) { return three_times(node.micro(k)); }, 16);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(told, 1000u);
  EXPECT_GT(not_told, sanitized ? 20u : 2000u);
}

}  // namespace
}  // namespace mmverify::tests
