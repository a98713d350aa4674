// mmverify gate: real results against themselves, and against what was planted in them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::tests;
using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// What the program says with --json -, run once for each list of arguments.
const Json& result_of(const std::vector<std::string>& arguments) {
  static std::map<std::vector<std::string>, Json> known;
  Json& json = known[arguments];
  if (json.is_null()) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--json", "-", "--quiet"});
    const Outcome run = program(all);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    json = Json::parse(run.out);
  }
  return json;
}
const Json& proved() { return result_of({"prove", "index.in_range", "--levels", "0..2"}); }
const Json& scene() { return result_of({"scene", "--level", "3", "--samples", "200", "--sizes", "1..2"}); }
const Json& bench_tree() { return result_of({"bench", "tree", "--levels", "3..4", "--samples", "100"}); }
const Json& bench_vq() { return result_of({"bench", "vq", "--maps", "2"}); }
const Json& bench_bake() { return result_of({"bench", "bake", "--levels", "3..3", "--maps", "1"}); }

class Gate : public testing::Test {
 protected:
  std::string file(const std::string& name, const Json& json) {
    const std::string path = folder_ / name;
    std::ofstream(path) << json.dump(1);
    return path;
  }
  /// What the gate says of `now`, blessed with `before`.
  Outcome gate(const Json& before, const Json& now, const std::vector<std::string>& more = {}) {
    const std::string baseline = folder_ / "baseline.json", result = file("result.json", now);
    const Outcome blessed = program({"gate", "--baseline", baseline, file("before.json", before), "--bless"});
    EXPECT_EQ(blessed.exit_code, 0) << blessed.err;
    std::vector<std::string> arguments{"gate", "--baseline", baseline, result};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return program(arguments);
  }
  /// Red, with these words, once `plant` has been at work.
  void expect_red(const Json& run, const std::function<void(Json&)>& plant, const std::string& words) {
    Json changed = run;
    plant(changed);
    ASSERT_NE(changed, run) << "nothing was planted";
    const Outcome outcome = gate(run, changed);
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr(words), HasSubstr("gate: red"), HasSubstr("--bless")));
  }
  Folder folder_;
};

/// So many of a result's cases, all of one kind.
void set_cases(Json& result, std::uint64_t cases) {
  for (auto& [kind, count] : result["by_kind"].items()) count["cases"] = 0;
  result["by_kind"]["interior"]["cases"] = cases;
  result["cases_run"] = cases;
}

/// A result that passed, as it is where that many of its cases are wrong.
void refute(Json& result, std::uint64_t mismatches, const char* verdict = "refuted") {
  result["verdict"] = verdict;
  result["mismatches"] = mismatches;
  result["by_kind"]["interior"]["mismatches"] = mismatches;
  result["counterexample"] = {{"case", "v:u=0,v=0"}, {"expected", 0}, {"got", 1}};
}

/// The first object in a list with this member of this value.
Json& with_gate(Json& list, const char* member, const Json& value) {
  for (Json& one : list)
    if (one.at(member) == value) return one;
  throw std::runtime_error("nothing with " + value.dump());
}

TEST_F(Gate, KnowsEveryFieldOfEveryCommandAndIsGreenOnTheSameRun) {
  const std::string glb = folder_ / "own.glb";
  EXPECT_EQ(program({"scene", "--quiet", "--level", "2", "--samples", "9", "-o", glb}).exit_code, 0);
  // Benches take a sanitized program a minute, and write what the others do.
  std::vector<std::pair<const char*, Json>> runs{{"prove", proved()}, {"tree", bench_tree()}};
  if (!sanitized)
    runs.insert(
        runs.end(),
        {{"scene", scene()},
         {"index", result_of({"bench", "index", "--levels", "1..2", "--samples", "64"})},
         {"vq", bench_vq()},
         {"bake", bench_bake()},
         {"subject", result_of({"bench", "--subject", MMVERIFY_SUBJECTS "/example.so", "--levels", "4..4"})},
         {"scene bench", result_of({"bench", "bake", "--scene", glb, "--levels", "2..3"})},
         {"sweep", result_of({"bench", "index", "--sweep", "--levels", "2..3"})}});
  for (const auto& [name, run] : runs) {
    const Outcome outcome = gate(run, run);
    EXPECT_EQ(outcome.exit_code, 0) << name << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("gate: green"), HasSubstr("none differs"))) << name;
    // A result may be a baseline itself.
    const std::string path = file("itself.json", run);
    EXPECT_EQ(program({"gate", "--baseline", path, path}).exit_code, 0) << name;
  }
}

