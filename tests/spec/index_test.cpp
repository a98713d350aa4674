// [release] spec/index/index.hpp and the numbers it runs on, against what was worked out by hand or by plain loops.
#include "spec/index/index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "impl/common/binary16.hpp"
#include "spec/fixed.hpp"
#include "spec/rational.hpp"

namespace spec_index_test {

using namespace mmverify::spec;
using index::Corners;
using index::Reading;
using index::Vertex;
using mmverify::impl::Binary16;

Rational ratio(std::int64_t a, std::int64_t b) { return Rational(Integer(a), Integer(b)); }
Point<Rational> at(std::int64_t u, std::int64_t v, std::int64_t over) {
  return {ratio(u, over), ratio(v, over)};
}
constexpr Fixed64 fixed(std::int64_t k, unsigned bits) { return Fixed64::dyadic(k, bits); }

// ---- Numbers

static_assert(Number<Rational> && Number<Fixed64> && Number<Fixed128> && Number<Fixed256>);
static_assert(Number<float> && Number<double> && Number<Binary16>);
static_assert(!Number<std::string> && !Number<Vertex>);

static_assert(side(0) == 1 && side(16) == 65'536 && side(31) == 2'147'483'648);
static_assert(whole(2.75f) == 2 && whole(65'535.5) == 65'535);
static_assert(whole(fixed(11, 2)) == 2 && times(3, fixed(3, 2)) == fixed(9, 2));
static_assert(fixed(1, 2) + fixed(1, 2) == fixed(1, 1) && fixed(1, 1) - Fixed64(1) < Fixed64(0));
static_assert(Fixed128::dyadic(-1, 100) < Fixed128(0) && whole(Fixed128::dyadic(7, 1)) == 3);

template <class F>
Rational exact(const F& q) {
  return Rational(Integer(q.raw()), Integer(1) << F::fraction_bits);
}
Rational exact(const Fixed128& q) {
  // Boost has no conversion from the compiler's 128 bits: high and low half separately.
  const auto high = static_cast<std::int64_t>(q.raw() >> 64);
  const auto low = static_cast<std::uint64_t>(q.raw());
  return Rational((Integer(high) << 64) + Integer(low), Integer(1) << Fixed128::fraction_bits);
}

template <class F>
class FixedTest : public testing::Test {};
using Widths = testing::Types<Fixed64, Fixed128, Fixed256>;
TYPED_TEST_SUITE(FixedTest, Widths);

// The operations of Fixed are those of the rationals it stands for: the ends of the range of a triangle's
// barycentrics, the finest step and its neighbours, and odd multiples of several sizes.
TYPED_TEST(FixedTest, ArithmeticIsThatOfRationals) {
  using F = TypeParam;
  using Word = typename F::word_type;
  std::vector<F> numbers;
  for (const int k : {-5, -1, 0, 1, 3, 12'345, 99'999}) {
    numbers.push_back(F::from_raw(Word(k)));
    for (const unsigned bits : {0u, 1u, 9u, 30u})
      if (k < 6 || bits > 16) numbers.push_back(F::dyadic(Word(k), bits));
  }
  for (const F& a : numbers) {
    for (const F& b : numbers) {
      EXPECT_EQ(exact(a + b), exact(a) + exact(b));
      EXPECT_EQ(exact(a - b), exact(a) - exact(b));
      EXPECT_EQ(a < b, exact(a) < exact(b));
      EXPECT_EQ(a == b, exact(a) == exact(b));
    }
    for (const std::uint32_t k : {0u, 1u, 2u, 7u, 65'536u})
      EXPECT_EQ(exact(times(k, a)), exact(a) * Integer(k));
    if (!(a < F(0))) {
      EXPECT_EQ(whole(a), whole(exact(a)));
    }
  }
  EXPECT_EQ(exact(F(4'000)), Rational(Integer(4'000)));
  EXPECT_EQ(exact(F::dyadic(Word(3), F::fraction_bits)), exact(F::from_raw(Word(3))));
}

TEST(Fixed256, OverflowIsAnErrorAndNeverAWrongNumber) {
  const Int256 most = std::numeric_limits<Int256>::max();
  EXPECT_THROW(Fixed256::from_raw(most) + Fixed256::from_raw(1), std::overflow_error);
  EXPECT_THROW(times(2, Fixed256::from_raw(most)), std::overflow_error);
}

TEST(Rational, WholeIsTheFloor) {
  EXPECT_EQ(whole(ratio(0, 1)), 0u);
  EXPECT_EQ(whole(ratio(7, 2)), 3u);
  EXPECT_EQ(whole(ratio(4, 1)), 4u);
  EXPECT_EQ(whole(Rational((Integer(1) << 32) - ratio(1, 1'000'003))), 0xffff'ffffu);
}

// ---- Bits

std::uint64_t naive_xor_from_above(std::uint64_t t, unsigned bits) {
  std::uint64_t f = 0;
  for (unsigned i = 0; i < bits; ++i)
    for (unsigned j = i; j < bits; ++j) f ^= (t >> j & 1) << i;
  return f;
}

std::uint64_t naive_spread(std::uint64_t x, unsigned bits) {
  std::uint64_t y = 0;
  for (unsigned i = 0; i < bits; ++i) y |= (x >> i & 1) << (2 * i);
  return y;
}

TEST(Bits, SixteenBitsOfAll) {
  for (std::uint32_t x = 0; x < 65'536; ++x) {
    ASSERT_EQ(index::spread(x), naive_spread(x, 16)) << x;
    ASSERT_EQ(index::xor_from_above<16>(x), naive_xor_from_above(x, 16)) << x;
  }
}

// Both are linear over XOR, so the single bits decide all words; a few words besides show the linearity.
TEST(Bits, ThirtyTwoBitsInWideWords) {
  std::vector<std::uint64_t> words{0, 0xffff'ffff, 0xdead'beef, 0x8000'0001, 0x5555'5555};
  for (unsigned i = 0; i < 32; ++i) words.push_back(std::uint64_t{1} << i);
  for (const std::uint64_t x : words) {
    EXPECT_EQ(index::spread(x), naive_spread(x, 32)) << x;
    EXPECT_EQ(index::xor_from_above<32>(x), naive_xor_from_above(x, 32)) << x;
  }
}

static_assert(index::spread(0b1011u) == 0b1000101u);
static_assert(index::xor_from_above<16>(0b0100u) == 0b0111u && index::xor_from_above<16>(0b0110u) == 0b0100u);

// ---- Point -> index, by hand

template <class Q>
std::array<std::uint32_t, 5> all_algorithms(const Point<Q>& p, Level n) {
  return {index::reference(p, n), static_cast<std::uint32_t>(index::reference_wide(p, n)),
          index::step<Reading::printed>(p, n), index::step<Reading::appendix_middle>(p, n),
          index::step<Reading::appendix_ties>(p, n)};
}

TEST(ByHand, Level0HasOneTriangle) {
  for (const auto& p : {at(0, 0, 1), at(1, 0, 1), at(0, 1, 1), at(1, 1, 3), at(1, 1, 2)}) {
    for (const std::uint32_t k : all_algorithms(p, 0)) EXPECT_EQ(k, 0u);
    EXPECT_EQ(index::step<Reading::appendix_names>(p, 0), 0u);
    EXPECT_EQ(index::w_minor(p, 0), 0u);
  }
}

// The four children are numbered w-corner 0, middle 1, u-corner 2, v-corner 3: the paper's figure 2.  The
// corner itself, and the point 1/6 of the way from each side of its child (in the middle one, 1/3 from all).
TEST(ByHand, Level1CornersAndCentres) {
  const std::vector<std::pair<Point<Rational>, std::uint32_t>> known{
      {at(0, 0, 1), 0}, {at(1, 1, 6), 0}, {at(1, 1, 3), 1}, {at(1, 0, 1), 2},
      {at(4, 1, 6), 2}, {at(0, 1, 1), 3}, {at(1, 4, 6), 3}};
  for (const auto& [p, k] : known)
    for (const std::uint32_t got : all_algorithms(p, 1)) EXPECT_EQ(got, k) << p.u << ", " << p.v;
}

// Algorithm 4 as printed, (1/4, 1/4), level 3:
//   u v w = 1/4 1/4 1/2: 2w = 1, not L; 2v = 1/2, not T; 2u = 1/2, not R; M, digit 1, mid-flip set;
//     u_M, w_M, v_M = u+v-w, w+u-v, v+w-u = 0, 1/2, 1/2
//   u v w = 0 1/2 1/2: 2w = 1, not L; 2v = 1 is a tie and mid-flip is set, not T; M, digit 1, mid-flip clear;
//     u_M, w_M, v_M = 0, 0, 1
//   u v w = 0 0 1: 2w = 2, L, digit 0.                                                   1*16 + 1*4 + 0 = 20
// Appendix A's order puts v_M before w_M, 0, 1, 0, at the second step: 2v = 2, T, digit 3. 1*16 + 1*4 + 3 =
// 23 The reference: N = 8, iu = iv = 2, no fractions, NOT iw = 4; b0 = 2 XOR 4 = 110b, t = 0, b1 = 010b AND
// 001b = 0; b0 on the even bits is 10100b = 20.
TEST(ByHand, TraceOfAQuarterAndAQuarter) {
  EXPECT_EQ(index::reference(at(1, 1, 4), 3), 20u);
  EXPECT_EQ(index::step<Reading::printed>(at(1, 1, 4), 3), 20u);
  EXPECT_EQ(index::step<Reading::appendix_middle>(at(1, 1, 4), 3), 23u);
}

// (3/8, 3/8), level 2:
//   u v w = 3/8 3/8 1/4: M, digit 1, mid-flip set; u_M, w_M, v_M = 1/2, 1/4, 1/4
//   u v w = 1/2 1/4 1/4: not L, not T; 2u = 1.  As printed the exception asks for a tie of v, there is none:
//     R, digit 2.  In the prose of Appendix A it asks for a tie of u, and mid-flip is set: M, digit 1.
// 1*4 + 2 = 6, or 1*4 + 1 = 5.
TEST(ByHand, TraceOfThreeEighths) {
  EXPECT_EQ(index::reference(at(3, 3, 8), 2), 6u);
  EXPECT_EQ(index::step<Reading::printed>(at(3, 3, 8), 2), 6u);
  EXPECT_EQ(index::step<Reading::appendix_ties>(at(3, 3, 8), 2), 5u);
}

// (0, 1/2), level 2:
//   u v w = 0 1/2 1/2: 2w = 1, not L; 2v = 1, a tie, but mid-flip is clear: T, digit 3, top-flip set.
//     As printed the point moves to the v-corner: 2u, v-u-w, 2w = 0, 0, 1.
//     With Appendix A's T it moves to the w-corner: 2u, 2v, w-u-v = 0, 1, 0.
//   As printed: 2w = 2, L, which top-flip makes digit 2.  Renamed: 2v = 2, T, digit 3.
// 3*4 + 2 = 14, or 3*4 + 3 = 15.
TEST(ByHand, TraceOfHalfUpTheEdge) {
  EXPECT_EQ(index::reference(at(0, 1, 2), 2), 14u);
  EXPECT_EQ(index::step<Reading::printed>(at(0, 1, 2), 2), 14u);
  EXPECT_EQ(index::step<Reading::appendix_names>(at(0, 1, 2), 2), 15u);
}

// (1/2, 0), level 2:
//   u v w = 1/2 0 1/2: 2w = 1, not L; not T; 2u = 1, R, digit 2; u-v-w, 2v, 2w = 0, 0, 1
//   u v w = 0 0 1: L, digit 0; begun anew, u v w = 1/2 0 1/2 again: R, digit 2.
// 2*4 + 0 = 8, or 2*4 + 2 = 10.
TEST(ByHand, TraceOfHalfAlongTheEdge) {
  EXPECT_EQ(index::reference(at(1, 0, 2), 2), 8u);
  EXPECT_EQ(index::step<Reading::printed>(at(1, 0, 2), 2), 8u);
  EXPECT_EQ(index::step<Reading::restarted>(at(1, 0, 2), 2), 10u);
}

// Begun anew at each node, a point has its first digit d n times: d (4^n - 1) / 3.
TEST(ByHand, ARestartedStepRepeatsItsFirstDigit) {
  for (Level n = 0; n <= 6; ++n)
    for (std::int64_t i = 0; i <= 12; ++i)
      for (std::int64_t j = 0; i + j <= 12; ++j) {
        const auto p = at(i, j, 12);
        EXPECT_EQ(index::step<Reading::restarted>(p, n), index::reference(p, 1) * (((1u << 2 * n) - 1) / 3));
      }
}

TEST(ByHand, TheReferenceClampsEachCoordinate) {
  EXPECT_EQ(index::reference(at(-1, 1, 4), 2), index::reference(at(0, 1, 4), 2));
  EXPECT_EQ(index::reference(at(9, 0, 4), 2), index::reference(at(4, 0, 4), 2));
  // Beyond the hypotenuse u gives way: (1, 1) is in column iv = N-1, so iu = 0, the v-corner's triangle.
  EXPECT_EQ(index::reference(at(1, 1, 1), 2), 15u);
}

// The text of the specification is usable at compile time where its number is.
static_assert(index::reference(Point<Fixed64>{fixed(1, 2), fixed(1, 2)}, 3) == 20);
static_assert(index::reference_wide(Point<Fixed64>{fixed(1, 2), fixed(1, 2)}, 3) == 20);
static_assert(index::step<Reading::printed>(Point<Fixed64>{fixed(1, 2), fixed(1, 2)}, 3) == 20);
static_assert(index::step<Reading::appendix_middle>(Point<Fixed128>{Fixed128::dyadic(1, 2),
                                                                    Fixed128::dyadic(1, 2)},
                                                    3) == 23);
static_assert(index::step<Reading::appendix_ties>(Point<float>{0.375f, 0.375f}, 2) == 5);
static_assert(index::step<Reading::appendix_names>(Point<Binary16>{Binary16(0.0), Binary16(0.5)}, 2) == 15);
static_assert(index::w_minor(Point<Fixed64>{Fixed64(0), Fixed64(1)}, 2) == 15);

// ---- Index -> corners, by hand

// P = (w-corner, u-corner, v-corner) of each parent; the midpoints put in by hand, parent after parent.
constexpr std::array<Corners, 4> level_1{{{{{0, 0}, {1, 0}, {0, 1}}},
                                          {{{0, 1}, {1, 1}, {1, 0}}},
                                          {{{1, 0}, {2, 0}, {1, 1}}},
                                          {{{1, 1}, {0, 1}, {0, 2}}}}};
constexpr std::array<Corners, 16> level_2{{
    {{{0, 0}, {1, 0}, {0, 1}}},  // parent (0,0) (2,0) (0,2)
    {{{0, 1}, {1, 1}, {1, 0}}},
    {{{1, 0}, {2, 0}, {1, 1}}},
    {{{1, 1}, {0, 1}, {0, 2}}},
    {{{0, 2}, {1, 2}, {1, 1}}},  // parent (0,2) (2,2) (2,0)
    {{{1, 1}, {2, 1}, {1, 2}}},
    {{{1, 2}, {2, 2}, {2, 1}}},
    {{{2, 1}, {1, 1}, {2, 0}}},
    {{{2, 0}, {3, 0}, {2, 1}}},  // parent (2,0) (4,0) (2,2)
    {{{2, 1}, {3, 1}, {3, 0}}},
    {{{3, 0}, {4, 0}, {3, 1}}},
    {{{3, 1}, {2, 1}, {2, 2}}},
    {{{2, 2}, {1, 2}, {1, 3}}},  // parent (2,2) (0,2) (0,4)
    {{{1, 3}, {0, 3}, {1, 2}}},
    {{{1, 2}, {0, 2}, {0, 3}}},
    {{{0, 3}, {1, 3}, {0, 4}}},
}};

TEST(Corners, Levels0To2ByHand) {
  EXPECT_EQ(index::corners(0, 0), (Corners{{{0, 0}, {1, 0}, {0, 1}}}));
  for (std::uint32_t k = 0; k < 4; ++k) EXPECT_EQ(index::corners(k, 1), level_1[k]) << k;
  for (std::uint32_t k = 0; k < 16; ++k) EXPECT_EQ(index::corners(k, 2), level_2[k]) << k;
}

static_assert(index::corners(6, 2) == level_2[6]);

Point<Rational> centre(const Corners& c, Level n) {
  return at(std::int64_t{c[0].i} + c[1].i + c[2].i, std::int64_t{c[0].j} + c[1].j + c[2].j,
            3 * std::int64_t{side(n)});
}

TEST(Corners, TheirCentreHasTheIndexByHand) {
  for (std::uint32_t k = 0; k < 16; ++k) {
    EXPECT_EQ(index::reference(centre(level_2[k], 2), 2), k);
    EXPECT_EQ(index::step<Reading::printed>(centre(level_2[k], 2), 2), k);
  }
}

/// Corners in one order, so that two spellings of a triangle compare equal.
std::set<std::pair<std::uint32_t, std::uint32_t>> as_set(const Corners& c) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> s;
  for (const Vertex& v : c) s.emplace(v.i, v.j);
  return s;
}

// A vertex belongs to the triangle on its +u, +v side; on the hypotenuse to the one on its -u side; the
// v-corner to the last.  Which number that triangle has is read off the table above.
TEST(Corners, VerticesOfLevel2RoundAwayFromW) {
  for (std::uint32_t j = 0; j <= 4; ++j)
    for (std::uint32_t i = 0; i + j <= 4; ++i) {
      const std::uint32_t left = i + j < 4 ? i : i - 1;
      const Corners mine{{{left, j}, {left + 1, j}, {left, j + 1}}};
      const auto found = std::find_if(level_2.begin(), level_2.end(),
                                      [&](const Corners& c) { return as_set(c) == as_set(mine); });
      const auto want = j == 4 ? 15u : static_cast<std::uint32_t>(found - level_2.begin());
      EXPECT_EQ(index::reference(at(i, j, 4), 2), want) << i << ", " << j;
      EXPECT_EQ(index::step<Reading::printed>(at(i, j, 4), 2), want) << i << ", " << j;
    }
}

int shared(const Corners& a, const Corners& b) {
  int count = 0;
  for (const Vertex& x : a)
    for (const Vertex& y : b) count += x == y ? 1 : 0;
  return count;
}

/// Whether the highest of the base-4 digits in which k and k+1 differ goes from 2 to 3.
bool highest_differing_digit_goes_from_2_to_3(std::uint32_t k) {
  std::uint32_t a = 0, b = 0;
  for (unsigned shift = 0; shift < 32; shift += 2)
    if ((k >> shift & 3) != ((k + 1) >> shift & 3)) a = k >> shift & 3, b = (k + 1) >> shift & 3;
  return a == 2 && b == 3;
}

// A step 2 -> 3 happens once inside each parent of each of the n levels: 1 + 4 + ... + 4^(n-1) times.
TEST(Corners, TheCurveIsContiguousButForOneVertexStepsFrom2To3) {
  for (Level n = 1; n <= 6; ++n) {
    std::uint32_t through_a_vertex = 0;
    for (std::uint32_t k = 0; k + 1 < 1u << (2 * n); ++k) {
      const bool jump = highest_differing_digit_goes_from_2_to_3(k);
      ASSERT_EQ(shared(index::corners(k, n), index::corners(k + 1, n)), jump ? 1 : 2) << k << " level " << n;
      through_a_vertex += jump ? 1 : 0;
    }
    EXPECT_EQ(through_a_vertex, ((1u << (2 * n)) - 1) / 3);
  }
}

// Another way to the index: whichever triangle of the table by corners holds the centre.
TEST(Corners, CentresGoBackAndAllTrianglesAreDifferent) {
  for (Level n = 0; n <= 5; ++n) {
    std::set<std::set<std::pair<std::uint32_t, std::uint32_t>>> different;
    for (std::uint32_t k = 0; k < 1u << (2 * n); ++k) {
      const Corners c = index::corners(k, n);
      different.insert(as_set(c));
      ASSERT_EQ(index::reference(centre(c, n), n), k) << "level " << n;
      ASSERT_EQ(index::step<Reading::printed>(centre(c, n), n), k) << "level " << n;
    }
    EXPECT_EQ(different.size(), std::size_t{1} << (2 * n));
  }
}

// ---- Row order, by hand

// Row r, counted from the w-corner, starts at r^2 on the u side; upright and inverted triangles alternate.
//   level 1: w-corner 0; u-corner 1, middle 2, v-corner 3
//   level 2: 0; 1 2 3; 4 5 6 7 8; 9 ... 15.  Per index below: grid square (i, j), then whether upside down.
constexpr std::array<std::array<std::uint32_t, 3>, 16> rows_2{{{0, 0, 0},
                                                               {1, 0, 0},
                                                               {0, 0, 1},
                                                               {0, 1, 0},
                                                               {2, 0, 0},
                                                               {1, 0, 1},
                                                               {1, 1, 0},
                                                               {0, 1, 1},
                                                               {0, 2, 0},
                                                               {3, 0, 0},
                                                               {2, 0, 1},
                                                               {2, 1, 0},
                                                               {1, 1, 1},
                                                               {1, 2, 0},
                                                               {0, 2, 1},
                                                               {0, 3, 0}}};

TEST(RowOrder, Level1ByHand) {
  EXPECT_EQ(index::w_minor(at(1, 1, 6), 1), 0u);
  EXPECT_EQ(index::w_minor(at(4, 1, 6), 1), 1u);
  EXPECT_EQ(index::w_minor(at(1, 1, 3), 1), 2u);
  EXPECT_EQ(index::w_minor(at(1, 4, 6), 1), 3u);
  EXPECT_EQ(index::w_minor(at(0, 1, 1), 1), 3u);
}

TEST(RowOrder, Level2ByHand) {
  for (std::uint32_t k = 0; k < 16; ++k) {
    const auto [i, j, upside_down] = rows_2[k];
    const std::uint32_t in = upside_down != 0 ? 2 : 1;
    EXPECT_EQ(index::w_minor(at(3 * i + in, 3 * j + in, 12), 2), k);
    const Corners corners = upside_down != 0 ? Corners{{{i + 1, j + 1}, {i, j + 1}, {i + 1, j}}}
                                             : Corners{{{i, j}, {i + 1, j}, {i, j + 1}}};
    EXPECT_EQ(as_set(index::w_minor_corners(k)), as_set(corners)) << k;
  }
  // Figure 4's own order of the corners, for one triangle of each kind.
  EXPECT_EQ(index::w_minor_corners(4), (Corners{{{2, 0}, {3, 0}, {2, 1}}}));
  EXPECT_EQ(index::w_minor_corners(5), (Corners{{{2, 0}, {2, 1}, {1, 1}}}));
}

static_assert(index::w_minor_corners(0) == Corners{{{0, 0}, {1, 0}, {0, 1}}});

TEST(RowOrder, RowOfAnIndexAroundPerfectSquares) {
  EXPECT_EQ(index::w_minor_row(0), 0u);
  for (std::uint64_t r = 1; r < 65'536; ++r) {
    const auto square = static_cast<std::uint32_t>(r * r);
    ASSERT_EQ(index::w_minor_row(square - 1), r - 1);
    ASSERT_EQ(index::w_minor_row(square), r);
    ASSERT_EQ(index::w_minor_row(square + 1), r);
  }
  EXPECT_EQ(index::w_minor_row(0xffff'ffff), 65'535u);  // 65536^2 = 2^32 is one more
}

static_assert(index::w_minor_row(4097 * 4097 - 2) == 4096);

// ---- One text, several numbers

template <class F>
void expect_same_on_grid(Level n) {
  using Word = typename F::word_type;
  const std::int64_t steps = std::int64_t{4} << n;
  for (std::int64_t v = 0; v <= steps; ++v)
    for (std::int64_t u = 0; u + v <= steps; ++u) {
      const Point<F> p{F::dyadic(Word(u), n + 2), F::dyadic(Word(v), n + 2)};
      const Point<Rational> q = at(u, v, steps);
      ASSERT_EQ(all_algorithms(p, n), all_algorithms(q, n)) << q.u << ", " << q.v << " level " << n;
      ASSERT_EQ(index::step<Reading::appendix_names>(p, n), index::step<Reading::appendix_names>(q, n));
      ASSERT_EQ(index::w_minor(p, n), index::w_minor(q, n));
    }
}

TYPED_TEST(FixedTest, EveryAlgorithmAnswersAsInRationals) {
  for (Level n = 0; n <= 3; ++n) expect_same_on_grid<TypeParam>(n);
}

// 64-bit words have the same low bits; their prefix XOR over more bits matters only above level 16.
TEST(Reference, WideWordsReachLevel31) {
  EXPECT_EQ(index::reference_wide(Point<double>{0.0, 1.0}, 31), (std::uint64_t{1} << 62) - 1);
  EXPECT_EQ(index::reference_wide(Point<double>{0.0, 0.0}, 31), 0u);
}

}  // namespace spec_index_test
