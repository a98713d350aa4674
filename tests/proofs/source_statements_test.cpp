// [release] The statements about somebody's function: their ranges hold every number of the domain, and they are about it.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <stdexcept>

#include "proofs/index/floats/published.hpp"
#include "proofs/index/laws/parts.hpp"
#include "proofs/index/source/statements.hpp"
#include "proofs/induction/prover.hpp"
#include "proofs/points/stiff_floats.hpp"

namespace mmverify::proofs::index::source {
namespace source_statements_test {

using induction::Answer;
using induction::ask_words;

bool holds(const Range& r, float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const unsigned field = bits >> 23 & 255;
  return r.negative == (bits >> 31 != 0) && r.first <= field && field <= r.last;
}

TEST(SourceStatements, AreAsManyAsTheClosedFormSays) {
  for (Level n = 0; n <= 16; ++n) EXPECT_EQ(pairs_of(n).size(), count_of_pairs(n)) << "level " << n;
}

TEST(SourceStatements, EveryPairOfTheDomainIsInOne) {
  // All powers of two, their neighbours, subnormal numbers and -0.
  std::vector<float> numbers{-0.0f, 0.0f, 0x1p-149f, 0x1p-148f, 1.0f};
  for (int e = -127; e < 0; ++e)
    for (const float next : {0.0f, 1.0f}) {
      numbers.push_back(std::ldexp(1.0f, e));
      numbers.push_back(std::nextafter(std::ldexp(1.0f, e), next));
    }
  for (const Level n : {0u, 5u, 16u}) {
    const std::vector<Pair> pairs = pairs_of(n);
    for (const float u : numbers)
      for (const float v : numbers) {
        if (static_cast<double>(u) + static_cast<double>(v) > 1 + 0x1p-23) continue;
        unsigned in = 0;
        for (const Pair& p : pairs) in += holds(p.u, u) && holds(p.v, v) ? 1 : 0;
        ASSERT_EQ(in, 1u) << "level " << n << ", u = " << u << ", v = " << v;
      }
  }
}

TEST(SourceStatements, NamedExponentsComeFirstAndNoneIsLost) {
  const std::vector<Pair> pairs = pairs_of(3, {110});
  EXPECT_EQ(pairs.size(), count_of_pairs(3));
  EXPECT_EQ(pairs.front().u, (Range{false, 110, 110}));
  EXPECT_EQ(pairs.front().v, (Range{false, 110, 110}));
}

TEST(SourceStatements, EachHasAPair) {
  for (const Level n : {0u, 9u, 16u})
    for (const Pair& pair : pairs_of(n))
      if (pair.u.first % 7 == 0 || pair.u.last == 127 || pair.u.negative) {
        ASSERT_EQ(ask_words(witness_of(n, pair)).answer, Answer::sat)
            << "level " << n << ": " << pair.u.first << ", " << pair.v.first;
      }
}

/// Whether the statement of that level holds where each function is this.
Answer said_of(const Formula& formula, Level n, const Pair& pair) {
  return ask_words(statement_of(n, pair, formula, Dialect::exact)).answer;
}

TEST(SourceStatements, AreProvedOfWhatIsRightAndNotOfWhatIsWrong) {
  const Pair small{{false, 0, 91}, {false, 0, 91}}, large{{false, 125, 125}, {false, 125, 125}};
  const Formula zero{"", {}, "(_ bv0 32)", "false", {}};
  EXPECT_EQ(said_of(zero, 9, small), Answer::unsat);
  EXPECT_EQ(said_of(zero, 9, large), Answer::sat);
  // Level 0 has one micro-triangle; one wrong pair is enough, and so is one that is undefined.
  EXPECT_EQ(said_of(zero, 0, large), Answer::unsat);
  const Formula once{"",
                     {{"hit", "(and (= u #x3e9a3c5e) (= v #x3e92468a))"}},
                     "(ite hit (_ bv1 32) (_ bv0 32))",
                     "false",
                     {}};
  const auto found = ask_words(statement_of(0, large, once, Dialect::exact));
  ASSERT_EQ(found.answer, Answer::sat);
  EXPECT_EQ(found.values.at("u_fraction"), 0x3e9a3c5eu & 0x7fffff);
  EXPECT_EQ(found.values.at("v_fraction"), 0x3e92468au & 0x7fffff);
  EXPECT_EQ(found.values.at(claimed_index), 1u);
  const Formula never{"", {{"hit", "(= u #x3e9a3c5e)"}}, "(_ bv0 32)", "hit", {{"hit", "a shift too far"}}};
  const auto undefined = ask_words(statement_of(0, large, never, Dialect::exact));
  ASSERT_EQ(undefined.answer, Answer::sat);
  EXPECT_EQ(undefined.values.at(claimed_undefined), 1u);
  EXPECT_EQ(undefined.values.at(claimed_cause(0)), 1u);
}

/// The pair of ranges that holds two numbers.
Pair ranges_of(Level n, float u, float v) {
  for (const Pair& p : pairs_of(n))
    if (holds(p.u, u) && holds(p.v, v)) return p;
  throw std::logic_error("no ranges");
}

/// Whether the statement of a dialect about one pair of numbers holds of a function that gives `index` there.
Answer said_there(Dialect dialect, Level n, float u, float v, std::uint32_t index) {
  const Formula constant{"", {}, fmt::format("(_ bv{} 32)", index), "false", {}};
  const Bits at{std::bit_cast<std::uint32_t>(u), std::bit_cast<std::uint32_t>(v)};
  return ask_words(statement_of(n, ranges_of(n, u, v), constant, dialect, at)).answer;
}

TEST(SourceStatements, OfTheDialectsAreTheirCodes) {
  int apart = 0;
  const auto judge = [&](Level n, float u, float v) {
    const std::uint32_t code = published(n, u, v),
                        exact = spec::index::reference(RationalPoint{rational(u), rational(v)}, n);
    apart += code != exact ? 1 : 0;
    const auto at = fmt::format("level {} {:a} {:a}", n, u, v);
    EXPECT_EQ(said_there(Dialect::published, n, u, v, code), Answer::unsat) << at;
    EXPECT_EQ(said_there(Dialect::published, n, u, v, exact), code == exact ? Answer::unsat : Answer::sat)
        << at;
    EXPECT_EQ(said_there(Dialect::exact, n, u, v, exact), Answer::unsat) << at;
  };
  // The sum of fractions rounds up to 1, and is 2^-25, then 2^-24, below it.
  judge(1, 0x1p-26f, 0x1.fffffep-2f);
  judge(1, 0x1.fffffep-27f, 0x1.fffffep-2f);
  judge(1, 0.25f, 0x1.fffffep-3f);
  for (std::uint64_t k = 0; k < 40; ++k) {
    const Level n = static_cast<Level>(k % 17);
    const FloatPair pair = stiff_floats(n, 1, 17 * k);
    if (double{pair.u} + double{pair.v} <= 1 + 0x1p-23) judge(n, pair.u, pair.v);
  }
  EXPECT_GT(apart, 0);
}

}  // namespace source_statements_test
}  // namespace mmverify::proofs::index::source
