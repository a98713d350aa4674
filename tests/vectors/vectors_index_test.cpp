// The vectors of family index, held against what did not make them: the library, and the published code in plain binary32.
#include <algorithm>
#include <cmath>

#include "delivery/vectors/families/index_mistakes.hpp"
#include "impl/index/index.hpp"
#include "proofs/index/floats/published.hpp"
#include "proofs/index/known_orders.hpp"
#include "tests/vectors/reading.hpp"

namespace vectors_index_test {

using namespace mmverify;
using tests::Reading;

const Reading& points() {
  static const Reading all(tests::family("index"), "points");
  return all;
}

/// Points of which the library, or the published code written apart from the specification, says something else.
std::vector<std::size_t> disputed(const vectors::Family& family) {
  const Reading all(family, "points");
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const float u = all.number(k, "u"), v = all.number(k, "v");
    const auto n = all(k, "level");
    const vectors::Optional rows = all.optional(k, "rows");
    if (all(k, "exact") != impl::index::from_barycentrics(u, v, n) ||
        all(k, "published") != proofs::index::published(n, u, v) ||
        (rows && rows != impl::index::w_minor(u, v, n)))
      found.push_back(k);
  }
  return found;
}

TEST(VectorsIndex, LibraryAndPublishedCodeSayTheSame) {
  EXPECT_TRUE(disputed(tests::family("index")).empty());
  std::size_t rounded = 0;
  for (std::size_t k = 0; k < points().size(); ++k) {
    const bool differ = points()(k, "exact") != points()(k, "published");
    rounded += differ ? 1 : 0;
    if (points().about(k) == "below a diagonal, and the float sum rounds up to it") {
      ASSERT_TRUE(differ) << k;
    }
  }
  EXPECT_GT(rounded, 64u) << "vectors that tell the two dialects apart";
}

TEST(VectorsIndex, OneSpoiltWordIsSeen) {
  const std::size_t stride = tests::family("index").tables[0].stride();
  for (const std::size_t record : {std::size_t{0}, std::size_t{700}, points().size() - 1})
    for (const std::size_t column : {6u, 7u}) {
      vectors::Family spoilt = tests::family("index");
      spoilt.tables[0].words[record * stride + column] ^= 1;
      EXPECT_EQ(disputed(spoilt), std::vector{record}) << column;
    }
}

// At level 16 the last micro-triangle of either order has the greatest number that a word holds.
TEST(VectorsIndex, TheGreatestNumberIsAnAnswer) {
  std::size_t in_prose = 0, in_rows = 0;
  for (std::size_t k = 0; k < points().size(); ++k) {
    const vectors::Optional prose = points().optional(k, "prose"), rows = points().optional(k, "rows");
    EXPECT_EQ(prose.has_value(), points()(k, "on") != 3) << k;
    EXPECT_EQ(rows.has_value(), points()(k, "on") != 3) << k;
    in_prose += prose == 0xffffffffu ? 1 : 0;
    in_rows += rows == 0xffffffffu ? 1 : 0;
  }
  EXPECT_EQ(in_prose, 12u);
  EXPECT_EQ(in_rows, 15u);
}

// The corners of the library's micro-triangles show it: each listed one holds the point, and at small levels no other
// does.
TEST(VectorsIndex, TouchedAreThoseThatHoldThePoint) {
  std::size_t most = 0;
  for (std::size_t k = 0; k < points().size(); ++k) {
    const auto touched = points().word_list(k, "touched");
    const auto n = points()(k, "level");
    if (points()(k, "on") == 3) {
      EXPECT_TRUE(touched.empty());
      continue;
    }
    EXPECT_EQ(std::ranges::count(touched, points()(k, "exact")), 1) << k;
    EXPECT_TRUE(std::ranges::is_sorted(touched));
    if (points()(k, "on") == 0) {
      EXPECT_EQ(touched.size(), 1u) << k;
    }
    most = std::max(most, touched.size());
    const double N = std::ldexp(1.0, static_cast<int>(n)), u = points().number(k, "u") * N,
                 v = points().number(k, "v") * N;
    if ((u != 0 && u < 1e-6) || (v != 0 && v < 1e-6)) continue;  // sums that a double has no room for
    const auto holds = [&](std::uint32_t index) {
      const auto c = impl::index::corners(index, n);
      bool inside = true;
      double turn = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        const auto &p = c[a], &q = c[(a + 1) % 3];
        const double side = (double(q.i) - p.i) * (v - p.j) - (double(q.j) - p.j) * (u - p.i);
        const auto& r = c[(a + 2) % 3];
        turn = (double(q.i) - p.i) * (double(r.j) - p.j) - (double(q.j) - p.j) * (double(r.i) - p.i);
        inside = inside && side * turn >= 0;
      }
      return inside;
    };
    for (const std::uint32_t index : touched) EXPECT_TRUE(holds(index)) << k << ' ' << index;
    if (n > 4) continue;
    std::vector<std::uint32_t> all;
    for (std::uint32_t index = 0; index < 1u << 2 * n; ++index)
      if (holds(index)) all.push_back(index);
    EXPECT_EQ(all, touched) << k << ' ' << points().about(k);
  }
  EXPECT_EQ(most, 6u);
}

