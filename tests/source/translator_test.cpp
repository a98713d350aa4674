// [release] Random programs, compiled and run, beside the formulas that the translator makes of them: the same bits.
// MMVERIFY_FUZZ_SEEDS=N runs so many seeds in the place of one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <fstream>

#include "proofs/induction/prover.hpp"
#include "subjects/source/compile.hpp"
#include "subjects/source/encode/encode.hpp"
#include "tests/folder.hpp"
#include "tests/source/opened.hpp"
#include "tests/source/random_source.hpp"

namespace mmverify {
namespace {

using proofs::induction::Answer;
using proofs::induction::ask_words;
using source::Compiled;
using source::Exponents;
using tests::Opened;
using tests::some_float;

/// Exponents that hold x: its own alone, or some more.
Exponents around(float x, proofs::Random& random) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const unsigned field = bits >> 23 & 255;
  if (bits >> 31 != 0 || random.below(2) == 0) return {bits >> 31 != 0, field, field};
  const auto room = [&](unsigned most) { return static_cast<unsigned>(random.below(most + 1)); };
  const unsigned first = random.below(2) == 0 ? 0 : field - room(std::min(field, 5u));
  return {false, first, field + room(3)};
}

enum class Outcome { same, differs, undefined };

/// Whether the formula can have the value that the function gave on these bits, and no other.
Outcome compared(const source::Formula& formula, float u, float v, std::uint32_t got) {
  const auto script = [&](const char* relation) {
    std::string text = fmt::format(
        "(define-fun u () (_ BitVec 32) (_ bv{} 32))\n(define-fun v () (_ BitVec 32) (_ bv{} 32))\n{}",
        std::bit_cast<std::uint32_t>(u), std::bit_cast<std::uint32_t>(v), formula.declarations);
    text += "(declare-const wrong (_ BitVec 1))\n(assert\n";
    for (const auto& [name, meaning] : formula.definitions)
      text += fmt::format("(let (({} {}))\n", name, meaning);
    text += fmt::format("(and (= wrong (ite {} #b1 #b0)) (or {} ({} {} (_ bv{} 32))))", formula.undefined,
                        formula.undefined, relation, formula.index, got);
    return proofs::induction::Statement{"fuzz", Answer::sat,
                                        text + std::string(formula.definitions.size() + 1, ')')};
  };
  const auto found = ask_words(script("="));
  if (found.answer != Answer::sat) return Outcome::differs;
  if (const auto wrong = found.values.find("wrong"); wrong != found.values.end() && wrong->second == 1)
    return Outcome::undefined;
  // Another value is allowed where IEEE 754 and LLVM leave it open: a NaN's bits, which of 0 and -0 is less.
  if (formula.declarations.empty() && ask_words(script("distinct")).answer != Answer::unsat)
    return Outcome::differs;
  return Outcome::same;
}

struct Tried {
  unsigned same = 0, undefined = 0, differs = 0;
  std::string first;  ///< that differs
};

class Fuzzed {
 public:
  Fuzzed(std::uint64_t seed, unsigned functions, const std::string& name = "all")
      : seed_(seed), functions_(functions) {
    const std::string file = (folder_ / "random.c").string();
    std::ofstream(file) << tests::RandomSource(seed, functions).text();
    made_.emplace(file, name);
    run_.emplace(*made_);
  }

  /// `pairs` of each function; with a mistake until one differs.
  Tried tried(unsigned pairs, const std::string& fault = {},
              source::Mistake mistake = source::Mistake::none) const {
    Tried all;
    const bool planted = !fault.empty() || mistake != source::Mistake::none;
    for (unsigned k = 0; k < functions_; ++k) {
      const source::Program program = made_->at_level(k, fault);
      for (unsigned pair = 0; pair < pairs; ++pair) {
        proofs::Random random(seed_, k + 1, pair);
        const float u = some_float(random), v = some_float(random);
        const Exponents of_u = around(u, random), of_v = around(v, random);
        const std::uint32_t got = (*run_)(k, u, v);
        switch (compared(source::encode(program, of_u, of_v, "u", "v", mistake), u, v, got)) {
          case Outcome::same: ++all.same; break;
          case Outcome::undefined: ++all.undefined; break;
          case Outcome::differs:
            ++all.differs;
            if (all.first.empty())
              all.first = fmt::format("seed {} f{}({:a}, {:a}) = {}", seed_, k, u, v, got);
            if (planted) return all;
        }
      }
    }
    return all;
  }

 private:
  std::uint64_t seed_;
  unsigned functions_;
  tests::Folder folder_;
  std::optional<Compiled> made_;
  std::optional<Opened> run_;
};

class Translator : public testing::Test {
 protected:
  void SetUp() override {
    try {
      Compiled("no such file", "f");
    } catch (const source::NotAvailable& why) {
      GTEST_SKIP() << why.what();
    } catch (const source::BadSource&) {
    }
  }
};

constexpr unsigned functions = 16;

TEST_F(Translator, GivesTheBitsThatTheCompiledCodeGives) {
  const char* seeds = std::getenv("MMVERIFY_FUZZ_SEEDS");
  const unsigned long last = seeds != nullptr ? std::stoul(seeds) : 1;
  Tried all;
  for (unsigned long seed = 1; seed <= last; ++seed) {
    const Tried one = Fuzzed(seed, functions).tried(4);
    EXPECT_EQ(one.differs, 0u) << one.first;
    EXPECT_EQ(one.undefined, 0u) << "seed " << seed << ": what is right is said to be undefined";
    all.same += one.same;
    all.undefined += one.undefined;
  }
  fmt::print("{} pairs the same, {} undefined\n", all.same, all.undefined);
  EXPECT_GE(all.same, 3 * last * functions) << "too many programs are undefined: the sample says little";
}

TEST_F(Translator, NarrowResultsAreExtendedAsTheirTypesSay) {
  for (const char* type : tests::RandomSource::narrow) {
    const Tried one = Fuzzed(1, 2, std::string("all_") + type).tried(4);
    EXPECT_EQ(one.differs, 0u) << type << ": " << one.first;
    EXPECT_GE(one.same, 6u) << type;
  }
}

/// A mistake of the translator, and that the programs of some seed tell.
void expect_caught(const std::string& fault, source::Mistake mistake) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
    if (const Tried found = Fuzzed(seed, functions).tried(4, fault, mistake); found.differs != 0) {
      fmt::print("caught: {}\n", found.first);
      return;
    }
  FAIL() << "not caught on 8 seeds";
}

TEST_F(Translator, MistakesAreCaughtSwappedEdgesOfAPhi) {
  expect_caught("swapped-edges", source::Mistake::none);
}
TEST_F(Translator, MistakesAreCaughtSignedForUnsigned) {
  expect_caught("signed-compare", source::Mistake::none);
}
TEST_F(Translator, MistakesAreCaughtShiftByOneLess) {
  expect_caught("shift-by-one-less", source::Mistake::none);
}
TEST_F(Translator, MistakesAreCaughtWidenedWithSign) {
  expect_caught("widened-with-sign", source::Mistake::none);
}
TEST_F(Translator, MistakesAreCaughtLostWrap) { expect_caught("lost-wrap", source::Mistake::none); }
TEST_F(Translator, MistakesAreCaughtTiesAway) { expect_caught("", source::Mistake::ties_away); }
TEST_F(Translator, MistakesAreCaughtFloorTowardsZero) {
  expect_caught("", source::Mistake::floor_towards_zero);
}

}  // namespace
}  // namespace mmverify
