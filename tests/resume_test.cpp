// The command line, killed and divided: --journal, --shard and merge.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "tests/command.hpp"

namespace {

using namespace mmverify::tests;
using nlohmann::json;
using testing::HasSubstr;

using Arguments = std::vector<std::string>;

Arguments with_resumed(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

Arguments sweep_of(const std::string& level) {
  return {"prove", "index.equals_reference", "--subject", "step", "--levels", level, "--quiet"};
}

json results_in(const fs::path& file) { return json::parse(text_of(file))["results"]; }

std::uintmax_t size_of(const fs::path& file) {
  std::error_code none;
  const auto size = fs::file_size(file, none);
  return none ? 0 : size;
}

class Resume : public testing::Test {
 protected:
  void expect_success(const Arguments& arguments) {
    const Outcome o = program(arguments);
    EXPECT_EQ(o.exit_code, 0) << o.err << o.out;
  }
  std::string at(const std::string& name) const { return folder / name; }
  Folder folder;
};

TEST_F(Resume, KilledThreeTimesAndDividedBySevenItIsTheSame) {
  const Arguments run = sweep_of("12");
  expect_success(with_resumed(run, {"--threads", "1", "--json", at("whole")}));

  const Arguments again = with_resumed(run, {"--journal", at("journal"), "--json", at("killed")});
  std::mt19937 random(std::random_device{}());
  int killed = 0;
  for (int kill = 1; kill <= 3; ++kill) {
    const std::uintmax_t enough = size_of(at("journal")) + 400 + random() % 3000;
    Process process(program_with(again));
    while (size_of(at("journal")) < enough && !fs::exists(at("killed")))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    process.send(SIGKILL);
    killed += process.wait().exit_code == 128 + SIGKILL ? 1 : 0;
  }
  EXPECT_GE(killed, 2);
  expect_success(again);

  Arguments merge{"merge"};
  for (int k = 1; k <= 7; ++k) {
    const std::string file = at("shard" + std::to_string(k));
    expect_success(with_resumed(run, {"--shard", std::to_string(k) + "/7", "--json", file}));
    EXPECT_EQ(results_in(file)[0]["verdict"], "checked");
    merge.push_back(file);
  }
  expect_success(with_resumed(merge, {"-o", at("merged")}));

  const json whole = results_in(at("whole"))[0], resumed = results_in(at("killed"))[0],
             merged = results_in(at("merged"))[0];
  EXPECT_EQ(whole["verdict"], "proved");
  EXPECT_GT(resumed["cases_resumed"], 0);
  for (const char* key : {"verdict", "digest", "cases_run", "by_kind"}) {
    EXPECT_EQ(resumed[key], whole[key]) << key;
    EXPECT_EQ(merged[key], whole[key]) << key;
  }
}

TEST_F(Resume, AShardKeepsAJournalOfItsOwn) {
  const Arguments run = with_resumed(sweep_of("9"), {"--journal", at("journal")});
  expect_success(with_resumed(run, {"--shard", "1/2"}));
  expect_complaint(program(with_resumed(run, {"--shard", "2/2"})), 4, "(shard: 1/2 there, 2/2 here)");
}

TEST_F(Resume, AJournalOfAnotherSubjectIsRefused) {
  expect_success(with_resumed(sweep_of("5"), {"--journal", at("journal")}));
  expect_complaint(program({"prove", "index.equals_reference", "--subject", "impl", "--levels", "5",
                            "--quiet", "--journal", at("journal")}),
                   4, "journal of another run (work: index.equals_reference step 5..5 there, ");
  expect_complaint(program(with_resumed(sweep_of("5"), {"--journal", at("journal"), "--cells", "interior"})),
                   4, "(cells: all there, interior here)");
}

TEST_F(Resume, MergeSaysWhatIsWrong) {
  const Arguments run = sweep_of("4");
  for (const std::string k : {"1", "2", "3"})
    expect_success(with_resumed(run, {"--shard", k + "/3", "--json", at(k)}));
  expect_success(with_resumed(run, {"--json", at("whole")}));
  const auto merge = [&](const Arguments& files) {
    Arguments all{"merge"};
    for (const std::string& file : files) all.push_back(at(file));
    return program(with_resumed(all, {"-o", at("merged")}));
  };
  expect_complaint(merge({"1", "2"}), 4, "shard 3/3 is missing");
  expect_complaint(merge({"1", "2", "2"}), 4, "both are shard 2/3");
  expect_complaint(merge({"1", "2", "whole"}), 4, "written without --shard");
  expect_complaint(merge({"1", "2", "none"}), 4, "none: cannot be read");
  std::ofstream(at("cut")) << text_of(at("3")).substr(0, 500);
  expect_complaint(merge({"1", "2", "cut"}), 4, "cut: ");
  std::ofstream(at("array")) << "[1]";
  expect_complaint(merge({"array"}), 4, "array: ");
  EXPECT_FALSE(fs::exists(at("merged")));
  EXPECT_EQ(merge({"3", "1", "2"}).exit_code, 0);
}

TEST_F(Resume, MergeTrustsOnlyWhatItCanStandFor) {
  const Arguments run = sweep_of("4");
  expect_success(with_resumed(run, {"--shard", "1/1", "--json", at("one")}));
  const auto merge_one_with = [&](const std::string& from, const std::string& to) {
    std::string text = text_of(at("one"));
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    std::ofstream(at("changed")) << text.replace(place, from.size(), to);
    return program({"merge", at("changed"), "-o", at("merged")});
  };
  expect_complaint(merge_one_with("\"finished\": true", "\"finished\": false"), 4,
                   "shard 1/1 was interrupted");
  expect_complaint(merge_one_with("\"program\": \"", "\"program\": \"0"), 4,
                   "made by a program of another program");
  expect_complaint(merge_one_with("\"spec\": \"", "\"spec\": \"0"), 4, "made by a program of another spec");
  expect_complaint(program({"merge", at("one"), "-o", at("one")}), 2, "one of the shards");
  EXPECT_FALSE(fs::exists(at("merged")));
  const Outcome alone = program({"merge", at("one"), "-o", at("merged")});
  EXPECT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_EQ(results_in(at("merged"))[0]["verdict"], "proved");
}

// A merge adds up by_kind: what stands beside it must say the same.
TEST_F(Resume, MergeTakesNoShardThatContradictsItself) {
  const Arguments run{"prove",  "index.equals_reference", "--subject", "step-appendix-ties", "--levels", "3",
                      "--quiet"};
  EXPECT_EQ(program(with_resumed(run, {"--shard", "1/1", "--json", at("one")})).exit_code, 1);
  json shard = json::parse(text_of(at("one")));
  for (auto& [kind, count] : shard["results"][0]["by_kind"].items()) count["mismatches"] = 0;
  std::ofstream(at("forged")) << shard;
  expect_complaint(program({"merge", at("forged"), "-o", at("merged")}), 4, "forged: results[0]");
  shard["results"][0]["mismatches"] = 0;
  std::ofstream(at("forged")) << shard;
  expect_complaint(program({"merge", at("forged"), "-o", at("merged")}), 4,
                   "a counterexample, beside 0 mismatches");
  EXPECT_FALSE(fs::exists(at("merged")));
}

TEST_F(Resume, AShardThatFailsLeavesNoOldResultToMerge) {
  const Arguments run = with_resumed(sweep_of("4"), {"--shard", "1/2", "--json", at("shard")});
  expect_success(run);
  std::ofstream(at("bad")) << "no journal";
  EXPECT_EQ(program(with_resumed(run, {"--journal", at("bad")})).exit_code, 4);
  EXPECT_FALSE(fs::exists(at("shard")));
}

TEST_F(Resume, WhereNothingAppliesAShardAndAMergeSaySo) {
  const Arguments run{"prove", "index.vulkan_ends_at_16", "--levels", "3", "--quiet"};
  Arguments merge{"merge"};
  for (const std::string k : {"1", "2"}) {
    const Outcome o = program(with_resumed(run, {"--shard", k + "/2", "--json", at(k)}));
    EXPECT_EQ(o.exit_code, 2) << o.err;
    EXPECT_NE(o.err.find("nothing was run"), std::string::npos) << o.err;
    merge.push_back(at(k));
  }
  const Outcome o = program(with_resumed(merge, {"-o", at("merged")}));
  EXPECT_EQ(o.exit_code, 2) << o.err;
  EXPECT_FALSE(fs::exists(at("merged")));
}

TEST_F(Resume, AFileThatMayNotGrowIsReported) {
  std::string line = "ulimit -f 1; mmverify prove index.equals_reference --subject step --levels 10 --quiet";
  const Outcome o = shell(line + " --journal " + at("journal") + " 2>&1 >/dev/null");
  EXPECT_EQ(o.exit_code, 4) << o.out;
  EXPECT_NE(o.out.find("journal: "), std::string::npos) << o.out;
  // What was written before is not lost.
  expect_success(with_resumed(sweep_of("10"), {"--journal", at("journal"), "--json", at("json")}));
  EXPECT_GT(results_in(at("json"))[0]["cases_resumed"], 0);
}

TEST_F(Resume, AWrongShardMakesAWrongRun) {
  const Arguments run{"prove",     "index.equals_reference",
                      "--subject", "step-appendix-ties",
                      "--levels",  "5",
                      "--quiet",   "--errors",
                      "3"};
  const Outcome whole = program(with_resumed(run, {"--json", at("whole")}));
  Arguments merge{"merge"};
  for (const std::string k : {"1", "2", "3"}) {
    program(with_resumed(run, {"--shard", k + "/3", "--json", at(k)}));
    merge.push_back(at(k));
  }
  const Outcome merged = program(with_resumed(merge, {"-o", at("merged")}));
  EXPECT_EQ(whole.exit_code, 1);
  EXPECT_EQ(merged.exit_code, 1);
  json one = results_in(at("whole"))[0], other = results_in(at("merged"))[0];
  one.erase("seconds");
  other.erase("seconds");
  EXPECT_EQ(one, other);
}

TEST_F(Resume, ArgumentsAreLookedAt) {
  for (const std::string bad : {"0/3", "4/3", "1", "1/0", "a/b", "1/3/5", "-1/3", "1/9999999"})
    expect_complaint(program(with_resumed(sweep_of("3"), {"--shard=" + bad})), 2, "--shard " + bad);
  expect_complaint(program(with_resumed(sweep_of("3"), {"--journal", at("x"), "--json", at("x")})), 2,
                   "another output's file");
  expect_complaint(program(with_resumed(sweep_of("3"), {"--journal", folder.path()})), 4, "cannot be opened");
}

}  // namespace
