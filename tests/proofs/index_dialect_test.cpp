// [release] Dialects of binary32 code: the published code, and which laws a run in a dialect has.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "proofs/index/children_inside.hpp"
#include "proofs/index/diagnosis.hpp"
#include "proofs/index/floats/published.hpp"
#include "proofs/index/judges/judges.hpp"
#include "proofs/index/judges/on_cells.hpp"
#include "proofs/index/laws.hpp"
#include "proofs/index/subject.hpp"
#include "proofs/index/ties.hpp"
#include "proofs/planning/plan.hpp"
#include "proofs/points/stiff_floats.hpp"
#include "proofs/registry/registry.hpp"
#include "spec/index/index.hpp"
#include "tests/sanitized.hpp"

namespace mmverify::proofs {
namespace index_dialect_test {

using testing::Contains;
using testing::Not;

TEST(Published, IsTheSpecificationsFormulaInBinary32) {
  for (Level n = 0; n <= 16; ++n)
    for (std::uint64_t k = 0; k < (sanitized ? 2'000 : 50'000); ++k) {
      const points::FloatPair p = points::stiff_floats(n, 9, k);
      ASSERT_EQ(index::published(n, p.u, p.v), spec::index::reference(spec::Point<float>{p.u, p.v}, n))
          << n << " " << p.u << " " << p.v;
    }
}

// At level 1, u = 2^-26 and v an ulp below 1/2: uN + vN = 2^-25 + 1 - 2^-24 is below 1, so the point lies in the
// w-corner's triangle, 0. Binary32 has no number between 1 - 2^-24 and 1, and rounds the sum to 1: the middle one, 1.
TEST(Published, ErrsWhereASumRoundsUp) {
  const float u = 0x1p-26f, v = 0x1.fffffep-2f;
  EXPECT_EQ(index::published(1, u, v), 1u);
  EXPECT_EQ(spec::index::reference(spec::Point<double>{static_cast<double>(u), static_cast<double>(v)}, 1),
            0u);
}

TEST(Published, KeepsToTheTriangle) {
  EXPECT_EQ(index::published(2, 0, 0), 0u);
  EXPECT_EQ(index::published(2, 0, 1), 15u);
  EXPECT_EQ(index::published(2, 2, -1), index::published(2, 1, 0));
  EXPECT_EQ(index::published(0, 0.3f, 0.3f), 0u);
}

std::vector<std::string> planned(const std::vector<std::string>& names, const std::string& subject,
                                 const std::string& dialect, bool companions = true) {
  Request request;
  for (const std::string& name : names)
    for (const Law* law : laws_named(name)) request.laws.push_back(law);
  request.by_id = names;
  request.dialect = dialect;
  request.companions = companions;
  request.subjects = {find_subject(subject)};
  std::vector<std::string> ids;
  for (const Job& job : plan(request))
    if (job.unfit.empty()) ids.push_back(job.law->id);
  return ids;
}

TEST(Dialects, EachHasItsLawOfFloats) {
  const std::vector<std::pair<std::string, std::string>> laws{{"exact", "index.exact_on_floats"},
                                                              {"published", "index.equals_published"},
                                                              {"either", "index.exact_or_published"}};
  for (const auto& [dialect, id] : laws)
    for (const auto& names : {std::vector<std::string>{"index"}, {}, {"index.equals_reference"}}) {
      const auto ids = planned(names, "reference-f32", dialect);
      for (const auto& [other, law] : laws) {
        if (other == dialect)
          EXPECT_THAT(ids, Contains(law).Times(1)) << dialect;
        else
          EXPECT_THAT(ids, Not(Contains(law))) << dialect;
      }
    }
}

TEST(Dialects, ALawThatIsNamedIsRun) {
  EXPECT_THAT(planned({"index.exact_on_floats"}, "reference-f32", "either"),
              Contains("index.exact_on_floats"));
  EXPECT_THAT(planned({"index.equals_published"}, "reference-f32", "exact"),
              Contains("index.equals_published"));
}

TEST(Dialects, WhatIsNoBinary32CodeIsHeldToExactArithmetic) {
  for (const char* subject : {"impl", "reference-f64", "reference-f16"}) {
    const auto ids = planned({"index"}, subject, "either");
    EXPECT_THAT(ids, Contains("index.exact_on_floats")) << subject;
    EXPECT_THAT(ids, Not(Contains("index.exact_or_published"))) << subject;
  }
}

TEST(Dialects, OneLawIsOneLawWhereCompanionsAreLeftOut) {
  EXPECT_EQ(planned({"index.in_range"}, "reference-f32", "either", false),
            std::vector<std::string>{"index.in_range"});
  EXPECT_EQ(planned({"index.in_range"}, "reference-f32", "either").size(), 2u);
}

TEST(Dialects, WhatNeitherSaysIsRefuted) {
  const Law& either = *find_law("index.exact_or_published");
  const auto verdict = [&](const char* subject, const Law& law) {
    return run_level(law, *find_subject(subject), 4, proofs::Run()).verdict;
  };
  EXPECT_EQ(verdict("reference-f32", either), Verdict::checked);
  EXPECT_EQ(verdict("reference-f32", *find_law("index.exact_on_floats")), Verdict::refuted);
  EXPECT_EQ(verdict("step-f32", either), Verdict::refuted);
  EXPECT_EQ(verdict("step-f32", *find_law("index.equals_published")), Verdict::refuted);
}

// Level 1: triangle 0 lies at the w-corner, 1 is the middle one; both touch (1/4, 1/4).
TEST(Near, ANeighbourIsReachedOverItsEdgeAlone) {
  const auto reached = [](const char* point, std::uint32_t index, std::uint32_t ulps,
                          index::Arithmetic arithmetic = index::Arithmetic::binary32) {
    return index::reaches(points::parse_point(point), 1, index, arithmetic, ulps);
  };
  for (const std::uint32_t index : {0u, 1u}) {
    EXPECT_TRUE(reached("u=1/4,v=1/4", index, 1));
    EXPECT_TRUE(reached("u=1/4,v=1/4", index, 1, index::Arithmetic::exact));
  }
  for (const std::uint32_t index : {2u, 3u}) EXPECT_FALSE(reached("u=1/4,v=1/4", index, 1000)) << index;
  // An ulp of u = 1/4 is 2^-25, of v below it 2^-26: K of each add up to 3/2 K of the former.
  const char* five_below = "u=0x1p-2,v=0x1.ffffecp-3";  // 1/4 - 5 * 2^-25
  EXPECT_TRUE(reached(five_below, 0, 0));
  EXPECT_FALSE(reached(five_below, 1, 3));
  EXPECT_TRUE(reached(five_below, 1, 4));
  EXPECT_FALSE(reached("u=1/4,v=1/4", 4, 1));
}

TEST(Near, EveryTieIsAllowedAndNothingElse) {
  const Law& law = *find_law("index.equals_reference");
  proofs::Run near;
  near.near = 1;
  // Wrong on ties alone, and wrong inside.
  const Result ties = run_level(law, *find_subject("step-appendix-ties"), 4, near);
  EXPECT_EQ(ties.verdict, Verdict::checked);
  EXPECT_EQ(ties.allowed(), 53u);  // docs/ERRATA.md: 9 vertices and 44 edges
  const Result inside = run_level(law, *find_subject("step-appendix-middle"), 4, near);
  EXPECT_EQ(inside.verdict, Verdict::refuted);
  EXPECT_EQ(run_level(law, *find_subject("step"), 4, near).verdict, Verdict::proved);
}

TEST(Near, BothRoundedAlgorithmsMissByUlpsAlone) {
  const Law& law = *find_law("index.exact_on_floats");
  for (const char* subject : {"reference-f32", "step-f32"}) {
    proofs::Run near;
    EXPECT_EQ(run_level(law, *find_subject(subject), 4, near).verdict, Verdict::refuted) << subject;
    near.near = 4;
    const Result r = run_level(law, *find_subject(subject), 4, near);
    EXPECT_EQ(r.verdict, Verdict::checked) << subject;
    EXPECT_GT(r.allowed(), 0u) << subject;
  }
}

TEST(Allowed, IsCountedWhereThePublishedCodeIsNotExact) {
  const Result r =
      run_level(*find_law("index.exact_or_published"), *find_subject("reference-f32"), 4, proofs::Run());
  const Result exact =
      run_level(*find_law("index.exact_on_floats"), *find_subject("reference-f32"), 4, proofs::Run());
  EXPECT_EQ(r.allowed(), exact.mismatches());
  EXPECT_GT(r.allowed(), 0u);
  EXPECT_EQ(r.dialect, "either");
  EXPECT_EQ(exact.dialect, "exact");
}

// At level 1, rows along v from u = 0 on: (0, 0), its upper half, (0, 1), and last the row of u = 1.
TEST(Orders, UMajorIsKnown) {
  const auto u_major = [](Level n) {
    return [n](const points::MicroTriangle& m) {
      return 2 * (1u << n) * m.i - m.i * m.i + 2 * m.j + (m.inverted ? 1 : 0);
    };
  };
  EXPECT_EQ(u_major(1)({0, 0, false}), 0u);
  EXPECT_EQ(u_major(1)({0, 0, true}), 1u);
  EXPECT_EQ(u_major(1)({0, 1, false}), 2u);
  EXPECT_EQ(u_major(1)({1, 0, false}), 3u);
  EXPECT_EQ(index::name_order(3, u_major(3)), "U-major, rows from the edge u = 0 on, not the curve");
}

/// The curve's index of points that are moved a little, as if a tie belonged to the other side.
index::IndexSubject moved(const std::function<points::GridPoint(points::GridPoint, Level)>& move) {
  index::Functions functions;
  functions.index = [move](Level n, index::Batch batch, std::span<std::uint32_t> out) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = spec::index::reference(move(batch.points[k], n), n);
  };
  functions.receive = [](std::span<points::GridPoint>) {};
  return index::IndexSubject("moved", "wrong on purpose", functions, "moved");
}

TEST(IndexDiagnosis, NamesTheRuleOfWrongTies) {
  using points::Fixed64;
  using points::GridPoint;
  constexpr Level level = 4;
  const Fixed64 little = Fixed64::dyadic(1, 12);
  const auto square_of = [](Fixed64 x, Level n) { return whole(times(points::side(n), x)); };
  const auto down_within_the_square = [&](GridPoint p, Level n) {
    const GridPoint q{p.u - little, p.v - little};
    return square_of(q.u, n) == square_of(p.u, n) && square_of(q.v, n) == square_of(p.v, n) ? q : p;
  };
  EXPECT_EQ(index::rule_of_ties(moved(down_within_the_square), level),
            "the rule: where uf + vf = 1 the upper micro-triangle owns the point, so test uf + vf >= 1");
  const auto to_lesser_u = [&](GridPoint p, Level) {
    return p.u < little ? p : GridPoint{p.u - little, p.v + little};
  };
  EXPECT_EQ(index::rule_of_ties(moved(to_lesser_u), level),
            "the rule: where uf = 0 the square of the greater u owns it, so take the floor of 2^n u");
  const auto to_lesser_v = [&](GridPoint p, Level) {
    return p.v < little ? p : GridPoint{p.u + little, p.v - little};
  };
  EXPECT_EQ(index::rule_of_ties(moved(to_lesser_v), level),
            "the rule: where vf = 0 the square of the greater v owns it, so take the floor of 2^n v");
  const auto away_from_the_edge = [&](GridPoint p, Level) {
    return p.u + p.v == Fixed64(1) && little < p.u && little < p.v ? GridPoint{Fixed64(0), Fixed64(0)} : p;
  };
  EXPECT_EQ(
      index::rule_of_ties(moved(away_from_the_edge), level),
      "the rule: on the edge u + v = 1 no upper micro-triangle is left, so the lower one owns the point");
  EXPECT_EQ(index::rule_of_ties(moved([](GridPoint p, Level) { return p; }), level), "");
}

/// The name of an order that turns index k of the curve's level 3 into that of `of(k)`.
std::string name_of_order(const std::function<std::uint32_t(std::uint32_t)>& of) {
  std::vector<index::Renumbered> all;
  for (std::uint32_t k = 0; k < 64; ++k) all.push_back({k, of(k)});
  return index::name_children_inside(3, all);
}

TEST(ChildrenInside, AreNamedByTheChildThatHoldsThem) {
  // All digits behind the first 1 are reversed.
  const auto reversed = [](std::uint32_t k) {
    if (k >> 4 == 1) return k ^ 15;
    return (k >> 2 & 3) == 1 ? k ^ 3 : k;
  };
  EXPECT_EQ(name_of_order(reversed),
            "children 0, 1, 2, 3 are numbered 3, 2, 1, 0 inside each child 1, the middle triangle");
  // Directly inside a child 2 alone, and inside one or three of them.
  const auto swapped = [](std::uint32_t digit) { return digit == 0 ? 3 : digit == 3 ? 0 : digit; };
  const auto directly = [&](std::uint32_t k) {
    const std::uint32_t a = k >> 4, b = k >> 2 & 3, c = k & 3;
    return a << 4 | (a == 2 ? swapped(b) : b) << 2 | (b == 2 ? swapped(c) : c);
  };
  EXPECT_EQ(name_of_order(directly), "children 0 and 3 change places directly inside each child 2");
  const auto odd = [&](std::uint32_t k) {
    const std::uint32_t a = k >> 4, b = k >> 2 & 3, c = k & 3;
    return a << 4 | (a == 2 ? swapped(b) : b) << 2 | ((a == 2) != (b == 2) ? swapped(c) : c);
  };
  EXPECT_EQ(name_of_order(odd), "children 0 and 3 change places inside an odd number of children 2");
}

TEST(ChildrenInside, OthersHaveNoName) {
  EXPECT_EQ(name_of_order([](std::uint32_t k) { return k; }), "");
  EXPECT_EQ(name_of_order([](std::uint32_t k) { return k == 20   ? 21
                                                       : k == 21 ? 20
                                                                 : k; }),
            "");                                                                        // one node alone
  EXPECT_EQ(name_of_order([](std::uint32_t k) { return k >> 4 == 1 ? 20u : k; }), "");  // no permutation
  EXPECT_EQ(name_of_order([](std::uint32_t k) { return k + 1; }), "");                  // out of range
}

// A device API states the corners so: a base at (iu, iv), or at (iu + 1, iv + 1) where inverted, and a step of 1 or -1
// from there.
TEST(CornerOrders, BaseAndSteps) {
  for (std::uint32_t k = 0; k < 64; ++k) {
    const index::Corners c = index::corners_in(index::CornerOrder::base_u_v, k, 3);
    const auto step = static_cast<std::int64_t>(c[1].i) - static_cast<std::int64_t>(c[0].i);
    EXPECT_EQ(step * step, 1) << k;
    EXPECT_EQ(c[1].j, c[0].j) << k;
    EXPECT_EQ(c[2].i, c[0].i) << k;
    EXPECT_EQ(static_cast<std::int64_t>(c[2].j) - static_cast<std::int64_t>(c[0].j), step) << k;
    EXPECT_EQ(index::sorted(c), index::sorted(spec::index::corners(k, 3))) << k;
  }
  EXPECT_EQ(index::name_corner_order(
                *std::dynamic_pointer_cast<const index::IndexSubject>(find_subject("impl")), 3),
            "children 0, 2, 3");
}

TEST(Prose, EndsAtTheOtherEnd) {
  for (Level n = 1; n <= 16; ++n) {
    const spec::Point<double> v_corner{0, 1};
    EXPECT_EQ(spec::index::as_the_prose_says(v_corner, n), 0u) << n;
    if (n < 16) {  // where 2 * 4^n is a word
      EXPECT_EQ(spec::index::as_the_prose_says(spec::Point<double>{1, 0}, n), 2u << 2 * n) << n;
    }
    EXPECT_EQ(spec::index::reference(v_corner, n), (std::uint64_t{1} << 2 * n) - 1) << n;
  }
}

}  // namespace index_dialect_test
}  // namespace mmverify::proofs
