// [release] proofs/points/cells.hpp: the cells of a level, each once, however the sweep is cut.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "proofs/engine/kinds.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/points/cells.hpp"
#include "proofs/points/point.hpp"

namespace index_cells_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::points;

struct Visited {
  std::uint64_t cell;
  std::int64_t ku, kv;
  Kind kind;
  friend bool operator==(const Visited&, const Visited&) = default;
};

std::vector<Visited> visited(const Cells& cells, std::uint64_t begin, std::uint64_t end) {
  std::vector<Visited> all;
  cells.rows(begin, end, [&](const Row& row) {
    for (std::uint64_t t = 0; t < row.count; ++t)
      all.push_back({row.first + t, row.ku + static_cast<std::int64_t>(t) * row.stride, row.kv, row.kind(t)});
  });
  return all;
}

class CellsTest : public testing::TestWithParam<Level> {
 protected:
  const Level n = GetParam();
  const std::int64_t N = std::int64_t{1} << n;
  const Cells cells{n};
};

INSTANTIATE_TEST_SUITE_P(Level, CellsTest, testing::Range(Level{0}, Level{7}));

TEST_P(CellsTest, ClosedForms) {
  std::array<std::int64_t, kinds> count{};
  for (const Visited& c : visited(cells, 0, cells.size())) ++count[static_cast<std::size_t>(c.kind)];
  EXPECT_EQ(count[0], (N + 1) * (N + 2) / 2);
  EXPECT_EQ(count[1], 3 * N * (N + 1) / 2);
  EXPECT_EQ(count[2], N * N);
  EXPECT_EQ(static_cast<std::int64_t>(cells.size()), 3 * N * N + 3 * N + 1);
  EXPECT_EQ(cell_count(n), cells.size());
  EXPECT_EQ(static_cast<std::int64_t>(triangle_count(n)), N * N);
}

// A cell is settled by which lines u = i/N, v = j/N, u+v = k/N its points lie on and between: a point with
// those floors, and those fractions zero or not, lies in that cell and no other.
TEST_P(CellsTest, OneRepresentativeInEveryCell) {
  const auto place = [](std::int64_t k) { return std::pair(k / 4, k % 4 != 0); };
  std::set<std::array<std::pair<std::int64_t, bool>, 3>> places;
  std::uint64_t next = 0;
  for (const Visited& c : visited(cells, 0, cells.size())) {
    ASSERT_EQ(c.cell, next++);
    ASSERT_TRUE(c.ku >= 0 && c.kv >= 0 && c.ku + c.kv <= 4 * N);
    const int lines = (c.ku % 4 == 0) + (c.kv % 4 == 0) + ((c.ku + c.kv) % 4 == 0);
    ASSERT_EQ(c.kind, lines == 0 ? Kind::interior : lines == 1 ? Kind::edge : Kind::vertex);
    ASSERT_NE(lines, 2);
    ASSERT_TRUE(places.insert({place(c.ku), place(c.kv), place(c.ku + c.kv)}).second) << c.ku << ", " << c.kv;
  }
  EXPECT_EQ(next, cells.size());
}

TEST_P(CellsTest, RowsAreOfOneLineAndTellTheirKinds) {
  cells.rows(0, cells.size(), [&](const Row& row) {
    std::array<std::uint64_t, kinds> count{};
    for (std::uint64_t t = 0; t < row.count; ++t) {
      ++count[static_cast<std::size_t>(row.kind(t))];
      const GridPoint p = representative(row, t, n);
      ASSERT_EQ(kind_of(rational(p), n), row.kind(t));
      ASSERT_EQ(p.v, coordinate(row.kv, n));
    }
    for (const Kind k : {Kind::vertex, Kind::edge, Kind::interior})
      if (k == row.even || k == row.odd) {
        EXPECT_EQ(row.count_of(k), count[static_cast<std::size_t>(k)]);
      }
  });
}

// Chunks may begin and end anywhere in a row.
TEST_P(CellsTest, CutAnywhereTheRowsAreTheSame) {
  const std::vector<Visited> whole = visited(cells, 0, cells.size());
  const auto expect_part = [&](std::uint64_t begin, std::uint64_t end) {
    ASSERT_EQ(visited(cells, begin, end),
              std::vector<Visited>(whole.begin() + static_cast<std::ptrdiff_t>(begin),
                                   whole.begin() + static_cast<std::ptrdiff_t>(end)))
        << begin << ".." << end;
  };
  if (n <= 2) {
    for (std::uint64_t end = 0; end <= cells.size(); ++end)
      for (std::uint64_t begin = 0; begin <= end; ++begin) expect_part(begin, end);
    return;
  }
  Random random(1, n, 0);
  for (int k = 0; k < 200; ++k) {
    const std::uint64_t end = random.below(cells.size() + 1);
    expect_part(random.below(end + 1), end);
  }
  expect_part(cells.size() - 1, cells.size());
  expect_part(cells.size(), cells.size());
}

TEST_P(CellsTest, ChunksOfAnySizeCoverAll) {
  const std::vector<Visited> whole = visited(cells, 0, cells.size());
  for (const std::uint64_t size : {1u, 2u, 3u, 7u, 64u}) {
    std::vector<Visited> pieced;
    for (std::uint64_t begin = 0; begin < cells.size(); begin += size)
      for (const Visited& c : visited(cells, begin, std::min(begin + size, cells.size())))
        pieced.push_back(c);
    ASSERT_EQ(pieced, whole) << size;
  }
}

TEST_P(CellsTest, MicroTrianglesAreTheInteriors) {
  std::set<std::pair<std::int64_t, std::int64_t>> interiors, triangles;
  for (const Visited& c : visited(cells, 0, cells.size()))
    if (c.kind == Kind::interior) interiors.emplace(coordinate(c.ku, n).raw(), coordinate(c.kv, n).raw());
  for (std::uint32_t j = 0; j < N; ++j)
    for (std::uint32_t i = 0; i + j < N; ++i)
      for (const bool inverted : {false, true}) {
        if (i + j + (inverted ? 1 : 0) >= N) continue;
        const GridPoint p = representative(MicroTriangle{i, j, inverted}, n);
        triangles.emplace(p.u.raw(), p.v.raw());
      }
  EXPECT_EQ(interiors, triangles);
}

// The highest level that the laws go to; counted, not visited.
TEST(CellCount, Level16And17FitIn64Bits) {
  EXPECT_EQ(cell_count(16), 12'885'098'497u);  // 3*65536*65537 + 1
  EXPECT_EQ(cell_count(17), 51'540'000'769u);  // 3*131072*131073 + 1
}

TEST(Cells, TheLastCellsOfLevel16) {
  const Cells cells(16);
  const auto last = visited(cells, cells.size() - 3, cells.size());
  // Below the v-corner: the edges of the last strip's upper row, then the corner alone.
  ASSERT_EQ(last.size(), 3u);
  EXPECT_EQ(last[2], (Visited{cells.size() - 1, 0, 4 << 16, Kind::vertex}));
  EXPECT_EQ(last[1], (Visited{cells.size() - 2, 2, (4 << 16) - 2, Kind::edge}));
  EXPECT_EQ(last[0], (Visited{cells.size() - 3, 0, (4 << 16) - 2, Kind::edge}));
}

}  // namespace index_cells_test
