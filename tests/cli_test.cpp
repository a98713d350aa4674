// The command line's contract: exit codes, messages, and what is printed where.
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/command.hpp"
#include "tests/sanitized.hpp"

namespace {

using namespace mmverify::tests;
using nlohmann::json;
using Arguments = std::vector<std::string>;

/// The whole text is one JSON value, or the test fails.
json parsed(const std::string& text) {
  json value = json::parse(text, nullptr, false);
  EXPECT_FALSE(value.is_discarded()) << text.substr(0, 200);
  return value;
}

std::vector<std::string> lines_with(const std::string& text, const std::string& words) {
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line.find(words) != std::string::npos) found.push_back(line);
  return found;
}

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

// ---------------------------------------------------------------------------------------------------------------------
// Usage
// ---------------------------------------------------------------------------------------------------------------------

struct Complaint {
  Arguments arguments;
  int exit_code;
  std::string words;
};

void PrintTo(const Complaint& c, std::ostream* out) {
  for (const std::string& a : c.arguments) *out << "'" << a << "' ";
}

class Usage : public testing::TestWithParam<Complaint> {};

TEST_P(Usage, IsOneLineAndAnExitCode) {
  expect_complaint(program(GetParam().arguments), GetParam().exit_code, GetParam().words);
}

const std::string replayed_law = "index.equals_reference";

INSTANTIATE_TEST_SUITE_P(
    Program, Usage,
    testing::Values(
        Complaint{{}, 2, "subcommand"}, Complaint{{"frobnicate"}, 2, ""}, Complaint{{"--frobnicate"}, 2, ""},
        Complaint{{"list", "more"}, 2, "more"}, Complaint{{"bench", "nothing"}, 2, "'nothing'"},
        Complaint{{"bench", "tree", "--subject", "step"}, 2, "--subject"},
        Complaint{{"bench", "tree", "--sweep"}, 2, "--sweep"},
        Complaint{{"bench", "--levels", "3..13"}, 2, "highest level here is 12"},
        Complaint{{"bench", "--plot", "x.svg"}, 2, "--plot"},
        Complaint{{"bench", "tree", "--samples", "1099511627776"}, 2, "--samples"},
        Complaint{{"bench", "vq", "--levels", "3"}, 2, "--levels"},
        Complaint{{"bench", "vq", "index", "--textures", "."}, 2, "--textures"},
        Complaint{{"bench", "vq", "--quiet", "--textures", "no/such/folder"}, 4, "no/such/folder"},
        Complaint{{"prove", "--seed", "18446744073709551616"}, 2, "below 2^64"},
        Complaint{{"bench", "--json", "no/such/folder/x.json", "index"}, 4, "no/such/folder/x.json"}));

INSTANTIATE_TEST_SUITE_P(
    Prove, Usage,
    testing::Values(
        Complaint{{"prove", "no.such.law"}, 2, "'no.such.law'"},
        Complaint{{"prove", "index.in_range", "no.such.law"}, 2, "'no.such.law'"},
        Complaint{{"prove", "index."}, 2, "'index.'"}, Complaint{{"prove", ""}, 2, "''"},
        Complaint{{"prove", "--levels", "5..2"}, 2, "5 comes after 2"},
        Complaint{{"prove", "--levels", "3..99"}, 2, "highest level is 30"},
        Complaint{{"prove", "--levels", "31"}, 2, "highest level is 30"},
        Complaint{{"prove", "--levels", "x"}, 2, "write A..B"},
        Complaint{{"prove", "--levels", "1.."}, 2, "write A..B"},
        Complaint{{"prove", "--levels", "1...3"}, 2, "write A..B"},
        Complaint{{"prove", "--levels", "-1"}, 2, "levels"},
        Complaint{{"prove", "--levels", "99999999999999999999"}, 2, "write A..B"},
        // What an unset variable of a script comes to; it must not mean every level.
        Complaint{{"prove", "index.in_range", "--levels", ""}, 2, "levels"},
        Complaint{{"prove", "--levels"}, 2, "--levels"},
        Complaint{{"prove", "--subject", "nobody"}, 2, "'nobody'"},
        Complaint{{"prove", "--subject", ""}, 2, "subject"},
        Complaint{{"prove", "--subject", "missing.so"}, 4, "missing.so: no such file"},
        Complaint{{"prove", "--subject", "no/such/file"}, 4, "no/such/file: no such file"},
        Complaint{{"prove", "--threads", "0"}, 2, "--threads"},
        Complaint{{"prove", "--threads", "two"}, 2, "--threads"},
        Complaint{{"prove", "--errors", "0"}, 2, "--errors"},
        Complaint{{"prove", "--seed", "x"}, 2, "--seed"}, Complaint{{"prove", "--tier", "slow"}, 2, "slow"},
        Complaint{{"prove", "--frobnicate"}, 2, "frobnicate"},
        Complaint{{"prove", "index.in_range", "--json", "no/such/folder/x.json"}, 4, "no/such/folder/x.json"},
        Complaint{{"prove", "index.in_range", "--junit", "no/such/folder/x.xml"}, 4, "no/such/folder/x.xml"},
        Complaint{{"prove", "index.in_range", "--json", "/"}, 4, "/: "}));

