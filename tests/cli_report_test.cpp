// mmverify report, from outside: what goes in, what is said of what cannot, and what lies in the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command.hpp"

namespace {

using namespace mmverify::tests;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string said_by_prove(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"prove"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--quiet", "--no-mutants", "--json", "-"});
  return program(all).out;
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

/// A program built without its page has other things to test.
bool has_page() {
  static const bool has =
      program({"report", "/dev/null", "-o", "/dev/null"}).err.find("built without its page") ==
      std::string::npos;
  return has;
}

class Report : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_page()) GTEST_SKIP() << "this program was built without Node.js";
    // Asked for once, for all tests.
    static const std::string right = said_by_prove({"index.nested", "--subject", "step", "--levels", "0..2"});
    static const std::string wrong =
        said_by_prove({"index.equals_reference", "--subject", "step-appendix-middle", "--levels", "1..3"});
    write(right_, right);
    write(wrong_, wrong);
  }

  Outcome report(const std::vector<fs::path>& files) const {
    std::vector<std::string> arguments{"report", "-o", page_};
    arguments.insert(arguments.end(), files.begin(), files.end());
    return program(arguments);
  }

  /// What the page has to show.
  json data() const {
    const std::string html = text_of(page_), start = "<script type=\"application/json\" id=\"data\">";
    const std::size_t from = html.find(start) + start.size(), to = html.find("</script>", from);
    return json::parse(html.substr(from, to - from));
  }

  /// The page of a changed result.
  Outcome changed(const std::string& pointer, const json& value) const {
    json run = json::parse(text_of(wrong_));
    run[json::json_pointer(pointer)] = value;
    write(folder_ / "changed.json", run.dump());
    return report({folder_ / "changed.json"});
  }

  Folder folder_;
  const std::string right_ = folder_ / "right.json", wrong_ = folder_ / "wrong.json",
                    page_ = folder_ / "report.html";
};

// ---------------------------------------------------------------------------------------------------------------------
// The page
// ---------------------------------------------------------------------------------------------------------------------

TEST_F(Report, IsOneFileThatAsksForNothing) {
  const Outcome outcome = report({right_});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("report.html: a page of 1 file"));
  const std::string html = text_of(page_);
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  for (const char* away :
       {"<link rel=\"stylesheet\"", "<script src", "<img src=\"http", "@import", "url(http"})
    EXPECT_THAT(html, Not(HasSubstr(away)));
  EXPECT_THAT(folder_.files(), testing::UnorderedElementsAre("right.json", "wrong.json", "report.html"));
}

TEST_F(Report, HasAllFilesInTheirOrder) {
  ASSERT_EQ(report({wrong_, right_, wrong_}).exit_code, 0);
  const json page = data();
  EXPECT_EQ(page["schema"], "mmverify.report/1");
  std::vector<std::string> names;
  for (const json& file : page["files"]) names.push_back(file["name"]);
  EXPECT_THAT(names, ElementsAre(wrong_, right_, wrong_));
  EXPECT_EQ(page["files"][1]["content"]["results"].size(), 3u);
}

TEST_F(Report, AsksBuiltInSubjectsAgain) {
  ASSERT_EQ(report({right_, wrong_}).exit_code, 0);
  const json page = data();
  ASSERT_EQ(page["asked"].size(), 1u);
  const json& asked = page["asked"][0];
  EXPECT_EQ(asked["subject"], "step-appendix-middle");
  EXPECT_EQ(asked["order"], "curve");
  ASSERT_EQ(asked["levels"].size(), 7u);
  for (std::size_t n = 0; n < 7; ++n) {
    const json& level = asked["levels"][n];
    const std::size_t N = std::size_t{1} << n;
    EXPECT_EQ(level["level"], n);
    EXPECT_EQ(level["cells"], 3 * N * N + 3 * N + 1);
    EXPECT_EQ(level["wrong"].size(), 4 * level["wrong_cells"].get<std::size_t>());
  }
  // As many as the run had.
  const json run = json::parse(text_of(wrong_));
  for (const json& r : run["results"])
    EXPECT_EQ(asked["levels"][r["level"].get<std::size_t>()]["wrong_cells"], r["mismatches"]);
  ASSERT_EQ(page["again"].size(), 2u);
  const json& again = page["again"][0];
  EXPECT_EQ(again["file"], 1);
  EXPECT_EQ(again["same_source"], true);
  EXPECT_EQ(again["holds"], false);
  EXPECT_EQ(again["expected"],
            run["results"][again["result"].get<std::size_t>()]["counterexample"]["expected"]);
}

