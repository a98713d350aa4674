// [release] The report on a refuted baker: the properties of a case that separate wrong answers from right ones, with
// ties apart, and their order.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "proofs/bake/diagnosis/diagnosis.hpp"
#include "proofs/bake/truth/offender.hpp"
#include "proofs/engine/runner.hpp"
#include "proofs/registry/registry.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::proofs::bake {
namespace bake_diagnosis_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// This project's baker, asked for another case than the one that is meant.
BakeSubject mistaken(const char* name, const std::function<void(Case&)>& mistake) {
  Functions functions = built_in("bake")->functions;
  functions.bake = [mistake, real = functions.bake](const Case& one, Level n, Format format) {
    Case other = one;
    mistake(other);
    return real(other, n, format);
  };
  return BakeSubject(name, "wrong on purpose", functions, name);
}

/// It makes a known mistake throughout.
BakeSubject mistaken(const KnownMistake& known) {
  BakeSubject s = mistaken(known.as_if, known.mistake);
  Functions functions = s.functions;
  functions.bake = [known, real = s.functions.bake](const Case& one, Level n, Format format) {
    auto baked = real(one, n, format);
    if (baked)
      for (State& state : baked->states) state = known.states[static_cast<std::size_t>(state)];
    return baked;
  };
  return BakeSubject(known.as_if, "wrong on purpose", functions, known.as_if);
}

/// Its states in another order.
BakeSubject reordered(const char* name, std::uint32_t (*place)(std::uint32_t index, Level n)) {
  Functions functions = built_in("bake")->functions;
  functions.bake = [place, real = functions.bake](const Case& one, Level n, Format format) {
    auto baked = real(one, n, format);
    const std::vector<State> right = baked.value().states;
    for (std::uint32_t k = 0; k < right.size(); ++k) baked->states[place(k, n)] = right[k];
    return baked;
  };
  return BakeSubject(name, "wrong on purpose", functions, name);
}

// None of the cases that a cause is looked for in is wrong: the law met another one.
TEST(BakeDiagnosis, SaysThatAFaultIsRare) {
  const BakeSubject s = mistaken("right where it is asked", [](Case&) {});
  for (const Fault fault : {Fault::conservative, Fault::tight}) {
    const auto lines = diagnose(s, fault);
    ASSERT_FALSE(lines.empty());
    EXPECT_THAT(lines.front(), HasSubstr("a rare fault: none of "));
    EXPECT_THAT(lines, Not(Contains(HasSubstr("0 have a state"))));
  }
}

TEST(BakeDiagnosis, NamesTheFilterThatIsWrong) {
  const BakeSubject s = mistaken("nearest is bilinear", [](Case& c) { c.filter = Filter::bilinear; });
  EXPECT_THAT(diagnose(s, Fault::conservative),
              Contains(AllOf(HasSubstr("filter: wrong where it is nearest ("),
                             HasSubstr("all right where it is bilinear"))));
}

TEST(BakeDiagnosis, NamesAnAddressingModeOfOneAxis) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const BakeSubject s = mistaken("v is never mirrored", [](Case& c) {
    if (c.wrap_v == Wrap::mirrored_repeat) c.wrap_v = Wrap::repeat;
  });
  const auto lines = diagnose(s, Fault::conservative);
  EXPECT_THAT(lines, Contains(AllOf(HasSubstr("addressing of v: wrong where it is mirror ("),
                                    HasSubstr("all right where it is"))));
  EXPECT_THAT(lines, Not(Contains(HasSubstr("addressing of u"))));
}

TEST(BakeDiagnosis, NamesSignsSizesAndTriangles) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const BakeSubject below = mistaken("below 0 is 0", [](Case& c) {
    for (std::size_t k = 0; k < 6; k += 2) c.uv[k] = std::max(c.uv[k], 0.0f);
  });
  EXPECT_THAT(diagnose(below, Fault::conservative), Contains(HasSubstr("u: wrong where it is below 0")));
  const BakeSubject clockwise = mistaken("clockwise ones are turned", [](Case& c) {
    for (const Property& p : properties_of(c, 0))
      if (p.value == "clockwise") std::swap(c.uv[2], c.uv[4]), std::swap(c.uv[3], c.uv[5]);
  });
  EXPECT_THAT(diagnose(clockwise, Fault::conservative),
              Contains(HasSubstr("triangle: wrong where it is clockwise (")));
}