INSTANTIATE_TEST_SUITE_P(
    Replay, Usage,
    testing::Values(
        Complaint{{"replay"}, 2, "law"},
        Complaint{{"replay", "no.such.law", "--level", "1", "--case", "k=0"}, 2, "'no.such.law'"},
        // A topic is not a law.
        Complaint{{"replay", "index", "--level", "1", "--case", "k=0"}, 2, "'index'"},
        Complaint{{"replay", replayed_law, "--case", "u=0,v=0"}, 2, "--level"},
        Complaint{{"replay", replayed_law, "--level", "1"}, 2, "--case"},
        Complaint{{"replay", replayed_law, "--level", "1..2", "--case", "u=0,v=0"}, 2, "1..2"},
        Complaint{{"replay", replayed_law, "--level", "x", "--case", "u=0,v=0"}, 2, "x"},
        Complaint{{"replay", replayed_law, "--level", "31", "--case", "u=0,v=0"}, 2, "highest level is 30"},
        Complaint{{"replay", "index.nested", "--level", "16", "--case", "u=0,v=0"}, 2, "up to level 16"},
        Complaint{{"replay", replayed_law, "--level", "3", "--case", "garbage"}, 2, "'garbage'"},
        Complaint{{"replay", replayed_law, "--level", "3", "--case", ""}, 2, "''"},
        Complaint{{"replay", replayed_law, "--level", "3", "--case", "u=1/0,v=0"}, 2, "divides by zero"},
        Complaint{
            {"replay", replayed_law, "--level", "3", "--case", "u=09/10,v=1"}, 2, "outside the triangle"},
        Complaint{{"replay", replayed_law, "--level", "3", "--case", "u=1,v=1"}, 2, "outside the triangle"},
        // Whoever judges binary32 numbers must not be shown another point than the one asked for.
        Complaint{{"replay", replayed_law, "--level", "3", "--case", "u=1/3,v=0", "--subject", "impl"},
                  2,
                  "binary32"},
        Complaint{{"replay", "index.inverse", "--level", "1", "--case", "k=4"}, 2, "k=3"},
        Complaint{{"replay", "index.bijective", "--level", "1", "--case", "u=0,v=0"}, 2, "not inside"},
        Complaint{{"replay", "index.cells_decide", "--level", "1", "--case", "u=0,v=0"},
                  2,
                  "not judged case by case"},
        Complaint{{"replay", "index.corners", "--level", "1", "--case", "k=0", "--subject", "step-f32"},
                  2,
                  "no entry point"},
        Complaint{{"replay", replayed_law, "--level", "1", "--case", "u=0,v=0", "--subject", "missing.so"},
                  4,
                  "no such file"},
        Complaint{{"replay", replayed_law, "--level", "1", "--case", "u=0,v=0", "--picture",
                   "no/such/folder/x.svg"},
                  4,
                  "no/such/folder/x.svg"}));

TEST(Help, IsExitCode0OnStdout) {
  for (const Arguments& arguments :
       {Arguments{"--help"}, Arguments{"--version"}, Arguments{"prove", "--help"}, Arguments{"replay", "-h"},
        Arguments{"list", "--help"}, Arguments{"bench", "--help"}}) {
    const Outcome r = program(arguments);
    EXPECT_EQ(r.exit_code, 0) << arguments.front();
    EXPECT_FALSE(r.out.empty());
    EXPECT_EQ(r.err, "");
  }
  for (const char* command : {"list", "prove", "replay", "bench"})
    EXPECT_TRUE(says(program({"--help"}).out, command));
}

