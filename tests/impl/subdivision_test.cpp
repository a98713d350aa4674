// [release] impl/subdivision at its limits: the last levels, the largest denominator, levels beyond the last.
#include "impl/subdivision/subdivision.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "spec/fixed.hpp"
#include "spec/subdivision/subdivision.hpp"

namespace impl_subdivision_test {

using namespace mmverify::impl::subdivision;
namespace spec = mmverify::spec;
constexpr std::uint32_t most = std::uint32_t{1} << 31;
constexpr std::array all{Scheme::triangle_4, Scheme::triangle_9,  Scheme::hilbert,
                         Scheme::morton,     Scheme::tetrahedron, Scheme::bisection};

std::uint64_t right(Scheme scheme, const Point& p) {
  const auto s = static_cast<spec::subdivision::Scheme>(scheme);
  const spec::Int128 N = side(scheme, highest_level(scheme));
  return spec::subdivision::index<spec::Int128>(
      s, highest_level(scheme), {p.numerators[0] * N, p.numerators[1] * N, p.numerators[2] * N},
      p.denominator * N);
}

TEST(ImplSubdivision, CornersOfTheShapeAtTheLastLevel) {
  for (const Scheme scheme : all)
    for (const Point& p : {Point{{0, 0, 0}, most}, Point{{most, 0, 0}, most}, Point{{0, most, 0}, most},
                           Point{{most / 2, most / 2, 0}, most}, Point{{1, most - 1, 0}, most},
                           Point{{most - 2, 1, 0}, most - 1}, Point{{1, 1, 0}, 3}})
      EXPECT_EQ(index(scheme, highest_level(scheme), p), right(scheme, p))
          << static_cast<int>(scheme) << " " << p.numerators[0] << " " << p.numerators[1];
  for (const Point& p :
       {Point{{0, 0, most}, most}, Point{{most / 4, most / 4, most / 4}, most}, Point{{1, 1, 1}, 3}})
    EXPECT_EQ(index(Scheme::tetrahedron, 10, p), right(Scheme::tetrahedron, p));
}

TEST(ImplSubdivision, TheLastCellHasTheLastIndex) {
  for (const Scheme scheme : all) {
    const Level n = highest_level(scheme);
    const auto last = static_cast<std::uint32_t>(
        spec::subdivision::cells(static_cast<spec::subdivision::Scheme>(scheme), n) - 1);
    const Corners corners_of_last = corners(scheme, n, last);
    Point middle{{}, 4 * side(scheme, n)};
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t axis = 0; axis < 3; ++axis)
        middle.numerators[axis] += corners_of_last[c == 3 && corners_of_last[3] == Vertex{} ? 0 : c][axis];
    EXPECT_EQ(index(scheme, n, middle), last) << static_cast<int>(scheme);
  }
}

TEST(ImplSubdivision, AHigherLevelIsTheLastOne) {
  for (const Scheme scheme : all) {
    const Point p{{12345, 678, 0}, 99999};
    EXPECT_EQ(index(scheme, 99, p), index(scheme, highest_level(scheme), p));
    EXPECT_EQ(corners(scheme, 99, 7), corners(scheme, highest_level(scheme), 7));
    EXPECT_EQ(side(scheme, 99), side(scheme, highest_level(scheme)));
  }
}

}  // namespace impl_subdivision_test