TEST_F(Report, AsksOnTheLevelOfACounterexampleToo) {
  write(wrong_,
        said_by_prove({"index.equals_reference", "--subject", "step-appendix-ties", "--levels", "9"}));
  ASSERT_EQ(report({wrong_}).exit_code, 0);
  const json levels = data()["asked"][0]["levels"];
  ASSERT_EQ(levels.size(), 8u);
  EXPECT_EQ(levels[7]["level"], 9);  // no rationals up there
  // Around the counterexample all is listed.
  const json &wrong = levels[7]["wrong"], window = levels[7]["window"];
  ASSERT_EQ(window.size(), 4u);
  ASSERT_FALSE(wrong.empty());
  EXPECT_LT(wrong.size() / 4, levels[7]["wrong_cells"].get<std::size_t>());
  for (std::size_t k = 0; k < wrong.size(); k += 4)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_GE(wrong[k + axis], window[2 * axis]);
      EXPECT_LE(wrong[k + axis], window[2 * axis + 1]);
    }
}

TEST_F(Report, AsksInRowOrderWhereThatIsTheLaws) {
  json run = json::parse(said_by_prove({"index.row_order", "--subject", "impl", "--levels", "2"}));
  json& result = run["results"][0];
  result["verdict"] = "refuted";
  result["mismatches"] = result["by_kind"]["interior"]["mismatches"] = 1;
  result["counterexample"] = {{"case", "i:u=1/16,v=1/16"}, {"level", 2}, {"expected", "0"}, {"got", "1"}};
  write(wrong_, run.dump());
  ASSERT_EQ(report({wrong_}).exit_code, 0);
  const json page = data();
  EXPECT_EQ(page["asked"][0]["order"], "rows");
  // Nobody is wrong in truth, and the page can say so.
  EXPECT_EQ(page["again"][0]["holds"], true);
  for (const json& level : page["asked"][0]["levels"]) EXPECT_EQ(level["wrong_cells"], 0);
}

TEST_F(Report, HasTheStatesOfARefutedBaker) {
  write(wrong_, said_by_prove({"bake.conservative", "--subject", "centre-sample", "--levels", "2"}));
  ASSERT_EQ(report({wrong_}).exit_code, 0);
  const json again = data()["again"][0];
  const json& states = again["states"];
  EXPECT_EQ(states["level"], 2);
  for (const char* whose : {"expected", "got"}) {
    const std::string digits = states[whose];
    EXPECT_EQ(digits.size(), 16u);
    EXPECT_EQ(digits.find_first_not_of("0123"), std::string::npos);
  }
  EXPECT_NE(states["expected"], states["got"]);
  EXPECT_THAT(again["picture"].get<std::string>(), HasSubstr("<svg"));
}

TEST_F(Report, StartsNoLibraryAndSaysSo) {
  ASSERT_EQ(changed("/results/1/subject", "./mine.so").exit_code, 0);
  for (const json& again : data()["again"])
    if (again["result"] == 1) {
      EXPECT_THAT(again["why"].get<std::string>(), HasSubstr("not built in"));
    }
  ASSERT_EQ(changed("/results/1/law", "index.no_such_law").exit_code, 0);
  EXPECT_THAT(data()["again"][0]["why"].get<std::string>(), HasSubstr("no law"));
}

TEST_F(Report, SaysWhenItIsOfOtherSource) {
  ASSERT_EQ(changed("/tool/source_hash", "0000").exit_code, 0);
  EXPECT_EQ(data()["again"][0]["same_source"], false);
}

TEST_F(Report, SurvivesACaseThatNobodyCanRead) {
  ASSERT_EQ(changed("/results/1/counterexample/case", "u=1/0,v=2").exit_code, 0);
  EXPECT_TRUE(data()["again"][0].contains("why"));
}

TEST_F(Report, TakesScenesAndBenchesOfSeveralTopics) {
  const std::string scene = folder_ / "scene.json", bench = folder_ / "bench.json";
  ASSERT_EQ(
      program({"scene", "--level", "2", "--sizes", "1..2", "--samples", "20", "--quiet", "--json", scene})
          .exit_code,
      0);
  ASSERT_EQ(program({"bench", "index", "vq", "--levels", "1..2", "--samples", "50", "--maps", "1", "--quiet",
                     "--json", bench})
                .exit_code,
            0);
  const Outcome outcome = report({scene, bench});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json files = data()["files"];
  ASSERT_EQ(files.size(), 3u);
  EXPECT_EQ(files[0]["content"]["scene"]["sizes"].size(), 2u);
  EXPECT_EQ(files[1]["content"]["topic"], "index");
  EXPECT_EQ(files[2]["content"]["topic"], "vq");
  EXPECT_EQ(files[2]["name"], bench);
}