// Each known mistake is recognised; some are the same one on what is drawn, and so the first of them is named.
TEST(BakeDiagnosis, NamesAMistakeMadeThroughout) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  for (const KnownMistake& known : known_mistakes()) {
    const BakeSubject s = mistaken(known);
    // MASK baked as BLEND has too many unknown states, and none that is wrong.
    const Fault fault =
        std::string(known.as_if) == "alpha mode MASK were BLEND" ? Fault::tight : Fault::conservative;
    EXPECT_THAT(diagnose(s, fault), Contains(HasSubstr(std::string("wrong maps are as if ") + known.as_if)))
        << testing::PrintToString(diagnose(s, fault));
  }
  const BakeSubject random = mistaken("nothing known", [](Case& c) { c.uv[0] += 0.3f; });
  EXPECT_THAT(diagnose(random, Fault::conservative), Not(Contains(HasSubstr("as if"))));
}

TEST(BakeDiagnosis, CountsTiesApart) {
  const auto lines = diagnose(mistaken("a hair more than the cutoff",
                                       [](Case& c) {
                                         c.cutoff.numerator = c.cutoff.numerator * 10'000 + 1;
                                         c.cutoff.denominator *= 10'000;
                                       }),
                              Fault::tight);
  EXPECT_THAT(lines.front(), HasSubstr("are wrong"));
  Case met;  // alpha rises from 0 to 1 and meets the cutoff on the triangle's edge alone
  met.width = 2;
  met.alpha = {0, 255};
  met.wrap_u = met.wrap_v = Wrap::clamp_to_edge;
  met.uv = {0.25f, 0, 0.5f, 0, 0.5f, 1};
  EXPECT_TRUE(is_tie(met, 0, 0, State::T));
  EXPECT_FALSE(is_tie(met, 0, 0, State::O));
  EXPECT_EQ(wrong_share(met, 0, 0, State::T, 0), 0);
  EXPECT_EQ(wrong_share(met, 0, 0, State::O, 0), 1);
  met.uv = {0, 0, 1, 0, 0, 1};  // opaque right of u = 1/2: a fourth of the triangle
  EXPECT_NEAR(wrong_share(met, 0, 0, State::T, 0), 0.25, 0.03);
}

// The smallest children 2 and 3 are exchanged.
TEST(BakeDiagnosis, NamesTheOrder) {
  EXPECT_EQ(order_of(*built_in("bake"), 3), "");
  const auto exchanged = [](std::uint32_t index, Level n) {
    return n > 0 && index % 4 > 1 ? index ^ 1 : index;
  };
  const BakeSubject s = reordered("children exchanged", exchanged);
  EXPECT_EQ(order_of(s, 3), "the curve, but children 2 and 3 change places from digit 3 on");
  EXPECT_THAT(
      diagnose(s, Fault::conservative),
      Contains(HasSubstr("the order of its micro-triangles at level 3: the curve, but children 2 and 3")));
}

TEST(BakeDiagnosis, SaysNothingOfABakerThatBakesNothing) {
  Functions none = built_in("bake")->functions;
  none.bake = [](const Case&, Level, Format) { return std::optional<Baked>(); };
  EXPECT_EQ(order_of(BakeSubject("none", "declines all", none), 2), "");
}

// An answer that is wrong on an area is shown before a tie, even a tie of a lower number.
TEST(BakeDiagnosis, ProperErrorsAreShownBeforeTies) {
  const proofs::Run run;
  const Law* law = laws_named("bake.conservative").front();
  const auto shown = [&](const std::function<void(Case&)>& mistake) {
    return run_level(*law, mistaken("both", mistake), 1, run).counterexamples.at(0).expected;
  };
  const auto below = [](Case& c) { c.cutoff = {c.cutoff.numerator * 2 - 1, c.cutoff.denominator * 2}; };
  EXPECT_THAT(shown(below), HasSubstr("of its area"));
  EXPECT_THAT(shown(below), HasSubstr("below the cutoff"));
}

}  // namespace bake_diagnosis_test
}  // namespace mmverify::proofs::bake
