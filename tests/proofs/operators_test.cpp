// [release] The operators that write formulas against the machine's: on numbers the prover must give what C++ computes.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "proofs/induction/floating.hpp"
#include "proofs/induction/paths.hpp"
#include "proofs/induction/prover.hpp"
#include "proofs/induction/statement.hpp"
#include "proofs/induction/symbolic.hpp"

namespace operators_test {

using namespace mmverify::proofs::induction;

/// Claims about numbers, put to the prover at once: `unsat` where all hold.
class Claims {
 public:
  void same(const Term& a, const Term& b) { all_.push_back(equal(a, b)); }
  /// A comparison of the subject's, as the formula that it decides on.
  template <class Compare>
  void decides(Compare compare, bool answer) {
    const Term formula =
        as_formula(every_path(compare), [](bool yes) { return Term(yes ? "true" : "false", boolean); });
    all_.push_back(answer ? formula : no(formula));
  }
  Answer asked() const {
    Script script("operators", Answer::unsat, "an operator on numbers");
    const ProverAnswer found = ask_z3(script.denying(all_));
    if (found.answer == Answer::unknown) ADD_FAILURE() << found.detail;
    return found.answer;
  }

 private:
  std::vector<Term> all_;
};

/// Edges of the words, and words of every length.
template <class W>
std::vector<W> words() {
  std::vector<W> all{0,          1, 2, 3, static_cast<W>(~W{0}), static_cast<W>(W{1} << (8 * sizeof(W) - 1)),
                     0x55555555u};
  std::mt19937_64 random(7);
  for (unsigned k = 0; k < 24; ++k) all.push_back(static_cast<W>(random() >> (random() % 64)));
  return all;
}

template <class W>
Claims claims_of_words() {
  constexpr unsigned bits = 8 * sizeof(W);
  using Name = Word<bits>;
  Claims claims;
  const auto is = [&](const Name& got, W right) { claims.same(got.term, Name(right).term); };
  for (const W a : words<W>())
    for (const W b : words<W>()) {
      const Name x(a), y(b);
      is(x + y, static_cast<W>(a + b));
      is(x - y, static_cast<W>(a - b));
      if (b != 0) is(x / y, static_cast<W>(a / b));
      is(x & y, a & b);
      is(x | y, a | b);
      is(x ^ y, a ^ b);
      is(~x, static_cast<W>(~a));
      const auto k = static_cast<unsigned>(b % bits);
      is(x << k, static_cast<W>(a << k));
      is(x >> k, static_cast<W>(a >> k));
      claims.decides([&] { return x < y; }, a < b);
    }
  return claims;
}

TEST(Operators, of_words_of_32_bits) { EXPECT_EQ(claims_of_words<std::uint32_t>().asked(), Answer::unsat); }
TEST(Operators, of_words_of_64_bits) { EXPECT_EQ(claims_of_words<std::uint64_t>().asked(), Answer::unsat); }

TEST(Operators, that_make_words_longer_and_shorter) {
  Claims claims;
  for (const std::uint64_t a : words<std::uint64_t>()) {
    claims.same(Word<32>(Word<64>(a)).term, Word<32>(static_cast<std::uint32_t>(a)).term);
    claims.same(Word<64>(Word<32>(static_cast<std::uint32_t>(a))).term,
                Word<64>(static_cast<std::uint32_t>(a)).term);
  }
  EXPECT_EQ(claims.asked(), Answer::unsat);
}

TEST(Operators, of_whole_numbers) {
  Claims claims;
  const auto is = [&](const Integer& got, long long right) { claims.same(got.term, whole_number(right)); };
  std::mt19937_64 random(8);
  for (unsigned k = 0; k < 400; ++k) {
    const auto number = [&] { return static_cast<long long>(random() >> (34 + random() % 30)) - 5; };
    const long long a = number(), b = number();
    const Integer x(a), y(b);
    is(x + y, a + b);
    is(x - y, a - b);
    is(x * y, a * b);
    // Rounded down, which C++ does of numbers from 0 on.
    if (b > 0) is(x / y, a >= 0 ? a / b : -((-a + b - 1) / b));
    is(~x, ~a);
    claims.decides([&] { return x < y; }, a < b);
    claims.decides([&] { return x > y; }, a > b);
  }
  EXPECT_EQ(claims.asked(), Answer::unsat);
}

/// Numbers with few digits, so that binary64 has every result.
TEST(Operators, of_real_numbers_and_bits) {
  Claims claims;
  using Number = Real<UnitOne>;
  const auto written = [](int eighths) {
    return Number(apply("/", {to_real(whole_number(eighths)), to_real(whole_number(8))}, real));
  };
  for (int a = -20; a <= 20; a += 3)
    for (int b = -17; b <= 21; b += 2) {
      const Number x = written(a), y = written(b);
      claims.same((x + y).term, written(a + b).term);
      claims.same((x - y).term, written(a - b).term);
      claims.same(times(5, x).term, written(5 * a).term);
      claims.same(whole(x).term, whole_number(static_cast<long long>(std::floor(a / 8.0))));
      claims.decides([&] { return x < y; }, a < b);
      claims.decides([&] { return x == y; }, a == b);
    }
  claims.same(Number(7u).term, written(56).term);
  for (const bool a : {false, true})
    for (const bool b : {false, true}) {
      const auto bit = [](bool x) { return Bit(Term(x ? "true" : "false", boolean)); };
      claims.same((bit(a) ^ bit(b)).term, bit(a != b).term);
      claims.same((bit(a) & bit(b)).term, bit(a && b).term);
      claims.same((bit(a) | bit(b)).term, bit(a || b).term);
      claims.same((~bit(a)).term, bit(!a).term);
    }
  EXPECT_EQ(claims.asked(), Answer::unsat);
}

/// Zeros, subnormal numbers, ends and ones nearby, infinities, NaN, and any.
std::vector<float> floats() {
  using Limits = std::numeric_limits<float>;
  std::vector<float> all{0.0f,
                         -0.0f,
                         1.0f,
                         0.5f,
                         std::nextafter(1.0f, 0.0f),
                         std::nextafter(0.5f, 1.0f),
                         Limits::denorm_min(),
                         Limits::min(),
                         std::nextafter(Limits::min(), 0.0f),
                         Limits::max(),
                         Limits::infinity(),
                         -Limits::infinity(),
                         Limits::quiet_NaN(),
                         -3.75f,
                         65536.0f};
  std::mt19937_64 random(9);
  for (unsigned k = 0; k < 14; ++k) all.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
  for (unsigned k = 0; k < 6; ++k) all.push_back(std::ldexp(static_cast<float>(random() % 16777216), -24));
  return all;
}

TEST(Operators, of_binary32) {
  Claims claims;
  // Equal as numbers of the sort: every NaN is one, and -0 is not 0.
  const auto is = [&](const Binary32& got, float right) { claims.same(got.term, Binary32(right).term); };
  for (const float a : floats())
    for (const float b : floats()) {
      const Binary32 x(a), y(b);
      is(x + y, a + b);
      is(x - y, a - b);
      is(x * y, a * b);
      claims.decides([&] { return x < y; }, a < b);
      claims.decides([&] { return x > y; }, a > b);
      claims.decides([&] { return x <= y; }, a <= b);
      claims.decides([&] { return x >= y; }, a >= b);
    }
  EXPECT_EQ(claims.asked(), Answer::unsat);
}

TEST(Operators, between_binary32_and_signed_words) {
  Claims claims;
  const auto word = [](std::int32_t k) { return SignedWord(Word<32>(static_cast<std::uint32_t>(k)).term); };
  for (const float a : floats()) {
    if (!(std::fabs(a) < 0x1p31f)) continue;  // C++ and SMT-LIB leave it open
    claims.same(static_cast<SignedWord>(Binary32(a)).term, word(static_cast<std::int32_t>(a)).term);
  }
  for (const std::uint32_t a : words<std::uint32_t>()) {
    const auto k = static_cast<std::int32_t>(a);
    claims.same(Binary32(word(k)).term, Binary32(static_cast<float>(k)).term);
  }
  EXPECT_EQ(claims.asked(), Answer::unsat);
}

TEST(Operators, that_are_others_are_seen) {
  const Word<32> a(7), b(9);
  Claims sum, order, rounding;
  sum.same((a + b).term, Word<32>(17).term);
  EXPECT_EQ(sum.asked(), Answer::sat);
  order.decides([&] { return a < b; }, false);
  EXPECT_EQ(order.asked(), Answer::sat);
  // 1 + 2^-24 lies between 1 and the next float, and goes to the even one.
  rounding.same((Binary32(1.0f) + Binary32(0x1p-24f)).term, Binary32(std::nextafter(1.0f, 2.0f)).term);
  EXPECT_EQ(rounding.asked(), Answer::sat);
}

}  // namespace operators_test