TEST_F(Report, TextsCannotEndTheirElement) {
  const std::string hostile = "</script><script>alert(1)</script><!--<script>{data}\u2028";
  for (const char* where : {"/results/0/subject", "/results/1/counterexample/got", "/tool/cpu"}) {
    ASSERT_EQ(changed(where, hostile).exit_code, 0) << where;
    const std::string html = text_of(page_);
    EXPECT_THAT(html, Not(HasSubstr("alert(1)</script>")));
    EXPECT_THAT(html, Not(HasSubstr("<!--<script>")));
    EXPECT_EQ(data()["files"][0]["content"][json::json_pointer(where)], hostile);
  }
}

TEST_F(Report, KeepsWhatItKnowsAndNothingElse) {
  json run = json::parse(text_of(wrong_));
  json deep = 1;
  for (int k = 0; k < 500; ++k) deep = json::array({deep});
  run["secret"] = deep;
  run["results"][0]["secret"] = "kept elsewhere";
  write(wrong_, run.dump());
  ASSERT_EQ(report({wrong_}).exit_code, 0);
  EXPECT_THAT(text_of(page_), Not(HasSubstr("kept elsewhere")));
}

// ---------------------------------------------------------------------------------------------------------------------
// What cannot be shown
// ---------------------------------------------------------------------------------------------------------------------

TEST_F(Report, BadFilesAreNamedAndLeaveNoPage) {
  const auto refuse = [&](const std::string& text, const std::string& words) {
    const fs::path file = folder_ / "bad.json";
    write(file, text);
    const Outcome outcome = report({right_, file});
    expect_complaint(outcome, 4, "bad.json");
    EXPECT_THAT(outcome.err, HasSubstr(words));
    EXPECT_FALSE(fs::exists(page_));
  };
  expect_complaint(report({folder_ / "no such file"}), 4, "no such file: cannot be read");
  expect_complaint(report({folder_.path()}), 4, folder_.path().string());
  refuse("", "parse error");
  refuse("{", "line 1, column 2");
  refuse("\xff\xfe", "parse error");
  refuse("[]", "no schema of mmverify");
  refuse("17", "no schema of mmverify");
  refuse(R"({"schema": 7})", "no schema of mmverify");
  refuse(R"({"schema": "sarif/2"})", "'sarif/2'");
  refuse(R"([{"schema": "mmverify.bench/1", "topic": "taste"}])",
         "bad.json[0].topic: one of \"index\", \"tree\"");
  refuse(R"({"schema": "mmverify.result/1"})", "no \"tool\"");
  refuse(std::string(100'000, '['), "parse error");
}

TEST_F(Report, AMisshapenPlaceIsNamed) {
  const auto refuse = [&](const std::string& pointer, const json& value, const std::string& words) {
    expect_complaint(changed(pointer, value), 4, words);
  };
  refuse("/results", json::array(),
         "changed.json.results: a list of 1 or more should stand here, not a list of 0");
  refuse("/results/1/level", "two",
         "changed.json.results[1].level: a whole number, 0 to 31, or null should stand here, not \"two\"");
  refuse("/results/1/level", 32, "results[1].level");
  refuse("/results/0/verdict", "perhaps", "results[0].verdict: one of \"proved\"");
  refuse("/results/0/seconds", -1, "results[0].seconds");
  refuse("/results/0/seconds", nullptr, "results[0].seconds");
  refuse("/results/1/counterexample", 5,
         "results[1].counterexample: null or an object should stand here, not 5");
  refuse("/results/1/counterexample/case", json::array(),
         "counterexample.case: a text should stand here, not a list");
  refuse("/tool/seed", std::string(200, 'x'), "tool.seed");
  refuse("/results/1/counterexample", nullptr, "results[1] (");
}

TEST_F(Report, AnUnwritablePlaceIsNamed) {
  expect_complaint(program({"report", right_, "-o", folder_ / "no/such/folder/r.html"}), 4,
                   "cannot be written");
  expect_complaint(program({"report", right_, "-o", folder_.path()}), 4, folder_.path().string());
  expect_complaint(program({"report", right_, "-o", "/dev/full"}), 4, "/dev/full");
}

TEST_F(Report, AnInputIsNotOverwritten) {
  const std::string before = text_of(right_);
  expect_complaint(program({"report", wrong_, right_, "-o", folder_ / "./right.json"}), 2,
                   "one of the results");
  EXPECT_EQ(text_of(right_), before);
}

TEST(ReportUsage, FilesAndPlaceAreNeeded) {
  expect_complaint(program({"report"}), 2, "--help");
  expect_complaint(program({"report", "a.json"}), 2, "--output");
  expect_complaint(program({"report", "-o", "a.html"}), 2, "result");
  expect_complaint(program({"report", "a.json", "-o", "-"}), 2, "-o -");
}

TEST(ReportUsage, WithoutAPageItSaysHowToGetOne) {
  if (has_page()) GTEST_SKIP() << "this program has its page";
  expect_complaint(program({"report", "a.json", "-o", "a.html"}), 4, "build anew");
}

}  // namespace
