// [release] spec/subdivision/ against cells, ties and shapes that were worked out by hand.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "spec/rational.hpp"
#include "spec/subdivision/tetrahedra.hpp"

namespace spec_subdivision_test {

using namespace mmverify::spec::subdivision;
using mmverify::spec::Rational;
using Whole = std::int64_t;

std::uint64_t index_of(Scheme scheme, mmverify::spec::Level n, At<Whole> p, Whole unit) {
  return index<Whole>(scheme, n, p, unit);
}

// Each child by a point in its middle; the units are the least in which all are whole.
TEST(SpecSubdivision, ChildrenComeInTheCurvesOrder) {
  const std::vector<At<Whole>> hilbert{{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}},
      morton{{1, 1, 0}, {3, 1, 0}, {1, 3, 0}, {3, 3, 0}}, in_four{{1, 1, 0}, {2, 2, 0}, {4, 1, 0}, {1, 4, 0}},
      bisection{{3, 1, 0}, {1, 3, 0}};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(index_of(Scheme::hilbert, 1, hilbert[k], 4), k);
    EXPECT_EQ(index_of(Scheme::morton, 1, morton[k], 4), k);
    EXPECT_EQ(index_of(Scheme::triangle_4, 1, in_four[k], 6), k);
  }
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(index_of(Scheme::bisection, 1, bisection[k], 6), k);
}

// Cells by their middles: from the corner at w to the one at u, and on to the one at v.
TEST(SpecSubdivision, TheTriangleInNine) {
  const std::vector<At<Whole>> middles{{1, 1, 0}, {2, 2, 0}, {1, 4, 0}, {4, 1, 0}, {7, 1, 0},
                                       {5, 2, 0}, {4, 4, 0}, {2, 5, 0}, {1, 7, 0}};
  for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(index_of(Scheme::triangle_9, 1, middles[k], 9), k);
}

TEST(SpecSubdivision, ATieGoesWhereTheFirstDirectionLeads) {
  // Right and up from the centre of a quad, left from its right edge.
  EXPECT_EQ(index_of(Scheme::hilbert, 1, {2, 2, 0}, 4), 2u);
  EXPECT_EQ(index_of(Scheme::hilbert, 1, {4, 1, 0}, 4), 3u);
  EXPECT_EQ(index_of(Scheme::hilbert, 1, {4, 4, 0}, 4), 2u);
  // The first direction, (2, 1), leads from u = v to u > v.
  EXPECT_EQ(index_of(Scheme::bisection, 1, {1, 1, 0}, 4), 0u);
  // The octahedron's centre lies on the diagonal from 02 to 13.  (1, 1, 1) leads away from corner 0: to Bey's child 7,
  // the sixth one from corner 0 to corner 3.
  EXPECT_EQ(index_of(Scheme::tetrahedron, 1, {1, 1, 1}, 4), 5u);
}

TEST(SpecSubdivision, RationalsAndWholeNumbersAgree) {
  for (const Scheme scheme : all_schemes) {
    const Cut c = cut(scheme);
    for (Whole x = 0; x <= 12; ++x)
      for (Whole y = 0; x + y <= 12; ++y) {
        const Rational twelfth = Rational(1) / Rational(12);
        EXPECT_EQ(index<Rational>(scheme, 1, {Rational(x) * twelfth, Rational(y) * twelfth, Rational(0)},
                                  Rational(1)),
                  index_of(scheme, 1, {x, y, 0}, 12))
            << c.name << " " << x << " " << y;
      }
  }
}

TEST(SpecSubdivision, CellsTileTheirShape) {
  // A sixth, or a half, of the unit: the cells' volumes as parts of it.
  for (const Scheme scheme : all_schemes) {
    const Cut c = cut(scheme);
    const Whole N = side(scheme, 2);
    Whole sum = 0, whole = 1;
    for (unsigned axis = 0; axis < c.dimension; ++axis) whole *= N;
    for (std::uint64_t k = 0; k < cells(scheme, 2); ++k) {
      const auto at = cell<Whole>(scheme, 2, k, N).corners;
      const bool quad = c.corners > c.dimension + 1;
      const Whole volume = determinant(c.dimension, difference(at[1], at[0]),
                                       difference(at[quad ? 3 : 2], at[0]), difference(at[3], at[0]));
      sum += volume < 0 ? -volume : volume;
    }
    EXPECT_EQ(sum, whole) << c.name;
  }
}

// Kuhn's tetrahedron is Bey's fixed point: all cells are of its shape.  Its longest diagonal doubles the shapes.
TEST(SpecSubdivision, ShapesByTheDiagonal) {
  const Tetrahedron kuhn{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}},
      corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (mmverify::spec::Level n = 0; n <= 4; ++n) {
    EXPECT_EQ(shapes(kuhn, Diagonal::bey, n), 1u);
    EXPECT_EQ(shapes(kuhn, Diagonal::shortest, n), 1u);
    EXPECT_EQ(shapes(kuhn, Diagonal::longest, n), std::size_t{1} << n);
    EXPECT_EQ(shapes(corner, Diagonal::bey, n), n == 0 ? 1u : 3u);
  }
}

}  // namespace spec_subdivision_test
