// Somebody else's baker on a scene: what is wrong of its maps, beside ours.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "proofs/scene/laws.hpp"
#include "tests/sanitized.hpp"
#include "tests/scene/made_scene.hpp"

namespace {

using namespace mmverify;
using namespace mmverify::tests;
using proofs::bake::Baked;
using proofs::bake::BakeSubject;
using proofs::bake::BakeSubjectPtr;
using proofs::bake::Case;
using proofs::bake::Format;
using spec::micromap::State;

struct Judged {
  proofs::Report report;
  proofs::scene::SubjectTotals totals;
};

Judged judged(const BakeSubjectPtr& baker) {
  const Made made;
  const proofs::scene::SubjectMaps maps(made.data(), baker);
  const proofs::scene::SubjectLaws laws =
      proofs::scene::subject_laws(maps, "mmverify scene made.gltf --subject it");
  proofs::RunOptions run;
  run.show_progress = false;
  run.threads = 1;
  run.mutants = false;
  Judged all;
  all.report = proofs::run_jobs(laws.jobs, run, [](const proofs::Result&) {});
  all.totals = maps.totals();
  return all;
}

bool refuted(const proofs::Report& report, const std::string& law) {
  bool found = false;
  for (const proofs::Result& r : report.results)
    found = found || (r.law == law && r.verdict == proofs::Verdict::refuted);
  return found;
}

BakeSubjectPtr changed(const std::function<void(const Case&, std::vector<State>&)>& change,
                       const proofs::bake::Support& support = {}) {
  proofs::bake::Functions functions = proofs::bake::built_in("bake")->functions;
  functions.support = support;
  functions.bake = [change, real = functions.bake](const Case& one, proofs::Level n, Format format) {
    auto baked = real(one, n, format);
    if (baked) change(one, baked->states);
    return baked;
  };
  return std::make_shared<BakeSubject>("changed", "wrong on purpose", functions);
}

TEST(SceneSubject, OursIsRightOfEachMicroTriangle) {
  const Judged ours = judged(proofs::bake::built_in("bake"));
  EXPECT_FALSE(refuted(ours.report, "bake.conservative"));
  EXPECT_FALSE(refuted(ours.report, "bake.tight"));
  EXPECT_EQ(ours.totals.outside + ours.totals.declined, 0u);
  EXPECT_EQ(ours.totals.wrong_known + ours.totals.needless_unknown, 0u);
  EXPECT_GT(ours.totals.micro_triangles, 0u);
  EXPECT_GT(ours.totals.ns, 0);
  for (const proofs::Result& r : ours.report.results) EXPECT_EQ(r.verdict, proofs::Verdict::checked) << r.law;
}

// One state of each map that has one to spare: as many wrong ones are counted.
TEST(SceneSubject, EachWrongStateIsCounted) {
  std::uint64_t claimed = 0, forgotten = 0;
  const Judged claims = judged(changed([&](const Case&, std::vector<State>& states) {
    for (State& s : states)
      if (s == State::UO || s == State::UT) {
        s = State::O;
        ++claimed;
        return;
      }
  }));
  EXPECT_GT(claimed, 0u);
  EXPECT_EQ(claims.totals.wrong_known, claimed);
  EXPECT_EQ(claims.totals.needless_unknown, 0u);
  EXPECT_TRUE(refuted(claims.report, "bake.conservative"));
  EXPECT_FALSE(refuted(claims.report, "bake.tight"));
  const Judged forgets = judged(changed([&](const Case&, std::vector<State>& states) {
    for (State& s : states)
      if (s == State::O || s == State::T) {
        s = State::UT;
        ++forgotten;
        return;
      }
  }));
  EXPECT_GT(forgotten, 0u);
  EXPECT_EQ(forgets.totals.needless_unknown, forgotten);
  EXPECT_EQ(forgets.totals.wrong_known, 0u);
  EXPECT_TRUE(refuted(forgets.report, "bake.tight"));
  for (const proofs::Result& r : forgets.report.results)
    for (const proofs::Counterexample& c : r.counterexamples)
      EXPECT_THAT(c.got, testing::HasSubstr("alpha is"));
}

// Told that only alpha above the cutoff is opaque, ours is wrong where alpha meets it; what it says of the rest stands.
TEST(SceneSubject, OtherRulesAreHeldAgainstTheSpecification) {
  proofs::bake::Support slack;
  slack.weight_bits = 8;
  const auto nothing = [](const Case&, std::vector<State>&) {};
  const Judged lenient = judged(changed(nothing, slack));
  EXPECT_EQ(lenient.totals.wrong_known + lenient.totals.needless_unknown, 0u);
}

TEST(SceneSubject, WhatItDoesNotDeclareIsNotAsked) {
  proofs::bake::Support clamped;
  clamped.wraps = proofs::Set(1u << static_cast<unsigned>(proofs::bake::Wrap::clamp_to_border));
  std::uint64_t asked = 0;
  const Judged none = judged(changed([&](const Case&, std::vector<State>&) { ++asked; }, clamped));
  EXPECT_EQ(asked, 0u);
  EXPECT_EQ(none.totals.outside, none.totals.triangles);
  EXPECT_TRUE(none.report.results.empty());
}

}  // namespace
