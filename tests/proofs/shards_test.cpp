// proofs/engine/shards: parts that add up, and all the ways in which they do not.
#include "proofs/engine/shards.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/complaint.hpp"
#include "tests/proofs/counting_law.hpp"

namespace {

using namespace mmverify::tests;
using testing::HasSubstr;

TEST(Shard, SharesTileTheChunks) {
  for (const std::uint64_t chunks : {0ull, 1ull, 6ull, 7ull, 100ull, 12345ull, 1ull << 60})
    for (const std::uint32_t of : {1u, 2u, 7u, 64u, 1000u}) {
      std::uint64_t done = 0, least = ~0ull, most = 0;
      for (std::uint32_t k = 1; k <= of; ++k) {
        const Chunk share = Shard{k, of}.chunks(chunks);
        EXPECT_EQ(share.begin, done);
        ASSERT_LE(share.begin, share.end);
        least = std::min(least, share.end - share.begin);
        most = std::max(most, share.end - share.begin);
        done = share.end;
      }
      EXPECT_EQ(done, chunks);
      EXPECT_LE(most - least, 1u);
    }
}

std::vector<ShardRun> shards_of(const Law& law, const SubjectPtr& subject, std::uint32_t of) {
  std::vector<ShardRun> shards;
  for (std::uint32_t k = 1; k <= of; ++k) {
    RunOptions options = silent();
    options.shard = Shard{k, of};
    shards.push_back(
        {"s" + std::to_string(k), *options.shard, {{"seed", "1"}}, run_it(law, subject, options)});
  }
  return shards;
}

Report merged(std::vector<ShardRun> shards, Method method = Method::exhaustive) {
  Law law = counting_law();
  law.method = method;
  return merge_shards(std::move(shards), silent().errors,
                      [&](const std::string&) -> const Law& { return law; });
}

std::string complaint(std::vector<ShardRun> shards) {
  return complaint_of<ShardsDoNotAddUp>([&] { merged(std::move(shards)); }, "");
}

class Shards : public testing::Test {
 protected:
  Law law = counting_law();
  SubjectPtr good = std::make_shared<Squares>(), bad = std::make_shared<Squares>(9);
};

TEST_F(Shards, AddUpToTheWholeRun) {
  for (const SubjectPtr& subject : {good, bad})
    for (const bool divisible : {true, false})
      for (const std::uint32_t of : {1u, 2u, 3u, 7u, 150u}) {  // more shards than chunks, too
        law.divisible = divisible;
        EXPECT_EQ(essence(merged(shards_of(law, subject, of))), essence(run_it(law, subject, silent())))
            << of;
      }
}

TEST_F(Shards, AreNeverCalledProvedAlone) {
  for (const ShardRun& s : shards_of(law, good, 3))
    for (const Result& r : s.report.results) EXPECT_EQ(r.verdict, Verdict::checked);
  EXPECT_EQ(merged(shards_of(law, good, 3)).results[0].verdict, Verdict::proved);
  EXPECT_EQ(merged(shards_of(law, good, 3), Method::sample).results[0].verdict, Verdict::checked);
}

TEST_F(Shards, WithoutACaseAreNotChecked) {
  const auto shards = shards_of(law, good, 150);
  std::uint64_t cases = 0;
  for (const ShardRun& s : shards)
    for (const Result& r : s.report.results) {
      EXPECT_EQ(r.verdict, r.cases_run() == 0 ? Verdict::not_applicable : Verdict::checked);
      EXPECT_EQ(r.reason, r.cases_run() == 0 ? "0 cases in this shard" : "");
      cases += r.cases_run();
    }
  EXPECT_EQ(cases, run_it(law, good, silent()).results.size() * numbers);
  EXPECT_EQ(merged(shards).results[0].verdict, Verdict::proved);
}

TEST_F(Shards, MayComeInAnyOrder) {
  auto shards = shards_of(law, bad, 4);
  std::swap(shards[0], shards[2]);
  EXPECT_EQ(essence(merged(shards)), essence(run_it(law, bad, silent())));
}

TEST_F(Shards, MissingOrDoubledAreNamed) {
  auto shards = shards_of(law, good, 4);
  shards.erase(shards.begin() + 1);
  EXPECT_THAT(complaint(shards), HasSubstr("shard 2/4 is missing"));
  shards = shards_of(law, good, 4);
  shards.pop_back();
  EXPECT_THAT(complaint(shards), HasSubstr("shard 4/4 is missing"));
  shards = shards_of(law, good, 4);
  shards[3] = shards[1];
  EXPECT_THAT(complaint(shards), HasSubstr("s2 and s2: both are shard 2/4"));
  shards.push_back(shards_of(law, good, 4)[3]);
  EXPECT_THAT(complaint(shards), HasSubstr("both are shard 2/4"));
}

TEST_F(Shards, OfOtherRunsAreRefused) {
  auto shards = shards_of(law, good, 4);
  shards[2].identity = {{"seed", "2"}};
  EXPECT_THAT(complaint(shards), HasSubstr("s3: not of the run of s1 (seed: 2 there, 1 here)"));
  shards = shards_of(law, good, 4);
  shards[2] = shards_of(law, good, 5)[2];
  EXPECT_THAT(complaint(shards), HasSubstr("shard 3/5"));
}

TEST_F(Shards, ThatWereInterruptedAreRefused) {
  auto shards = shards_of(law, good, 4);
  shards[1].finished = false;
  EXPECT_THAT(complaint(shards), HasSubstr("s2: shard 2/4 was interrupted"));
}

TEST_F(Shards, WithGapsAndOverlapsAreRefused) {
  const auto with = [&](std::uint64_t from, std::uint64_t to, std::uint64_t of) {
    auto shards = shards_of(law, good, 4);
    shards[1].report.results[0].share = Share{from, to, of};
    return complaint(shards);
  };
  EXPECT_EQ(with(250, 500, numbers), "");
  EXPECT_THAT(with(260, 500, numbers), HasSubstr("units 250 to 260 are left out"));
  EXPECT_THAT(with(240, 500, numbers), HasSubstr("units 240 to 250 are covered twice"));
  EXPECT_THAT(with(250, 490, numbers), HasSubstr("units 490 to 500 are left out"));
  EXPECT_THAT(with(250, 500, numbers + 1), HasSubstr("another domain"));
  EXPECT_THAT(with(250, 250, numbers), HasSubstr("units 250 to 500 are left out"));
}

TEST_F(Shards, WithWrongSumsAreRefused) {
  auto shards = shards_of(law, good, 4);
  --shards[1].report.results[0].by_kind[1].cases;
  EXPECT_THAT(complaint(shards), HasSubstr("999 cases in all, 1000 expected"));
  shards = shards_of(law, bad, 4);
  ++shards[1].report.results[0].by_kind[1].cases;
  EXPECT_THAT(complaint(shards), HasSubstr("1001 cases in all, 1000 expected"));
  shards = shards_of(law, good, 4);
  shards[1].report.results[0].share.reset();
  EXPECT_THAT(complaint(shards), HasSubstr("no share"));
  shards = shards_of(law, good, 4);
  shards[1].report.results[0].verdict = Verdict::incomplete;
  EXPECT_THAT(complaint(shards), HasSubstr("s2: test.squares squares level 4 is incomplete"));
  shards = shards_of(law, good, 4);
  shards[1].report.results.pop_back();
  EXPECT_THAT(complaint(shards), HasSubstr("s2: test.squares squares level 5 is missing"));
}

TEST_F(Shards, WhoseSubjectBrokeMakeABrokenRun) {
  auto shards = shards_of(law, good, 4);
  Result& broken = shards[1].report.results[0];
  broken.verdict = Verdict::broken;
  broken.reason = "it hung";
  broken.share.reset();
  shards[1].report.results.pop_back();  // a subject that breaks is not asked on
  const Report whole = merged(shards);
  EXPECT_EQ(whole.results[0].verdict, Verdict::broken);
  EXPECT_EQ(whole.results[0].reason, "it hung");
  EXPECT_EQ(whole.results.size(), 1u);  // as the whole run would have ended
}

}  // namespace
