// The files that the command line writes: whole and valid, or not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <string>
#include <vector>

#include "tests/command.hpp"

namespace {

using namespace mmverify::tests;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> quick_files{"prove",    "index.in_range", "--subject", "step",
                                           "--levels", "0..2",           "--quiet"};

std::vector<std::string> with_files(std::vector<std::string> arguments,
                                    const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

void expect_sound(const json& run) {
  EXPECT_EQ(run["schema"], "mmverify.result/1");
  const json& tool = run["tool"];
  EXPECT_TRUE(std::regex_match(tool["spec_hash"].get<std::string>(), std::regex("[0-9a-f]{64}")));
  for (const char* key : {"version", "compiler", "flags", "cpu"}) EXPECT_TRUE(tool[key].is_string()) << key;
  for (const char* key : {"threads", "seed"}) EXPECT_TRUE(tool[key].is_number_unsigned()) << key;
  ASSERT_FALSE(run["results"].empty());
  for (const json& r : run["results"]) {
    for (const char* key : {"law", "topic", "subject", "method", "domain", "verdict"})
      EXPECT_FALSE(r[key].get<std::string>().empty()) << key;
    if (r["verdict"] == "proved") {
      EXPECT_EQ(r["cases_run"], r["cases_expected"]);
      EXPECT_GT(r["cases_run"], 0);
    }
    std::uint64_t cases = 0, mismatches = 0;
    for (const char* kind : {"vertex", "edge", "interior"}) {
      cases += r["by_kind"][kind]["cases"].get<std::uint64_t>();
      mismatches += r["by_kind"][kind]["mismatches"].get<std::uint64_t>();
    }
    EXPECT_EQ(r["cases_run"], cases);
    EXPECT_EQ(r["mismatches"], mismatches);
    EXPECT_EQ(r["verdict"] == "refuted", mismatches != 0);
    EXPECT_EQ(r["counterexample"].is_null(), mismatches == 0);
    EXPECT_TRUE(std::regex_match(r["digest"].get<std::string>(), std::regex("[0-9a-f]{16}")));
    EXPECT_GE(r["seconds"].get<double>(), 0);
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// JSON
// ---------------------------------------------------------------------------------------------------------------------

TEST(Json, AFileIsWholeAndAlone) {
  Folder folder;
  EXPECT_EQ(program(with_files(quick_files, {"--json", folder / "r.json"})).exit_code, 0);
  EXPECT_THAT(folder.files(), ElementsAre("r.json"));
  const json run = json::parse(text_of(folder / "r.json"));
  expect_sound(run);
  ASSERT_EQ(run["results"].size(), 3u);
  for (int n = 0; n < 3; ++n) {
    const int N = 1 << n;
    EXPECT_EQ(run["results"][static_cast<std::size_t>(n)]["level"], n);
    EXPECT_EQ(run["results"][static_cast<std::size_t>(n)]["cases_run"], 3 * N * N + 3 * N + 1);
  }
  EXPECT_EQ(run["mutants"].size(), 3u);
  for (const json& m : run["mutants"]) EXPECT_EQ(m["killed"], true);
  // One version, two ways to ask.
  EXPECT_THAT(program({"--version"}).out,
              HasSubstr(run["tool"]["spec_hash"].get<std::string>().substr(0, 12)));
}

TEST(Json, OnStdoutItIsAlone) {
  const Outcome r = program(with_files(quick_files, {"--json", "-"}));
  EXPECT_EQ(r.exit_code, 0);
  expect_sound(json::parse(r.out));  // throws where anything else is printed
  EXPECT_THAT(r.err, HasSubstr("proved"));
}

TEST(Json, HoldsTheCounterexampleOfARefutation) {
  const Outcome r = program({"prove", "index.equals_reference", "--subject", "step-appendix-middle",
                             "--levels", "3", "--errors", "3", "--quiet", "--json", "-"});
  EXPECT_EQ(r.exit_code, 1);
  const json run = json::parse(r.out);
  expect_sound(run);
  // The hand trace of spec_index_test.cpp.
  const json c = run["results"][0]["counterexample"];
  EXPECT_EQ(c["case"], "v:u=1/4,v=1/4");
  EXPECT_EQ(c["hex"], "(0x1p-2,0x1p-2)");
  EXPECT_EQ(c["expected"], "20");
  EXPECT_EQ(c["got"], "23");
  EXPECT_EQ(c["level"], 3);
  EXPECT_EQ(run["results"][0]["more_counterexamples"].size(), 2u);
  EXPECT_EQ(shell(c["replay"]).exit_code, 1);
}

TEST(Json, SaysWhyALawDoesNotApply) {
  const Outcome r = program({"prove", "index.corners", "--subject", "step-f32", "--quiet", "--json", "-"});
  EXPECT_EQ(r.exit_code, 2);
  const json run = json::parse(r.out);
  expect_sound(run);
  EXPECT_EQ(run["results"][0]["verdict"], "not_applicable");
  EXPECT_THAT(run["results"][0]["reason"].get<std::string>(), HasSubstr("no entry point"));
}

TEST(Json, ReplacesAnOlderFileOnlyWhenItIsDone) {
  Folder folder;
  std::ofstream(folder / "r.json") << "the older one";
  // Usage is settled before the file is touched, and a refused case before a picture is.
  EXPECT_EQ(program({"prove", "no.such.law", "--json", folder / "r.json"}).exit_code, 2);
  EXPECT_EQ(text_of(folder / "r.json"), "the older one");
  EXPECT_EQ(program(with_files(quick_files, {"--json", folder / "r.json"})).exit_code, 0);
  expect_sound(json::parse(text_of(folder / "r.json")));
  EXPECT_THAT(folder.files(), ElementsAre("r.json"));
}

// ---------------------------------------------------------------------------------------------------------------------
// Places that cannot be written
// ---------------------------------------------------------------------------------------------------------------------

class Unwritable : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Option, Unwritable, testing::Values("--json", "--junit"),
                         [](const auto& option) { return std::string(option.param).substr(2); });

TEST_P(Unwritable, IsKnownBeforeTheRunAndLeavesNothing) {
  Folder folder;
  fs::create_directory(folder / "a-folder");
  for (const fs::path& place : {folder / "missing/r", folder / "a-folder"})
    expect_complaint(program(with_files(quick_files, {GetParam(), place})), 4, place);
  EXPECT_THAT(folder.files(), ElementsAre("a-folder"));
  EXPECT_TRUE(fs::is_empty(folder / "a-folder"));
}

TEST_P(Unwritable, AFullDiskIs4) {
  const Outcome r = program(with_files(quick_files, {GetParam(), "/dev/full"}));
  EXPECT_EQ(r.exit_code, 4);
  EXPECT_THAT(r.err, HasSubstr("/dev/full"));
}

TEST(Unwritable, TheSecondFileLeavesNothingOfTheFirst) {
  Folder folder;
  expect_complaint(
      program(with_files(quick_files, {"--json", folder / "r.json", "--junit", folder / "missing/r.xml"})), 4,
      "r.xml");
  EXPECT_THAT(folder.files(), IsEmpty());
}

// Two results under one name would be a mixture of both.
TEST(Unwritable, OneFileForTwoResults) {
  Folder folder;
  const Outcome r = program(with_files(quick_files, {"--json", folder / "r", "--junit", folder / "r"}));
  EXPECT_NE(r.exit_code, 0);
  EXPECT_THAT(folder.files(), IsEmpty());
}

// A result that was lost is no success, were it a proof.
TEST(Unwritable, AFullDiskUnderStdoutIs4) {
  const std::vector<std::vector<std::string>> commands{
      quick_files,
      with_files(quick_files, {"--json", "-"}),
      {"list"},
      {"list", "--json"},
      {"replay", "index.in_range", "--level", "1", "--case", "u=0,v=0"}};
  for (const auto& command : commands) {
    const Outcome r = Process(program_with(command), "/dev/full").wait();
    EXPECT_EQ(r.exit_code, 4) << command[0] << " " << command.back();
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// JUnit
// ---------------------------------------------------------------------------------------------------------------------

struct Counts {
  int tests = 0, failures = 0, errors = 0, skipped = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts stated(const pugi::xml_node& node) {
  return {node.attribute("tests").as_int(-1), node.attribute("failures").as_int(-1),
          node.attribute("errors").as_int(-1), node.attribute("skipped").as_int(-1)};
}

/// The counts of the whole file, each suite's checked against what it holds.
Counts counted(const std::string& text) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(text.c_str()));
  Counts all;
  for (const pugi::xml_node& suite : document.child("testsuites").children("testsuite")) {
    Counts c;
    for (const pugi::xml_node& test : suite.children("testcase")) {
      ++c.tests;
      c.failures += test.child("failure") ? 1 : 0;
      c.errors += test.child("error") ? 1 : 0;
      c.skipped += test.child("skipped") ? 1 : 0;
    }
    EXPECT_EQ(stated(suite), c) << suite.attribute("name").value();
    all = {all.tests + c.tests, all.failures + c.failures, all.errors + c.errors, all.skipped + c.skipped};
  }
  EXPECT_EQ(stated(document.child("testsuites")), all);
  return all;
}

TEST(Junit, CountsResultsAndMutants) {
  Folder folder;
  const Outcome r = program({"prove", "index.in_range", "index.bijective", "--subject", "step", "--subject",
                             "w-minor", "--levels", "0..2", "--quiet", "--junit", folder / "r.xml"});
  EXPECT_EQ(r.exit_code, 0);
  // Two laws: step at three levels, w-minor skipped once, three mutants each.
  EXPECT_EQ(counted(text_of(folder / "r.xml")), (Counts{2 * (3 + 1 + 3), 0, 0, 2}));
  EXPECT_THAT(folder.files(), ElementsAre("r.xml"));
}

TEST(Junit, ARefutationIsAFailureWithItsCounterexample) {
  Folder folder;
  const Outcome r = program({"prove", "index.equals_reference", "--subject", "step-appendix-ties", "--levels",
                             "1..2", "--quiet", "--junit", folder / "r.xml"});
  EXPECT_EQ(r.exit_code, 1);
  const std::string text = text_of(folder / "r.xml");
  // Right at level 1, wrong at level 2 (spec_index_test.cpp), four mutants.
  EXPECT_EQ(counted(text), (Counts{2 + 4, 1, 0, 0}));
  EXPECT_THAT(text, HasSubstr("case e:u=3/8,v=3/8"));
  EXPECT_THAT(text, HasSubstr("expected 6 got 5"));
}

// ---------------------------------------------------------------------------------------------------------------------
// Pictures
// ---------------------------------------------------------------------------------------------------------------------

const std::vector<std::string> quarter{
    "replay",    "index.equals_reference", "--level", "3", "--case", "u=1/4,v=1/4",
    "--subject", "step-appendix-middle"};

TEST(Picture, IsAnSvgWithTheAnswers) {
  Folder folder;
  EXPECT_EQ(program(with_files(quarter, {"--picture", folder / "p.svg"})).exit_code, 1);
  EXPECT_THAT(folder.files(), ElementsAre("p.svg"));
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file((folder / "p.svg").c_str()));
  const pugi::xml_node svg = document.child("svg");
  EXPECT_STREQ(svg.attribute("xmlns").value(), "http://www.w3.org/2000/svg");
  std::vector<std::string> texts;
  for (const pugi::xml_node& text : svg.children("text")) texts.emplace_back(text.text().get());
  EXPECT_THAT(texts, testing::Contains("20"));
  EXPECT_THAT(texts, testing::Contains("23"));
  EXPECT_THAT(std::string(svg.child("title").text().get()), HasSubstr("(1/4, 1/4)"));
  // Level 3 is drawn whole: 64 numbers.
  for (int k = 0; k < 64; ++k) EXPECT_THAT(texts, testing::Contains(std::to_string(k)));
}

// At level 16 only a window can be drawn; the answers lie where the expected one is, or the legend says so.
TEST(Picture, OfTheFinestLevelHasTheAnswersInWords) {
  Folder folder;
  program({"replay", "index.equals_reference", "--level", "16", "--case", "u=1/4,v=1/4", "--subject",
           "step-appendix-middle", "--picture", folder / "p.svg"});
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file((folder / "p.svg").c_str()));
  // Digits 1, 1, 0 and then always the w-corner; Appendix A's order: 1, 1, 3 and then 2s, the corner of child
  // 3 that top-flip calls L:  20 * 4^13 = 1342177280.
  EXPECT_THAT(text_of(folder / "p.svg"), HasSubstr("1342177280"));
}

TEST(Picture, WhatCannotBeDrawnLeavesNothing) {
  Folder folder;
  fs::create_directory(folder / "a-folder");
  expect_complaint(program(with_files(quarter, {"--picture", folder / "a-folder"})), 4, "a-folder");
  expect_complaint(program(with_files(quarter, {"--picture", folder / "missing/p.svg"})), 4, "p.svg");
  expect_complaint(program({"replay", "index.equals_reference", "--level", "3", "--case", "garbage",
                            "--picture", folder / "p.svg"}),
                   2, "'garbage'");
  EXPECT_THAT(folder.files(), ElementsAre("a-folder"));
}

}  // namespace
