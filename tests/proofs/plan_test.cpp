// proofs/planning/plan.hpp: which law is run on which subject, and the weakest of the verdicts.
#include "proofs/planning/plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "proofs/registry/registry.hpp"

namespace {

using namespace mmverify::proofs;

std::vector<std::string> jobs_of(const Request& request) {
  std::vector<std::string> all;
  for (const Job& job : plan(request)) all.push_back(job.law->id + " " + job.subject->name());
  return all;
}

TEST(Plan, AFloatSubjectBringsTheCompanionOnFloatsAlong) {
  Request request;
  request.laws = {find_law("index.equals_reference"), find_law("index.rounding")};
  request.subjects = {find_subject("step-f32"), find_subject("step")};
  EXPECT_THAT(
      jobs_of(request),
      testing::ElementsAre("index.equals_reference step-f32", "index.exact_on_floats step-f32",
                           "index.equals_reference step", "index.rounding step-f32", "index.rounding step"));
}

TEST(Plan, ALawThatDoesNotApplyBringsNothingAlong) {
  Request request;
  request.laws = {find_law("index.nested")};
  request.subjects = {find_subject("impl")};
  request.levels = Levels{16, 16};
  EXPECT_THAT(jobs_of(request), testing::ElementsAre("index.nested impl"));
  request.levels = Levels{15, 16};
  EXPECT_THAT(jobs_of(request), testing::ElementsAre("index.nested impl", "index.exact_on_floats impl"));
}

TEST(Plan, NoNamesMeanEveryLawOfTheTierOnItsOwnSubjects) {
  for (const Tier tier : {Tier::fast, Tier::long_run}) {
    std::size_t all = 0;
    for (const Law& law : laws())
      if (!law.by_id_only && (tier == Tier::long_run || !law.long_only)) all += law.subjects.size();
    Request request;
    request.tier = tier;
    const std::vector<std::string> jobs = jobs_of(request);
    EXPECT_EQ(jobs.size(), all);
    EXPECT_EQ(std::set<std::string>(jobs.begin(), jobs.end()).size(), jobs.size());
  }
}

TEST(Plan, LawsAboutOthersAreLeftOutOrSaidNotToApply) {
  Request request;
  request.subjects = {find_subject("impl")};
  for (const std::string& job : jobs_of(request)) EXPECT_FALSE(job.starts_with("paper.step")) << job;
  request.laws = {find_law("paper.step_equals_reference")};
  const std::vector<Job> asked = plan(request);
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_FALSE(asked.front().unfit.empty());
}

TEST(Plan, SubjectsMeetTheLawsOfTheirTopic) {
  Request request;
  request.subjects = {find_subject("tree-stream"), find_subject("step")};
  for (const Job& job : plan(request)) EXPECT_EQ(job.law->topic, job.subject->topic()) << job.law->id;
  // A law that is named takes the subjects of its topic, and says so where there are none.
  request.laws = {find_law("tree.round_trip")};
  EXPECT_THAT(jobs_of(request), testing::ElementsAre("tree.round_trip tree-stream"));
  request.subjects = {find_subject("step")};
  const std::vector<Job> asked = plan(request);
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_EQ(asked.front().unfit, "step is a subject of topic index");
}

TEST(Plan, LevelsAreThoseAskedForOrTheTiers) {
  Request request;
  request.laws = {find_law("index.in_range")};
  EXPECT_EQ(plan(request).front().levels, request.laws.front()->tiers.fast);
  request.tier = Tier::long_run;
  EXPECT_EQ(plan(request).front().levels, request.laws.front()->tiers.long_run);
  request.levels = Levels{2, 3};
  EXPECT_EQ(plan(request).front().levels, (Levels{2, 3}));
}

TEST(Weakest, OrderOfTheVerdicts) {
  const auto of = [](std::vector<Verdict> verdicts) {
    std::vector<Result> results;
    for (const Verdict v : verdicts) {
      results.emplace_back();
      results.back().subject = "s";
      results.back().verdict = v;
    }
    results.emplace_back();
    results.back().subject = "another";
    results.back().verdict = Verdict::broken;
    return weakest(results, "s");
  };
  using enum Verdict;
  EXPECT_EQ(of({proved, not_applicable}), proved);
  EXPECT_EQ(of({proved, checked}), checked);
  EXPECT_EQ(of({checked, incomplete, proved}), incomplete);
  EXPECT_EQ(of({incomplete, refuted}), refuted);
  EXPECT_EQ(of({refuted, broken, proved}), broken);
  EXPECT_EQ(of({not_applicable}), not_applicable);
  EXPECT_EQ(of({}), not_applicable);
}

}  // namespace