TEST_F(Gate, AVerdict) {
  const auto checked = [](Json& j) { with_gate(j["results"], "verdict", "proved")["verdict"] = "checked"; };
  expect_red(proved(), checked, ": verdict proved -> checked\n");
  const auto refuted = [](Json& j) {
    set_cases(j["results"][0], j["results"][0]["cases_run"]);
    refute(j["results"][0], 2);
  };
  expect_red(proved(), refuted, "worse   index.in_range");
  expect_red(proved(), refuted, ": mismatches 0 -> 2\n");
}

TEST_F(Gate, ABetterVerdictIsRedUntilBlessed) {
  Json before = proved();
  with_gate(before["results"], "verdict", "proved")["verdict"] = "checked";
  const Outcome outcome = gate(before, proved());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("better  index.in_range"));
  EXPECT_THAT(outcome.out, HasSubstr(": verdict checked -> proved"));
}

TEST_F(Gate, CaseCounts) {
  // A proof of fewer cases expects fewer: not a proof cut short, which contradicts itself.
  const auto fewer = [](Json& j) {
    Json& r = j["results"][1];
    set_cases(r, r["cases_run"].get<std::uint64_t>() - 1);
    r["cases_expected"] = r["cases_run"];
  };
  expect_red(proved(), fewer, ": cases_run ");
  expect_red(proved(), fewer, ": cases_expected ");
  // 64 bits are compared, not the double that is nearest.
  Json large = proved();
  large["results"][1]["cases_expected"] = 9007199254740993u;
  set_cases(large["results"][1], 9007199254740993u);
  expect_red(
      large,
      [](Json& j) {
        j["results"][1]["verdict"] = "incomplete";
        set_cases(j["results"][1], 9007199254740992u);
      },
      ": cases_run 9007199254740993 -> 9007199254740992");
}

// The sums stay: what moves from one kind of cell to another is seen in by_kind alone.
TEST_F(Gate, CountsOfAKind) {
  expect_red(
      proved(),
      [](Json& j) {
        Json& kinds = j["results"][2]["by_kind"];
        kinds["vertex"]["cases"] = kinds["vertex"]["cases"].get<int>() - 1;
        kinds["edge"]["cases"] = kinds["edge"]["cases"].get<int>() + 1;
      },
      ": by_kind.vertex.cases ");
  expect_red(
      proved(), [](Json& j) { j["results"][2]["by_kind"]["edge"].erase("mismatches"); },
      ": by_kind.edge.mismatches 0");
  Json on_vertices = proved();
  refute(on_vertices["results"][2], 1);
  expect_red(
      on_vertices,
      [](Json& j) {
        Json& kinds = j["results"][2]["by_kind"];
        kinds["interior"]["mismatches"] = 0;
        kinds["vertex"]["mismatches"] = 1;
      },
      ": by_kind.vertex.mismatches 0 -> 1\n");
}

