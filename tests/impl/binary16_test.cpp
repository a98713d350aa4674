// impl/common/binary16.hpp beside the standard's formulas, encoding by encoding.
#include "impl/common/binary16.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "spec/fixed.hpp"
#include "spec/index/index.hpp"
#include "spec/rational.hpp"
#include "tests/sanitized.hpp"

namespace impl_binary16_test {

namespace spec = mmverify::spec;
using mmverify::impl::Binary16;
using spec::Fixed64;
using spec::Rational;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan_float = std::numeric_limits<float>::quiet_NaN();

static_assert(spec::Number<Binary16>);

// Value of a finite encoding, from the standard's formula.
double value_of(std::uint32_t bits) {
  const int exponent = static_cast<int>(bits >> 10 & 31), fraction = static_cast<int>(bits & 0x3ff);
  const double x = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  return (bits & 0x8000) != 0 ? -x : x;
}

// Nearest encoding by search among all, ties to the even one: slow on purpose, and nothing like the code
// under test.
// The values rise with the encodings, and the first beyond the last finite one would be 65536, which stands
// for infinity.  x must be exact.
std::uint16_t nearest_to(double x) {
  if (std::isnan(x)) return 0x7e00;
  const std::uint32_t sign = std::signbit(x) ? 0x8000 : 0;
  const double magnitude = std::fabs(x);
  if (magnitude >= 65536) return static_cast<std::uint16_t>(sign | 0x7c00);
  std::uint32_t below = 0, above = 0x7c00;  // value_of(0x7c00) is 65536 by the formula
  while (above - below > 1) {
    const std::uint32_t middle = (below + above) / 2;
    (value_of(middle) <= magnitude ? below : above) = middle;
  }
  const double down = magnitude - value_of(below), up = value_of(above) - magnitude;
  const bool upwards = up < down || (up == down && below % 2 == 1);
  return static_cast<std::uint16_t>(sign | (upwards ? above : below));
}

bool is_nan(std::uint32_t bits) { return (bits & 0x7fff) > 0x7c00; }

bool same_number(std::uint16_t a, std::uint16_t b) { return a == b || (is_nan(a) && is_nan(b)); }

TEST(Binary16, EveryEncodingSurvivesTheRoundTrip) {
  for (std::uint32_t bits = 0; bits < 65536; ++bits) {
    const Binary16 q = Binary16::from_bits(static_cast<std::uint16_t>(bits));
    const auto f = static_cast<float>(q);
    const auto d = static_cast<double>(q);
    ASSERT_EQ(Binary16(f).bits(), is_nan(bits) ? bits | 0x200 : bits);
    ASSERT_EQ(Binary16(d).bits(), is_nan(bits) ? bits | 0x200 : bits);
    ASSERT_EQ(std::isnan(f), is_nan(bits));
    if ((bits & 0x7fff) < 0x7c00) {
      ASSERT_EQ(d, value_of(bits));
      ASSERT_EQ(std::signbit(d), (bits & 0x8000) != 0);
    }
  }
  EXPECT_EQ(static_cast<float>(Binary16::from_bits(0x7c00)), infinity);
  EXPECT_EQ(static_cast<float>(Binary16::from_bits(0xfc00)), -infinity);
}

// Between any two neighbours: the midpoint goes to the even one, and the numbers right beside it to the
// nearer.
TEST(Binary16, RoundsToNearestEven) {
  for (std::uint32_t bits = 0; bits < 0x7c00; ++bits) {
    const double middle = (value_of(bits) + value_of(bits + 1)) / 2;
    const std::uint32_t even = bits + bits % 2;
    ASSERT_EQ(Binary16(middle).bits(), even);
    ASSERT_EQ(Binary16(static_cast<float>(middle)).bits(), even);
    ASSERT_EQ(Binary16(-middle).bits(), even | 0x8000);
    // One step of binary64 above a tie: rounding to binary32 on the way would lose it.
    ASSERT_EQ(Binary16(std::nextafter(middle, 1e9)).bits(), bits + 1);
    ASSERT_EQ(Binary16(std::nextafter(middle, 0.0)).bits(), bits);
  }
  EXPECT_EQ(Binary16(65519.999).bits(), 0x7bff);
  EXPECT_EQ(Binary16(65520.0).bits(), 0x7c00);
  EXPECT_EQ(Binary16(1e300).bits(), 0x7c00);
  EXPECT_EQ(Binary16(-1e300).bits(), 0xfc00);
  EXPECT_EQ(Binary16(1e-300).bits(), 0x0000);
  EXPECT_EQ(Binary16(-1e-300).bits(), 0x8000);
  EXPECT_EQ(Binary16(0x1p-25).bits(), 0x0000);
  EXPECT_EQ(Binary16(5e-324).bits(), 0x0000);
}

TEST(Binary16, ComesFromWholeNumbers) {
  for (std::uint32_t k = 0; k < 70'000; ++k) ASSERT_EQ(Binary16(k).bits(), nearest_to(k)) << k;
  EXPECT_EQ(Binary16(0xffffffffu).bits(), 0x7c00);
  EXPECT_EQ(Binary16(1).bits(), 0x3c00);
}

TEST(Binary16, TruncatesToWholeNumbers) {
  for (std::uint32_t bits = 0; bits < 0x7c00; ++bits)
    ASSERT_EQ(whole(Binary16::from_bits(static_cast<std::uint16_t>(bits))), std::floor(value_of(bits)));
  EXPECT_EQ(whole(Binary16(-3.5f)), 0u);
  EXPECT_EQ(whole(Binary16(nan_float)), 0u);
  EXPECT_EQ(whole(Binary16(infinity)), 0xffffffffu);
}

TEST(Binary16, ArithmeticAndOrderAgreeWithTheOracle) {
  std::mt19937 random(6);
  const auto check = [](std::uint16_t a, std::uint16_t b) {
    const Binary16 p = Binary16::from_bits(a), q = Binary16::from_bits(b);
    const bool finite = (a & 0x7fff) < 0x7c00 && (b & 0x7fff) < 0x7c00;
    // Exact in binary64; what infinities and NaN do there is what they do here.
    const double x = finite ? value_of(a) : static_cast<double>(p),
                 y = finite ? value_of(b) : static_cast<double>(q);
    return same_number((p + q).bits(), nearest_to(x + y)) && same_number((p - q).bits(), nearest_to(x - y)) &&
           same_number((p * q).bits(), nearest_to(x * y)) && (p == q) == (x == y) && (p < q) == (x < y) &&
           (p >= q) == (x >= y);
  };
  for (int k = 0; k < (sanitized ? 30'000 : 3'000'000); ++k) {
    const auto bits = static_cast<std::uint32_t>(random());
    const auto a = static_cast<std::uint16_t>(bits), b = static_cast<std::uint16_t>(bits >> 16);
    ASSERT_TRUE(check(a, b)) << std::hex << a << ' ' << b;
  }
  const std::array<std::uint16_t, 20> odd{0x0000, 0x8000, 0x0001, 0x8001, 0x03ff, 0x0400, 0x0401,
                                          0x3bff, 0x3c00, 0x3c01, 0x7bff, 0xfbff, 0x7c00, 0xfc00,
                                          0x7e00, 0xfe00, 0x7c01, 0x2800, 0x1400, 0x4900};
  for (const auto a : odd)
    for (std::uint32_t b = 0; b < 65536; b += sanitized ? 97 : 1)
      ASSERT_TRUE(check(a, static_cast<std::uint16_t>(b))) << std::hex << a << ' ' << b;
}

// The specification's text runs on it, and agrees with the exact numbers where nothing rounds.
TEST(Binary16, RunsTheSpecification) {
  for (std::uint32_t n = 0; n <= 5; ++n) {
    const std::uint32_t M = 4u << n;
    for (std::uint32_t i = 0; i <= M; ++i) {
      for (std::uint32_t j = 0; i + j <= M; ++j) {
        const spec::Point<Fixed64> p{Fixed64::dyadic(i, n + 2), Fixed64::dyadic(j, n + 2)};
        const spec::Point<Binary16> q{Binary16(static_cast<double>(i) / M),
                                      Binary16(static_cast<double>(j) / M)};
        ASSERT_EQ(spec::index::reference(q, n), spec::index::reference(p, n));
      }
    }
  }
}

}  // namespace impl_binary16_test