// Ties by doubles, in which a coordinate of 24 bits times 2^16 and the sum of two of like size have room.
TEST(VectorsIndex, TiesAreWhereNumbersAreWhole) {
  std::size_t kinds[4] = {};
  for (std::size_t k = 0; k < points().size(); ++k) {
    const auto on = points()(k, "on");
    ++kinds[on];
    const double u = points().number(k, "u"), v = points().number(k, "v"),
                 N = std::ldexp(1.0, static_cast<int>(points()(k, "level")));
    const bool has_room = (u == 0 || std::abs(u) > 1e-8) && (v == 0 || std::abs(v) > 1e-8);
    if (on == 3) {
      EXPECT_TRUE(u < 0 || v < 0 || u > 1 - v || !has_room) << k;
      EXPECT_EQ(points().optional(k, "prose"), vectors::none);
      EXPECT_EQ(points().optional(k, "rows"), vectors::none);
      continue;
    }
    const bool whole_u = u * N == std::floor(u * N), whole_v = v * N == std::floor(v * N);
    const bool whole_sum = u * N + v * N == std::floor(u * N + v * N);
    if (has_room) {
      EXPECT_EQ(on == 0, !(whole_u || whole_v || whole_sum)) << k << ' ' << points().about(k);
      EXPECT_EQ(on == 2, whole_u && whole_v) << k;
    }
    EXPECT_EQ(points().number(k, "gap") == 0, on != 0) << k;
    EXPECT_LE(points().number(k, "gap"), 0.5f);
  }
  for (const std::size_t count : kinds) EXPECT_GT(count, 40u);
}

/// Whether vector k says that it finds the mistake.
bool finds(std::size_t k, const std::string& mistake) {
  const std::vector<std::string> names = vectors::index::names_of_mistakes();
  const auto at = std::find(names.begin(), names.end(), mistake) - names.begin();
  return (points().wide(k, "finds") >> at & 1) != 0;
}

// The curve without its flips and turns is made apart from the vectors, on the grid; row order and the rounded sum have
// columns of their own.
TEST(VectorsIndex, EachMistakeIsTheOneItsNameSays) {
  std::size_t flips = 0, turns = 0;
  for (std::size_t k = 0; k < points().size(); ++k) {
    const auto n = points()(k, "level"), exact = points()(k, "exact");
    EXPECT_EQ(finds(k, "rounded_sum"), exact != points()(k, "published")) << k;
    const vectors::Optional rows = points().optional(k, "rows");
    EXPECT_EQ(finds(k, "row_order"), rows && rows != exact) << k;
    EXPECT_EQ(finds(k, "cut_to_16_bits"), exact > 0xffff) << k;
    EXPECT_TRUE(!finds(k, "level_zero") || n == 0) << k;
    EXPECT_TRUE(!finds(k, "not_clamped") || points()(k, "on") == 3) << k;
    EXPECT_TRUE(!finds(k, "tie_on_diagonal") || points()(k, "on") != 0) << k;
    EXPECT_TRUE(!finds(k, "tie_on_line") || points()(k, "on") != 0) << k;
    const auto corners = spec::index::corners(exact, n);
    std::int64_t i = 0, j = 0;
    for (const auto& corner : corners) i += corner.i, j += corner.j;
    const auto face = proofs::points::MicroTriangle{static_cast<std::uint32_t>(i / 3),
                                                    static_cast<std::uint32_t>(j / 3), i % 3 == 2};
    const auto inside = proofs::points::representative(face, n);
    const bool unflipped = proofs::index::simplified(inside, n, false, true) != exact,
               unturned = proofs::index::simplified(inside, n, true, false) != exact;
    EXPECT_EQ(finds(k, "flip_missing"), unflipped) << k;
    EXPECT_EQ(finds(k, "middle_not_turned"), unturned) << k;
    flips += unflipped ? 1 : 0;
    turns += unturned ? 1 : 0;
  }
  EXPECT_GT(flips, 100u);
  EXPECT_GT(turns, 100u);
}

// A device may take subnormal numbers for zero.
TEST(VectorsIndex, NoAnswerDependsOnSubnormalNumbers) {
  std::size_t subnormal = 0;
  for (std::size_t k = 0; k < points().size(); ++k) {
    const auto flushed = [&](const char* column) {
      const float x = points().number(k, column);
      if (std::fpclassify(x) != FP_SUBNORMAL) return x;
      ++subnormal;
      return 0.0f;
    };
    const float u = flushed("u"), v = flushed("v");
    const auto n = points()(k, "level");
    EXPECT_EQ(points()(k, "exact"), impl::index::from_barycentrics(u, v, n)) << k;
    EXPECT_EQ(points()(k, "published"), proofs::index::published(n, u, v)) << k;
  }
  EXPECT_GT(subnormal, 100u);
}

}  // namespace vectors_index_test