TEST_F(Gate, AResultThatContradictsItselfIsNoResult) {
  const auto complains = [&](const std::function<void(Json&)>& plant, const std::string& words) {
    Json changed = proved();
    plant(changed["results"][2]);
    const std::string good = file("good.json", proved()), bad = file("bad.json", changed);
    for (const auto& arguments : {std::vector<std::string>{"gate", "--baseline", good, bad},
                                  {"gate", "--baseline", bad, good},
                                  {"gate", "--baseline", folder_ / "new.json", bad, "--bless"}})
      expect_complaint(program(arguments), 4, "bad.json: results[");
    expect_complaint(program({"gate", "--baseline", good, bad}), 4, words);
  };
  complains(
      [](Json& r) {
        r["counterexample"] = {{"case", "v:u=0,v=0"}};
      },
      "a counterexample, beside 0 mismatches");
  complains([](Json& r) { r["verdict"] = "refuted"; }, "refuted, with 0 mismatches");
  complains([](Json& r) { r["by_kind"] = "gone"; }, "results[].by_kind: no rule says");
}

TEST_F(Gate, AMutantThatSurvives) {
  expect_red(
      proved(), [](Json& j) { j["mutants"][0]["killed"] = false; }, ": killed true -> false");
}

TEST_F(Gate, AResultOrAFigureThatIsGoneOrNew) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const std::string name =
      "index.in_range " + proved()["results"][0]["subject"].get<std::string>() + " level 0\n";
  expect_red(
      proved(), [](Json& j) { j["results"].erase(0); }, "gone    " + name);
  Json fewer = proved();
  fewer["results"].erase(0);
  const Outcome outcome = gate(fewer, proved());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("new     " + name));
  expect_red(
      scene(), [](Json& j) { j["scene"]["bake"].erase("exact"); }, "gone    scene.bake: exact");
}

TEST_F(Gate, ASize) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const auto grow = [](Json& j) {
    Json& bytes = j["scene"]["footprint"]["array_data_bytes"];
    bytes = bytes.get<int>() + 1;
  };
  expect_red(scene(), grow, "worse   scene.footprint: array_data_bytes ");
  Json before = scene();
  grow(before);
  EXPECT_THAT(gate(before, scene()).out, HasSubstr("better  scene.footprint: array_data_bytes "));
  expect_red(
      bench_tree(),
      [](Json& j) {
        Json& bits = j["rows"][0]["forms"][1]["bits_per_micro_triangle"];
        bits = bits.get<double>() * 1.001;
      },
      ": bits_per_micro_triangle ");
}

TEST_F(Gate, Substitutions) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_red(
      bench_vq(),
      [](Json& j) {
        Json& n = j["rows"][0]["vq4"][0]["substitutions"];
        n = n.get<int>() + 1;
      },
      ": substitutions ");
}

TEST_F(Gate, NeedlessUnknowns) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_red(
      bench_bake(),
      [](Json& j) { with_gate(j["rows"][0]["bakers"], "baker", "ours, exact")["needless"] = 1; },
      ": needless 0 -> 1\n");
  expect_red(
      scene(),
      [](Json& j) {
        Json& states = j["scene"]["bake"]["states"];
        states["T"] = states["T"].get<int>() - 1;
        states["UT"] = states["UT"].get<int>() + 1;
      },
      "worse   scene.bake: states.UT ");
}

/// Every ratio that says how fast ours is, times this.
void speed(Json& j, double factor) {
  for (Json& row : j["rows"]) {
    row["ratio_paper_to_ours"] = row["ratio_paper_to_ours"].get<double>() * factor;
    row["ratio_ours_to_flat"] = row["ratio_ours_to_flat"].get<double>() / factor;
  }
}

TEST_F(Gate, AnImplementationHalfAsFast) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  expect_red(
      bench_tree(), [](Json& j) { speed(j, 0.5); }, ": ratio_paper_to_ours ");
  expect_red(
      bench_tree(), [](Json& j) { speed(j, 0.5); }, ": ratio_ours_to_flat ");
}

TEST_F(Gate, ASpeedThatWasNoneIsNotPassedOver) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  Json before = bench_tree();
  before["rows"][0]["ratio_paper_to_ours"] = nullptr;
  const Outcome outcome = gate(before, bench_tree());
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("changed tree states 2 level 3: ratio_paper_to_ours null -> "));
}