TEST(Complaints, ObeyNoControlCharacters) {
  const Outcome r =
      program({"replay", "index.in_range", "--level", "3", "--case", "\x1b[2Jred\r\n", "--subject", "step"});
  expect_complaint(r, 2, "'\\x1b[2Jred\\x0d\\x0a'");
}

TEST(List, NamesTheSameLawsAndSubjectsInTextAndJson) {
  const Outcome text = program({"list"}), as_json = program({"list", "--json"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_EQ(as_json.exit_code, 0);
  EXPECT_EQ(text.err + as_json.err, "");
  const json all = parsed(as_json.out);
  std::set<std::string> ids;
  for (const json& law : all["laws"]) {
    ids.insert(law["law"]);
    EXPECT_TRUE(says(text.out, law["law"]));
    for (const char* key : {"statement", "source", "domain", "method", "topic"})
      EXPECT_FALSE(law[key].get<std::string>().empty()) << key;
    EXPECT_TRUE(says(text.out, law["statement"]));
    EXPECT_GE(law["mutants"].size(), 3u);
    EXPECT_FALSE(law["subjects"].empty());
    // null: no part of the fast tier.
    const json fast = law["tiers"]["fast"];
    EXPECT_TRUE(fast.is_null() || fast["expected_seconds"].get<double>() > 0) << law["law"];
  }
  EXPECT_EQ(ids.size(), all["laws"].size());
  EXPECT_TRUE(ids.contains("index.equals_reference"));
  EXPECT_GE(all["subjects"].size(), 13u);  // those that the design lists
  for (const json& s : all["subjects"]) EXPECT_TRUE(says(text.out, s["subject"]));
}

// ---------------------------------------------------------------------------------------------------------------------
// Verdicts
// ---------------------------------------------------------------------------------------------------------------------

TEST(Prove, AllRightIs0) {
  const Outcome r = program({"prove", "index.in_range", "--levels", "0..3", "--subject", "step", "--quiet"});
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(lines_with(r.out, "proved     index.in_range").size(), 4u);
  EXPECT_TRUE(says(r.out, "subject step: proved"));
  EXPECT_TRUE(says(r.out, "3 of 3 mutants killed"));
}

TEST(Prove, ARefutedReadingIs1AndItsReplayLineShowsItAgain) {
  const Outcome r = program(
      {"prove", "index.equals_reference", "--subject", "step-appendix-middle", "--levels", "3", "--quiet"});
  EXPECT_EQ(r.exit_code, 1);
  // The hand trace of spec_index_test.cpp.
  const auto lines = lines_with(r.out, "replay: ");
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(
      lines[0].starts_with("refuted index.equals_reference level 3 case v:u=1/4,v=1/4 (0x1p-2,0x1p-2) "
                           "expected 20 got 23"))
      << lines[0];
  const Outcome again = shell(lines[0].substr(lines[0].find("replay: ") + 8));
  EXPECT_EQ(again.exit_code, 1) << again.err;
  EXPECT_TRUE(again.out.starts_with("refuted ")) << again.out;
  EXPECT_TRUE(says(again.out, "expected 20 got 23")) << again.out;
  EXPECT_TRUE(says(r.out, "subject step-appendix-middle: refuted"));
}

TEST(Prove, ErrorsKeepsAsManyCounterexamplesAndEachReplays) {
  const Outcome r = program({"prove", "index.equals_reference", "--subject", "step-appendix-names",
                             "--levels", "4", "--errors", "5", "--quiet"});
  EXPECT_EQ(r.exit_code, 1);
  const auto lines = lines_with(r.out, "replay: ");
  EXPECT_EQ(lines.size(), 5u);
  EXPECT_EQ(std::set<std::string>(lines.begin(), lines.end()).size(), lines.size());
  for (const std::string& line : lines) {
    const Outcome again = shell(line.substr(line.find("replay: ") + 8));
    EXPECT_EQ(again.exit_code, 1) << line;
    const std::string answers =
        line.substr(line.find("expected "), line.find("   replay") - line.find("expected "));
    EXPECT_TRUE(says(again.out, answers)) << again.out;
  }
}

// One run settles every level: it says so, has no level, and takes no heed of --levels.
TEST(Prove, AnInductionIsProvedForAllLevelsAtOnce) {
  Folder folder;
  const Outcome r = program({"prove", "index.all_levels", "index.wide_is_vulkan", "--levels", "3..5",
                             "--quiet", "--no-mutants", "--json", folder / "r.json"});
  EXPECT_EQ(r.exit_code, 0) << r.out << r.err;
  EXPECT_EQ(lines_with(r.out, "proved (induction) index.all_levels").size(), 1u);
  EXPECT_EQ(lines_with(r.out, "proved (bit vectors) index.wide_is_vulkan").size(), 1u);
  EXPECT_TRUE(says(r.out, "all levels"));
  const json results = parsed(text_of(folder / "r.json"))["results"];
  ASSERT_EQ(results.size(), 2u);
  for (const json& result : results) {
    EXPECT_EQ(result["verdict"], "proved");
    EXPECT_TRUE(result["level"].is_null());
    EXPECT_EQ(result["cases_run"], result["cases_expected"]);
  }
  EXPECT_TRUE(says(results[0]["method"], "induction, z3"));
}

TEST(Prove, WhereAnInductionFailsAPointShowsWhy) {
  const Outcome r =
      program({"prove", "index.all_levels", "--subject", "step-appendix-ties", "--errors", "2", "--quiet"});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_TRUE(says(r.out, "1 of 14 statements not proved")) << r.out;
  const auto lines = lines_with(r.out, "replay: ");
  ASSERT_EQ(lines.size(), 1u);  // the lowest level has one wrong cell
  EXPECT_TRUE(lines[0].starts_with("refuted index.all_levels level 2 case e:u=3/8,v=3/8 "));
  const Outcome again = shell(lines[0].substr(lines[0].find("replay: ") + 8));
  EXPECT_EQ(again.exit_code, 1) << again.err;
  EXPECT_TRUE(says(again.out, "expected 6 got 5")) << again.out;
  const Outcome other = program({"prove", "index.all_levels", "--subject", "impl", "--quiet"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(says(other.out, "no statements about impl")) << other.out;
}

// The cells decide nothing about a float instance but themselves: the domain says so, and floats are tried
// too.
TEST(Prove, AFloatSubjectIsJudgedOnFloatsToo) {
  Folder folder;
  const Outcome r = program({"prove", "index.equals_reference", "--subject", "step-f32", "--levels", "4",
                             "--quiet", "--json", folder / "r.json"});
  EXPECT_EQ(r.exit_code, 1);
  EXPECT_TRUE(says(r.out, "subject step-f32: refuted"));
  const json results = parsed(text_of(folder / "r.json"))["results"];
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0]["law"], "index.equals_reference");
  EXPECT_EQ(results[0]["verdict"], "proved");
  EXPECT_TRUE(says(results[0]["domain"], "representatives"));
  EXPECT_FALSE(says(results[0]["domain"], "every"));
  EXPECT_EQ(results[1]["law"], "index.exact_on_floats");
  EXPECT_EQ(results[1]["verdict"], "refuted");
}

TEST(Prove, NothingThatAppliesIs2) {
  for (const Arguments& arguments :
       {Arguments{"prove", "index.corners", "--subject", "step-f32", "--quiet"},
        Arguments{"prove", "paper.step_equals_reference", "--subject", "impl", "--levels", "1", "--quiet"},
        Arguments{"prove", "index.nested", "--levels", "16", "--quiet"},
        Arguments{"prove", "index.nested", "--subject", "tree-ranked", "--quiet"},
        Arguments{"prove", "tree.round_trip", "--subject", "step", "--quiet"}}) {
    const Outcome r = program(arguments);
    EXPECT_EQ(r.exit_code, 2) << arguments[1];
    EXPECT_TRUE(says(r.out, "n/a")) << r.out;
    EXPECT_TRUE(r.err.starts_with("mmverify: nothing was run")) << r.err;
    EXPECT_EQ(lines_with(r.err, "").size(), 1u) << r.err;
  }
}

TEST(Prove, OneThatAppliesAmongOthersIs0) {
  const Outcome r = program({"prove", "index.corners", "index.rounded_arithmetic_errs", "--subject",
                             "step-f32", "--levels", "1", "--quiet"});
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(lines_with(r.out, "n/a").size(), 1u);
}

TEST(Prove, CountsAndDigestsAreTheSameForOneThreadAndTwo) {
  const auto run = [](const char* threads) {
    const Outcome r = program({"prove", "index.in_range", "index.bijective", "--subject", "reference",
                               "--levels", "8..9", "--quiet", "--threads", threads, "--json", "-"});
    EXPECT_EQ(r.exit_code, 0);
    return parsed(r.out);
  };
  const json one = run("1"), two = run("2");
  EXPECT_EQ(one["tool"]["threads"], 1);
  EXPECT_EQ(two["tool"]["threads"], 2);
  ASSERT_EQ(one["results"].size(), 4u);
  ASSERT_EQ(two["results"].size(), 4u);
  for (std::size_t k = 0; k < 4; ++k)
    for (const char* key : {"law", "level", "verdict", "cases_run", "by_kind", "digest"})
      EXPECT_EQ(one["results"][k][key], two["results"][k][key]) << key;
}

TEST(Prove, WithoutMutantsItSaysSo) {
  const Outcome r = program({"prove", "index.in_range", "--levels", "2", "--quiet", "--no-mutants"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  EXPECT_TRUE(says(r.out, "; no mutants run; ")) << r.out;
  const json run = parsed(
      program({"prove", "index.in_range", "--levels", "2", "--quiet", "--no-mutants", "--json", "-"}).out);
  EXPECT_TRUE(run["mutants"].empty());
}

TEST(Prove, TheSeedDecidesTheSample) {
  const auto digest = [](const char* seed) {
    const Outcome r = program({"prove", "index.cells_decide", "--subject", "reference", "--levels", "4",
                               "--quiet", "--seed", seed, "--json", "-"});
    EXPECT_EQ(r.exit_code, 0);
    const json run = parsed(r.out);
    EXPECT_EQ(run["results"][0]["verdict"], "checked");
    EXPECT_EQ(std::to_string(run["tool"]["seed"].get<int>()), seed);
    return run["results"][0]["digest"].get<std::string>();
  };
  EXPECT_EQ(digest("7"), digest("7"));
  EXPECT_NE(digest("7"), digest("8"));
}

// ---------------------------------------------------------------------------------------------------------------------
// Interrupts
// ---------------------------------------------------------------------------------------------------------------------

class Interrupt : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Signal, Interrupt, testing::Values(SIGINT, SIGTERM),
                         [](const auto& signal) { return signal.param == SIGINT ? "SIGINT" : "SIGTERM"; });

// Levels 12 to 16 have 17 000 million cells: the signal always comes before the end.
TEST_P(Interrupt, Is3AndProvesNothingThatWasNotFinished) {
  Folder folder;
  Process process(program_with({"prove", "index.equals_reference", "--subject", "step", "--levels", "9..16",
                                "--quiet", "--json", folder / "r.json", "--junit", folder / "r.xml"}));
  ASSERT_TRUE(process.says("level 9"));
  process.send(GetParam());
  const Outcome r = process.wait();
  EXPECT_EQ(r.exit_code, 3) << r.err;
  EXPECT_TRUE(says(r.out, "subject step: incomplete"));
  const json results = parsed(text_of(folder / "r.json"))["results"];
  ASSERT_EQ(results.size(), 8u);
  EXPECT_EQ(results.front()["verdict"], "proved");
  EXPECT_EQ(results.back()["verdict"], "incomplete");
  for (const json& one : results) {
    const bool finished = one["cases_run"] == one["cases_expected"];
    EXPECT_EQ(one["verdict"], finished ? "proved" : "incomplete") << one;
    EXPECT_EQ(one.contains("reason"), !finished);
  }
  pugi::xml_document junit;
  EXPECT_TRUE(junit.load_string(text_of(folder / "r.xml").c_str()));
  EXPECT_GT(junit.child("testsuites").attribute("errors").as_int(), 0);
  EXPECT_EQ(folder.files().size(), 2u);
}

// A bench of all levels takes minutes.
TEST_P(Interrupt, OfABenchIs3AndLeavesNoFile) {
  Folder folder;
  Process process(program_with({"bench", "tree", "--json", folder / "b.json"}));
  ASSERT_TRUE(process.says("bench tree: level"));
  process.send(GetParam());
  const Outcome r = process.wait();
  EXPECT_EQ(r.exit_code, 3) << r.out;
  EXPECT_TRUE(says(r.err, "interrupted; no file was written")) << r.err;
  EXPECT_TRUE(folder.files().empty());
}

// ---------------------------------------------------------------------------------------------------------------------
// Bench
// ---------------------------------------------------------------------------------------------------------------------

TEST(Bench, WithNoTopicIsOfAllAndItsJsonAList) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome r =
      program({"bench", "--levels", "3", "--samples", "2000", "--maps", "1", "--quiet", "--json", "-"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const json benches = parsed(r.out);
  ASSERT_EQ(benches.size(), 4u);
  EXPECT_EQ(benches[3]["topic"], "bake");
  EXPECT_EQ(benches[2]["topic"], "vq");
  EXPECT_EQ(benches[0]["topic"], "index");
  EXPECT_EQ(benches[1]["topic"], "tree");
  for (const json& bench : benches) EXPECT_FALSE(bench["rows"].empty());
}

TEST(Bench, BakeSaysWhatEachBakerGetsWrongBesideTheExactStates) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome r = program({"bench", "bake", "--levels", "5", "--maps", "1", "--quiet", "--json", "-"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const json bench = parsed(r.out);
  EXPECT_EQ(bench["topic"], "bake");
  ASSERT_EQ(bench["rows"].size(), 1u);
  const json& bakers = bench["rows"][0]["bakers"];
  ASSERT_EQ(bakers.size(), 6u);
  EXPECT_GT(bakers[0]["wrong"], 0);
  EXPECT_EQ(bakers[4]["baker"], "ours, exact");
  EXPECT_EQ(bakers[4]["wrong"], 0);
  EXPECT_EQ(bakers[4]["needless"], 0);
  EXPECT_TRUE(says(r.err, "Margins")) << "the table";
}

TEST(Bench, VqSaysWhatEachEncoderLosesAndItsBound) {
  SKIP_A_REPEAT_UNDER_SANITIZERS();
  const Outcome r = program({"bench", "vq", "--maps", "2", "--quiet", "--json", "-"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const json bench = parsed(r.out);
  EXPECT_EQ(bench["topic"], "vq");
  ASSERT_EQ(bench["rows"].size(), 2u);
  for (const json& row : bench["rows"]) {
    ASSERT_EQ(row["vq2"].size(), 3u);
    ASSERT_EQ(row["vq4"].size(), 6u);
    for (const json& by : row["vq4"]) EXPECT_GE(by["substitutions"], row["vq4_bound"]);
    EXPECT_EQ(row["vq2"][2]["substitutions"], row["vq2_bound"]);
  }
  EXPECT_TRUE(says(r.err, "bound")) << "the table";
}

TEST(Bench, TreeSaysWhatAFormTakesAndHowFastItIs) {
  const Outcome r =
      program({"bench", "tree", "--levels", "3..4", "--samples", "2000", "--quiet", "--json", "-"});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  const json bench = parsed(r.out);
  EXPECT_EQ(bench["topic"], "tree");
  EXPECT_TRUE(says(r.err, "paper / ours"));
}

// ---------------------------------------------------------------------------------------------------------------------
// Replay
// ---------------------------------------------------------------------------------------------------------------------

TEST(Replay, ACaseThatHoldsIs0) {
  const Outcome r = program({"replay", "index.equals_reference", "--level", "3", "--case", "v:u=1/4,v=1/4"});
  EXPECT_EQ(r.exit_code, 0);
  EXPECT_EQ(r.out,
            "holds index.equals_reference level 3 case v:u=1/4,v=1/4 subject step expected 20 got 20\n");
  EXPECT_EQ(r.err, "");
}

TEST(Replay, AMapOfLevel8IsRead) {
  std::string map = "2-state:";
  for (int k = 0; k < 32'768; ++k) map += "01";
  const Outcome r = program({"replay", "tree.on_samples", "--level", "8", "--case", map});
  EXPECT_EQ(r.exit_code, 0) << r.err;
  expect_complaint(program({"replay", "tree.on_samples", "--level", "8", "--case", map + "0"}), 2,
                   "level 8 has");
}

// (3/8, 1/4), level 3: N = 8, iu = 3, iv = 2, no fractions, NOT iw = 5; b0 = 011b XOR 101b = 110b,
// t = (011b XOR 010b) AND b0 = 0, b1 = 011b AND 001b = 001b; interleaved 10110b = 22.
TEST(Replay, OneNumberHoweverItIsWritten) {
  for (const char* text : {"u=3/8,v=1/4", "v:u=3/8,v=1/4", "u=6/16,v=2/8", "u=0x1.8p-2,v=0x1p-2",
                           "u=0.375,v=0.25", "u=03/8,v=01/4"}) {
    const Outcome r = program({"replay", "index.equals_reference", "--level", "3", "--case", text});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_TRUE(says(r.out, "expected 22 got 22")) << r.out;
  }
}

}  // namespace
