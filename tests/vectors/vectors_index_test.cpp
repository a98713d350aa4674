// The vectors of family index, held against what did not make them: the library, and the published code in plain binary32.
#include <bit>
#include <cmath>

#include "impl/index/index.hpp"
#include "proofs/index/floats/published.hpp"
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
    const auto n = all(k, "level"), rows = all(k, "rows");
    if (all(k, "exact") != impl::index::from_barycentrics(u, v, n) ||
        all(k, "published") != proofs::index::published(n, u, v) ||
        (rows != 0xffffffff && rows != impl::index::w_minor(u, v, n)))
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
      EXPECT_EQ(points()(k, "prose"), 0xffffffffu);
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

}  // namespace vectors_index_test