TEST_F(Gate, WhatIsBlessedThoughItIsNoSuccessIsNamed) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  Json refuted = proved();
  refute(refuted["results"][0], 1);
  const std::string path = file("refuted.json", refuted);
  const Outcome blessed = program({"gate", "--baseline", folder_ / "r.json", path, "--bless"});
  EXPECT_THAT(blessed.out, HasSubstr("gate: 1 results are refuted"));
  EXPECT_THAT(program({"gate", "--baseline", folder_ / "r.json", path}).out,
              HasSubstr("gate: 1 results are refuted"));
}

TEST_F(Gate, NamesCannotForgeItsLines) {
  Json forged = proved();
  for (Json& r : forged["results"]) r["subject"] = "x\ngate: green: all";
  EXPECT_THAT(gate(proved(), forged).out, Not(HasSubstr("\ngate: green")));
}

TEST_F(Gate, ASpeedWithinTheToleranceOrBetterIsGreen) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  Json a_little = bench_tree(), twice = bench_tree();
  speed(a_little, 0.8);
  speed(twice, 2);
  const Outcome within = gate(bench_tree(), a_little);
  EXPECT_EQ(within.exit_code, 0) << within.out;
  EXPECT_THAT(within.out, HasSubstr("none differs"));
  EXPECT_EQ(gate(bench_tree(), a_little, {"--tolerance", "1.1"}).exit_code, 1);
  const Outcome faster = gate(bench_tree(), twice);
  EXPECT_EQ(faster.exit_code, 0) << faster.out;
  EXPECT_THAT(faster.out, HasSubstr("faster  "));
}

TEST_F(Gate, TimesAndMachinesAreNotCompared) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  Json elsewhere = proved();
  elsewhere["tool"]["cpu"] = "another";
  elsewhere["tool"]["threads"] = 64;
  for (Json& r : elsewhere["results"]) r["seconds"] = 1e6;
  EXPECT_EQ(gate(proved(), elsewhere).exit_code, 0);
}

TEST_F(Gate, ALibraryIsTheSameWhereverItWasBuilt) {
  Json here = proved(), there = proved();
  for (Json& r : here["results"]) r["subject"] = "/one/place/libmine.so";
  for (Json& r : there["results"]) r["subject"] = "../libmine.so";
  EXPECT_EQ(gate(here, there).exit_code, 0);
}

/// Their order is that of the command line's words.
TEST_F(Gate, LibrariesOfOneNameAreToldApartByTheirFolders) {
  const auto two = [](const char* first, const char* second) {
    Json both = proved();
    Json& results = both["results"];
    const Json once = results;
    results = Json::array();
    for (const char* subject : {first, second})
      for (Json r : once) {
        r["subject"] = subject;
        if (std::string(subject).find("wrong") != std::string::npos) refute(r, 1);
        results.push_back(r);
      }
    return both;
  };
  const Json before = two("/a/right/libmine.so", "/a/wrong/libmine.so");
  EXPECT_EQ(gate(before, two("b/wrong/libmine.so", "b/right/libmine.so")).exit_code, 0);
  const Outcome outcome = gate(before, two("/a/right/libmine.so", "/a/right/libmine.so"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("gone    index.in_range wrong/libmine.so level 0"));
}

TEST_F(Gate, SpeedsOfTwoProcessorsAreSaidToBe) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  Json elsewhere = bench_tree();
  elsewhere["tool"]["cpu"] = "another";
  EXPECT_THAT(gate(bench_tree(), elsewhere).out,
              HasSubstr("gate: speeds of two processors: the baseline's "));
  EXPECT_THAT(gate(bench_tree(), bench_tree()).out, Not(HasSubstr("two processors")));
  EXPECT_THAT(gate(proved(), proved()).out, Not(HasSubstr("two processors")));
}

