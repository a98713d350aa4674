// [release] Points as the laws print, read, round and draw them at random.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"
#include "proofs/engine/random.hpp"
#include "proofs/index/floats/stiff_doubles.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/points/exact_float.hpp"
#include "proofs/points/point.hpp"
#include "proofs/points/stiff_floats.hpp"

namespace index_points_test {

using namespace mmverify::proofs;
using namespace mmverify::proofs::index;
using mmverify::spec::Fixed128;
using mmverify::spec::Fixed256;
using mmverify::spec::Integer;
namespace spec = mmverify::spec;

Rational ratio(const Integer& a, const Integer& b) { return Rational(a, b); }
Rational power(int e) {
  return e >= 0 ? Rational(Integer(Integer(1) << e)) : ratio(1, Integer(1) << static_cast<unsigned>(-e));
}

// ---- Random

TEST(Random, TheSameNumbersForTheSameSeedStreamAndSample) {
  const auto first_four = [](std::uint64_t seed, std::uint64_t stream, std::uint64_t sample) {
    Random random(seed, stream, sample);
    return std::vector{random.next(), random.next(), random.next(), random.next()};
  };
  EXPECT_EQ(first_four(1, 2, 3), first_four(1, 2, 3));
  EXPECT_NE(first_four(1, 2, 3), first_four(2, 2, 3));
  EXPECT_NE(first_four(1, 2, 3), first_four(1, 3, 3));
  EXPECT_NE(first_four(1, 2, 3), first_four(1, 2, 4));
  EXPECT_NE(first_four(1, 2, 3), first_four(2, 1, 3));  // seed and stream do not change places
}

TEST(Random, BelowAndBetweenReachEveryValueAndNoOther) {
  Random random(1, 0, 0);
  std::vector<int> below(7), between(5);
  for (int k = 0; k < 10'000; ++k) {
    const std::uint64_t b = random.below(7);
    ASSERT_LT(b, 7u);
    ++below[b];
    const std::int64_t i = random.between(-2, 2);
    ASSERT_TRUE(i >= -2 && i <= 2);
    ++between[static_cast<std::size_t>(i + 2)];
    ASSERT_EQ(random.below(1), 0u);
    ASSERT_LT(random.below(std::uint64_t{1} << 32), std::uint64_t{1} << 32);
    ASSERT_EQ(random.between(5, 5), 5);
  }
  // Within 20 % of even: fixed seed, so this either always holds or never.
  for (const int times : below) EXPECT_NEAR(times, 10'000 / 7.0, 0.2 * 10'000 / 7.0);
  for (const int times : between) EXPECT_NEAR(times, 2'000, 400);
}

// ---- Printing and reading

// 4u and 4v: 3/2 and 1, one line; 8u and 8v: 3 and 2, three lines; 2u, 2v: 3/4, 1/2, sum 5/4, none.
TEST(CaseText, ByHand) {
  const RationalPoint p{ratio(3, 8), ratio(1, 4)};
  EXPECT_EQ(case_text(p, 1), "i:u=3/8,v=1/4");
  EXPECT_EQ(case_text(p, 2), "e:u=3/8,v=1/4");
  EXPECT_EQ(case_text(p, 3), "v:u=3/8,v=1/4");
  EXPECT_EQ(case_text({ratio(0, 1), ratio(1, 1)}, 5), "v:u=0,v=1");
  EXPECT_EQ(hex_text(p), "(0x1.8p-2,0x1p-2)");
  EXPECT_EQ(hex_text({ratio(1, 3), ratio(1, 4)}), "");
}

void expect_round_trip(const RationalPoint& p, Level n) {
  const RationalPoint q = parse_point(case_text(p, n));
  EXPECT_EQ(q.u, p.u) << case_text(p, n);
  EXPECT_EQ(q.v, p.v) << case_text(p, n);
}

TEST(ParsePoint, ReadsEveryCellBack) {
  for (Level n = 0; n <= 3; ++n)
    Cells(n).rows(0, cell_count(n), [&](const Row& row) {
      for (std::uint64_t t = 0; t < row.count; ++t) expect_round_trip(rational(representative(row, t, n)), n);
    });
}

TEST(ParsePoint, ReadsStiffFloatsAndOddFractionsBack) {
  for (std::uint64_t sample = 0; sample < 700; ++sample) {
    const FloatPair p = stiff_floats(9, 1, sample);
    expect_round_trip({rational(p.u), rational(p.v)}, 9);
  }
  expect_round_trip({ratio(1, 3), ratio(10, 27)}, 2);
  expect_round_trip({ratio(1, Integer(1) << 149), ratio((Integer(1) << 99) - 1, Integer(1) << 99)}, 2);
}

void expect_read(const std::string& text, const Rational& u, const Rational& v) {
  try {
    const RationalPoint p = parse_point(text);
    EXPECT_EQ(p.u, u) << text;
    EXPECT_EQ(p.v, v) << text;
  } catch (const std::exception& error) {
    ADD_FAILURE() << text << ": " << error.what();
  }
}

TEST(ParsePoint, FractionsDecimalsAndHexadecimalFloats) {
  expect_read("u=3/8,v=1/4", ratio(3, 8), ratio(1, 4));
  expect_read("i:u=3/8,v=1/4", ratio(3, 8), ratio(1, 4));
  expect_read("u=6/16,v=0", ratio(3, 8), ratio(0, 1));
  expect_read("u=0,v=1", ratio(0, 1), ratio(1, 1));
  expect_read("u=0x1.8p-2,v=0X1P-2", ratio(3, 8), ratio(1, 4));
  expect_read("u=-0,v=-0/5", ratio(0, 1), ratio(0, 1));
}

// A leading zero is a zero, not the sign of an octal number.
TEST(ParsePoint, DecimalsAreDecimal) {
  expect_read("u=0.375,v=0.25", ratio(3, 8), ratio(1, 4));
  expect_read("u=0.1,v=0.9", ratio(1, 10), ratio(9, 10));
  expect_read("u=0.010,v=0.08", ratio(1, 100), ratio(2, 25));
  expect_read("u=010/32,v=08/32", ratio(10, 32), ratio(8, 32));
  expect_read("u=1/010,v=1/09", ratio(1, 10), ratio(1, 9));
}

// A number is taken exactly or not at all: 17 hexadecimal digits do not fit a double, 2^-2000 neither.
TEST(ParsePoint, LongHexadecimalFloatsAreNotRounded) {
  const auto exact_or_refused = [](const std::string& u, const Rational& want) {
    try {
      EXPECT_EQ(parse_point("u=" + u + ",v=0").u, want) << u;
    } catch (const BadCase&) {
    }
  };
  exact_or_refused("0x1.0000000000000001p-1", power(-1) + power(-65));
  exact_or_refused("0x1p-2000", power(-2000));
}

TEST(ParsePoint, RefusesWhatIsNoPoint) {
  for (const char* text : {"",
                           "u=1/2",
                           "u=1/2,v=",
                           "u=,v=0",
                           "v=0,u=0",
                           "u=1/2;v=0",
                           "u=1/2,v=0,w=1/2",
                           "x:u=0,v=0",
                           "u=a,v=0",
                           "u=1/2/2,v=0",
                           "u=0x,v=0",
                           "u=0x1.8,v=0",
                           "u=1e-3,v=0",
                           "u=nan,v=0",
                           "u=inf,v=0",
                           "u= 1/2,v=0",
                           "u=1/2,v=0 ",
                           "u=+1/2,v=0",
                           "u=.5,v=0",
                           "u=1/-2,v=0",
                           "u=0x1p99999,v=0",
                           "k=5",
                           "u=1/2,v=0\nu=0"})
    EXPECT_THROW(parse_point(text), BadCase) << text;
}

TEST(ParsePoint, RefusesDivisionByZero) {
  EXPECT_THROW(parse_point("u=1/0,v=0"), BadCase);
  EXPECT_THROW(parse_point("u=0/0,v=0"), BadCase);
  EXPECT_THROW(parse_point("u=0,v=1/000"), BadCase);
}

// Points up to 2^-11 beyond the hypotenuse are kept: two numbers of binary16 do land that far over it.
TEST(ParsePoint, RefusesPointsOutsideTheTriangle) {
  for (const char* text : {"u=-1/8,v=0", "u=0,v=-1/1000000", "u=1,v=1", "u=3/2,v=0", "u=-0x1p-60,v=0"})
    EXPECT_THROW(parse_point(text), BadCase) << text;
  EXPECT_NO_THROW(parse_point("u=1/2,v=0x1.000002p-1"));
  EXPECT_NO_THROW(parse_point("u=1,v=0x1p-11"));
  EXPECT_THROW(parse_point("u=1,v=0x1.8p-11"), BadCase);
}

// ---- Rounding and ordering

TEST(Nearest, RoundsHalfwayCasesToEvenAndAllOthersToTheNearest) {
  const Rational odd = power(53) + Rational(1), even = power(53) + Rational(3);
  EXPECT_EQ(nearest(odd), 0x1p53);
  EXPECT_EQ(nearest(even), 0x1p53 + 4);
  // The least bit beyond the halfway point decides, however far away it is.
  EXPECT_EQ(nearest(odd + power(-900)), 0x1p53 + 2);
  EXPECT_EQ(nearest(even - power(-900)), 0x1p53 + 2);
  // A carry through all bits into the next binade.
  EXPECT_EQ(nearest(power(60) - ratio(1, 3)), 0x1p60);
  EXPECT_EQ(nearest(Rational(1) - power(-54)), 1.0);
  EXPECT_EQ(nearest(Rational(1) - power(-53)), 1 - 0x1p-53);
  EXPECT_EQ(nearest(Rational(0)), 0.0);
  EXPECT_EQ(nearest(ratio(-1, 3)), -0x1.5555555555555p-2);
}

// The compiler and the C library round decimals correctly, by algorithms of their own.
TEST(Nearest, AgreesWithDecimalsReadByTheCompiler) {
  EXPECT_EQ(nearest(ratio(1, 10)), 0.1);
  EXPECT_EQ(nearest(ratio(2, 3)), 0.66666666666666666666666666666666666667);
  EXPECT_EQ(nearest(ratio(123'456'789, 1'000'000)), 123.456789);
  // Within 2^-100 of a tie, relatively: known stiff cases of strtod.
  EXPECT_EQ(nearest(ratio(Integer("9007199254740993"), 1)), 9007199254740993.0);
  EXPECT_EQ(
      nearest(Rational(Integer("8402110395206533")) * Rational(boost::multiprecision::pow(Integer(10), 45))),
      8402110395206533e45);
  EXPECT_EQ(nearest(ratio(Integer("6965949469487146"), boost::multiprecision::pow(Integer(10), 249))),
            6965949469487146e-249);
  Random random(1, 0, 0);
  for (int k = 0; k < 2'000; ++k) {
    const std::uint64_t digits = random.next();
    const int e = static_cast<int>(random.between(0, 280));
    const std::string text = std::to_string(digits) + "e-" + std::to_string(e);
    ASSERT_EQ(
        nearest(ratio(Integer(digits), boost::multiprecision::pow(Integer(10), static_cast<unsigned>(e)))),
        std::strtod(text.c_str(), nullptr))
        << text;
  }
}

TEST(Nearest, GivesEveryFloatBack) {
  for (const double x :
       {0x1p-1022, 0x1.fffffffffffffp1023, -0x1.8p-3, 0x1.123456789abcdp0, 0x1p-149, 0x1p-1074})
    EXPECT_EQ(nearest(rational(x)), x);
  for (const float x : {std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(), 0.1f})
    EXPECT_EQ(nearest(rational(x)), static_cast<double>(x));
}

// Rounded to 53 bits first, 2^-1075 (1 + 2^-60) would be a tie and go to 0; it is nearer to 2^-1074.
TEST(Nearest, RoundsSubnormalNumbersOnce) {
  EXPECT_EQ(nearest(power(-1075)), 0.0);
  EXPECT_EQ(nearest(power(-1075) * Rational(3)), 0x1p-1073);
  EXPECT_EQ(nearest(power(-1075) + power(-1135)), 0x1p-1074);
}

// The least counterexample is the one with the smallest denominator, then the lowest, then the leftmost.
TEST(Simplicity, OrdersByDenominatorThenVThenU) {
  const auto of = [](const Rational& u, const Rational& v) { return simplicity(RationalPoint{u, v}); };
  EXPECT_LT(of(ratio(1, 2), ratio(1, 2)), of(ratio(1, 4), ratio(0, 1)));
  EXPECT_LT(of(ratio(3, 4), ratio(0, 1)), of(ratio(0, 1), ratio(1, 4)));
  EXPECT_LT(of(ratio(1, 4), ratio(1, 4)), of(ratio(3, 4), ratio(1, 4)));
}

TEST(Simplicity, IsTheSameOrderForGridPointsAndRationals) {
  std::vector<GridPoint> points;
  Cells(2).rows(0, cell_count(2), [&](const Row& row) {
    for (std::uint64_t t = 0; t < row.count; ++t) points.push_back(representative(row, t, 2));
  });
  for (const GridPoint& a : points)
    for (const GridPoint& b : points)
      ASSERT_EQ(simplicity(a) < simplicity(b), simplicity(rational(a)) < simplicity(rational(b)));
}

// ---- Stiff floats

constexpr std::uint64_t samples = 20'000;

bool same_bits(const FloatPair& a, const FloatPair& b) {
  return std::bit_cast<std::uint32_t>(a.u) == std::bit_cast<std::uint32_t>(b.u) &&
         std::bit_cast<std::uint32_t>(a.v) == std::bit_cast<std::uint32_t>(b.v);
}

TEST(StiffFloats, AreTheSameForTheSameSeedAndOthersForAnother) {
  std::uint64_t other_seed = 0, other_level = 0;
  for (std::uint64_t sample = 0; sample < 1'000; ++sample) {
    const FloatPair p = stiff_floats(5, 1, sample);
    ASSERT_TRUE(same_bits(p, stiff_floats(5, 1, sample)));
    other_seed += same_bits(p, stiff_floats(5, 2, sample)) ? 0 : 1;
    other_level += same_bits(p, stiff_floats(6, 1, sample)) ? 0 : 1;
  }
  EXPECT_GT(other_seed, 900u);
  EXPECT_GT(other_level, 900u);
}

TEST(StiffFloats, LieInTheTriangleUpToOneUlp) {
  for (const Level n : {0u, 1u, 8u, 16u})
    for (std::uint64_t sample = 0; sample < samples; ++sample) {
      const FloatPair p = stiff_floats(n, 1, sample);
      ASSERT_TRUE(p.u >= 0 && p.v >= 0) << p.u << ", " << p.v;
      // Rationals: the sum of two floats need not fit a double.
      ASSERT_LE(rational(p.u) + rational(p.v), Rational(1) + power(-23)) << p.u << ", " << p.v;
    }
}

TEST(StiffFloats, EveryKindIsThere) {
  constexpr Level n = 8;
  constexpr float N = 256;
  std::uint64_t minus_zero_u = 0, minus_zero_v = 0, subnormal = 0, one_ulp_over = 0, just_under = 0,
                on_hypotenuse = 0, rounds_up_to_1 = 0, reaches_1 = 0, corner = 0, near_line = 0, ordinary = 0;
  for (std::uint64_t sample = 0; sample < samples; ++sample) {
    const auto [u, v] = stiff_floats(n, 1, sample);
    minus_zero_u += u == 0 && std::signbit(u) ? 1 : 0;
    minus_zero_v += v == 0 && std::signbit(v) ? 1 : 0;
    subnormal += std::fpclassify(u) == FP_SUBNORMAL || std::fpclassify(v) == FP_SUBNORMAL ? 1 : 0;
    corner += u == 1 || v == 1 ? 1 : 0;
    const double sum = static_cast<double>(u) + static_cast<double>(v);
    one_ulp_over += sum > 1 && sum <= 1 + 0x1p-23 ? 1 : 0;
    just_under += sum < 1 && sum >= 1 - 0x1p-23 ? 1 : 0;
    on_hypotenuse += sum == 1 && u > 0 && v > 0 ? 1 : 0;

    const float uf = u * N - std::floor(u * N), vf = v * N - std::floor(v * N);
    const bool different_size = std::min(uf, vf) > 0 && std::min(uf, vf) < 0x1p-12f * std::max(uf, vf);
    const Rational fractions = rational(uf) + rational(vf);
    // Fractions that mislead a sum in binary32: it is below 1, and rounds to 1.
    rounds_up_to_1 += different_size && fractions < Rational(1) && uf + vf >= 1 ? 1 : 0;
    reaches_1 += different_size && !(fractions < Rational(1)) ? 1 : 0;
    near_line += (uf > 0 && uf < 0x1p-10f) || uf > 1 - 0x1p-10f ? 1 : 0;
    ordinary += std::min(uf, vf) > 0.1f && std::max(uf, vf) < 0.9f ? 1 : 0;
  }
  EXPECT_GT(minus_zero_u, 20u);
  EXPECT_GT(minus_zero_v, 20u);
  EXPECT_GT(subnormal, 20u);
  EXPECT_GT(corner, 20u);
  EXPECT_GT(one_ulp_over, 20u);
  EXPECT_GT(just_under, 20u);
  EXPECT_GT(on_hypotenuse, 20u);
  EXPECT_GT(rounds_up_to_1, 20u);
  EXPECT_GT(reaches_1, 20u);
  EXPECT_GT(near_line, 20u);
  EXPECT_GT(ordinary, 20u);
}

TEST(StiffRows, LieInTheTriangleUpToOneUlpAndMisleadEachRoundingOfFigureFour) {
  constexpr Level n = 8;
  const auto floor_of = [](const Rational& q) { return spec::whole(q * Integer(256)); };
  std::uint64_t sum = 0, back_from_w = 0, complement_of_u = 0, tiny_beside_a_line = 0;
  for (std::uint64_t sample = 0; sample < samples; ++sample) {
    const auto [u, v] = stiff_rows(n, 1, sample);
    ASSERT_TRUE(u >= 0 && v >= 0) << u << ", " << v;
    const Rational exact_sum = rational(u) + rational(v), one(1);
    ASSERT_LE(exact_sum, Rational(1) + power(-23)) << u << ", " << v;
    ASSERT_TRUE(same_bits({u, v}, stiff_rows(n, 1, sample)));
    const float rounded_sum = u + v, w = 1.0f - rounded_sum, back = 1.0f - w, other = 1.0f - u;
    sum += floor_of(rational(rounded_sum)) != floor_of(exact_sum) ? 1 : 0;
    back_from_w += floor_of(rational(rounded_sum)) != floor_of(rational(back)) ? 1 : 0;
    complement_of_u += floor_of(rational(other)) != floor_of(one - rational(u)) ? 1 : 0;
    tiny_beside_a_line += u > 0 && u < 0x1p-30f && std::abs(v * 256 - std::round(v * 256)) < 0x1p-12f ? 1 : 0;
  }
  EXPECT_GT(sum, 200u);
  EXPECT_GT(back_from_w, 200u);
  EXPECT_GT(complement_of_u, 200u);
  EXPECT_GT(tiny_beside_a_line, 200u);
}

TEST(StiffDoubles, LieInTheTriangleUpToOneUlpAndAreNoFloats) {
  for (const Level n : {0u, 1u, 8u, 16u}) {
    std::uint64_t no_float = 0, over = 0, on_a_line_as_floats = 0, rounds_up_to_1 = 0, subnormal = 0;
    const double N = std::ldexp(1.0, static_cast<int>(n));
    for (std::uint64_t sample = 0; sample < samples; ++sample) {
      const auto [u, v] = stiff_doubles(n, 1, sample);
      ASSERT_TRUE(u >= 0 && v >= 0) << u << ", " << v;
      const Rational sum = rational(u) + rational(v);
      ASSERT_LE(sum, Rational(1) + power(-52)) << u << ", " << v;
      const double as_float = static_cast<double>(static_cast<float>(u));
      no_float += as_float != u ? 1 : 0;
      on_a_line_as_floats += as_float != u && as_float * N == std::floor(as_float * N) ? 1 : 0;
      over += sum > Rational(1) ? 1 : 0;
      subnormal += std::fpclassify(u) == FP_SUBNORMAL || std::fpclassify(v) == FP_SUBNORMAL ? 1 : 0;
      const double uf = u * N - std::floor(u * N), vf = v * N - std::floor(v * N);
      rounds_up_to_1 += uf + vf >= 1 && rational(uf) + rational(vf) < Rational(1) ? 1 : 0;
    }
    EXPECT_GT(no_float, samples / 4);
    EXPECT_GT(over, 20u);
    EXPECT_GT(on_a_line_as_floats, 200u);
    EXPECT_GT(rounds_up_to_1, 20u);
    EXPECT_GT(subnormal, 20u);
  }
}

// ---- Floats in fixed point

/// raw / 2^F, from the two halves of the raw number where Boost has no conversion.
Rational value(const Fixed64ForFloats& q) { return ratio(q.raw(), Integer(1) << 43); }
Rational value(const Fixed128& q) {
  const auto high = static_cast<std::int64_t>(q.raw() >> 64);
  return ratio((Integer(high) << 64) + Integer(static_cast<std::uint64_t>(q.raw())), Integer(1) << 100);
}
Rational value(const Fixed256& q) { return ratio(Integer(q.raw()), Integer(1) << 150); }

template <class Fixed, class F>
void expect_held_by(F x) {
  if (fits<Fixed>(dyadic(x))) {
    ASSERT_EQ(value(exactly<Fixed>(dyadic(x))), rational(x)) << x;
  }
}
template <class F>
void expect_held(F x) {
  expect_held_by<Fixed64ForFloats>(x);
  expect_held_by<Fixed128>(x);
  expect_held_by<Fixed256>(x);
  const auto seen = on_exact(x, x, [](const auto& p) {
    if constexpr (std::is_same_v<std::decay_t<decltype(p.u)>, Rational>)
      return p.u;
    else
      return value(p.u);
  });
  ASSERT_EQ(seen, rational(x)) << x;
}

TEST(ExactFloat, FixedPointHoldsTheFloatItWasMadeFrom) {
  std::vector<float> floats{0.0f,
                            -0.0f,
                            1.0f,
                            2.0f,
                            -1.5f,
                            0x1p-76f,
                            0x1.fffffep-76f,
                            0x1.fffffep-77f,
                            0x1p-149f,
                            -0x1p-149f,
                            0x1.fffffcp-127f,
                            0x1p-126f,
                            0x1.fffffep0f,
                            0x1.000002p1f};
  for (std::uint64_t sample = 0; sample < 2'000; ++sample) {
    const FloatPair p = stiff_floats(7, 1, sample);
    floats.push_back(p.u);
    floats.push_back(p.v);
  }
  for (const float x : floats) expect_held(x);
  for (const double x : {0.0, -0.0, 2.0, -0x1.fffffffffffffp0, 0x1p-43, 0x1.8p-43, 0x1.fffffffffffffp-48,
                         0x1p-150, 0x1.8p-150, 0x1.0000000000001p-1000, 0x1p-1074, 0x1.0000000000001p1})
    expect_held(x);
  for (std::uint64_t sample = 0; sample < 2'000; ++sample) {
    const DoublePair p = stiff_doubles(7, 1, sample);
    expect_held(p.u);
    expect_held(p.v);
  }
  EXPECT_TRUE(fits<Fixed64ForFloats>(dyadic(0x1p-43f)) && !fits<Fixed64ForFloats>(dyadic(0x1.8p-43f)));
  EXPECT_TRUE(fits<Fixed128>(dyadic(0x1.fffffep-77f)) && !fits<Fixed128>(dyadic(0x1.fffffep-78f)));
  EXPECT_TRUE(fits<Fixed256>(dyadic(0x1p-149f)) && fits<Fixed256>(dyadic(2.0)));
  EXPECT_FALSE(fits<Fixed256>(dyadic(0x1.000002p1f)) || fits<Fixed256>(dyadic(0x1p-151)));
}

}  // namespace index_points_test