TEST_F(Gate, BlessingMakesItGreen) {
  Json changed = proved();
  changed["results"][0]["verdict"] = "checked";
  const std::string baseline = folder_ / "b.json", now = file("now.json", changed);
  ASSERT_EQ(program({"gate", "--baseline", baseline, file("old.json", proved()), "--bless"}).exit_code, 0);
  ASSERT_EQ(program({"gate", "--baseline", baseline, now}).exit_code, 1);
  ASSERT_EQ(program({"gate", "--baseline", baseline, now, "--bless"}).exit_code, 0);
  EXPECT_EQ(program({"gate", "--baseline", baseline, now}).exit_code, 0);
}

TEST_F(Gate, SomeOfManyDifferencesUnlessAllAreAskedFor) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  Json changed = result_of({"prove", "index.in_range", "--subject", "step", "--levels", "0..9"});
  Json many = changed;
  for (Json& r : many["results"]) {
    set_cases(r, 7);
    r["cases_expected"] = 7;
    refute(r, 7);
  }
  const std::string some = gate(changed, many).out;
  std::size_t shown = 0;
  for (std::size_t at = 0; (at = some.find("worse   index", at)) != std::string::npos; ++at) ++shown;
  EXPECT_EQ(shown, 20u);
  EXPECT_THAT(some, testing::ContainsRegex("worse   and [0-9]+ more; see --all"));
  EXPECT_THAT(gate(changed, many, {"--all"}).out, Not(HasSubstr("see --all")));
}

TEST_F(Gate, WhatCannotBeCompared) {
  const std::string good = file("good.json", proved());
  const auto complaint = [&](const std::string& baseline, const std::string& result, int code,
                             const std::string& words) {
    expect_complaint(program({"gate", "--baseline", baseline, result}), code, words);
  };
  complaint(good, folder_ / "none.json", 4, "none.json: cannot be read");
  complaint(folder_ / "none.json", good, 4, "none.json: cannot be read");
  complaint(good, folder_.path(), 4, "cannot be read");
  std::ofstream(folder_ / "cut.json") << proved().dump().substr(0, 100);
  complaint(good, folder_ / "cut.json", 4, "cut.json: ");
  complaint(good, file("other.json", {{"schema", "another/1"}}), 4, "neither mmverify.result/1");
  complaint(good, file("list.json", Json::array()), 4, "nothing in it can be compared");
  complaint(good, file("empty.json", {{"schema", "mmverify.result/1"}, {"results", Json::array()}}), 4,
            "nothing in it can be compared");
  complaint(file("b.json", {{"schema", "mmverify.baseline/1"}}), good, 4, "b.json: of: no schema");
  complaint(good, file("tree.json", bench_tree()), 2, "a result of mmverify.bench/1, the baseline's is of");
  Json seed = proved();
  seed["tool"]["seed"] = 99;
  complaint(good, file("seed.json", seed), 2, "runs of other settings");
  Json field = proved();
  field["results"][0]["surprise"] = 1;
  complaint(good, file("field.json", field), 4, "results[].surprise: no rule says how it is compared");
  Json shard = proved();
  shard["shard"] = {{"number", 1}};
  complaint(good, file("shard.json", shard), 4, "one shard of a run");
  Json verdict = proved();
  verdict["results"][0]["verdict"] = "splendid";
  complaint(good, file("verdict.json", verdict), 4, "\"splendid\" where a verdict should be");
  Json negative = proved();
  negative["results"][0]["mismatches"] = -5;
  complaint(good, file("negative.json", negative), 4, "-5 where a number of things should be");
  std::ofstream(folder_ / "deep.json") << std::string(100'000, '[') << std::string(100'000, ']');
  complaint(good, folder_ / "deep.json", 4, "nested more than");
  complaint(good, file("twice.json", Json::array({bench_tree(), bench_tree()})), 4, "twice in one file");
  expect_complaint(program({"gate", "--baseline", good, good, "--bless"}), 2, "the result itself");
  expect_complaint(program({"gate", good}), 2, "--baseline");
  expect_complaint(program({"gate", "--baseline", good, good, "--tolerance", "nan"}), 2, "--tolerance");
}

}  // namespace
