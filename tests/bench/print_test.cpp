// [release alone] Tables as they are printed, and pictures in gnuplot's language, on small ones worked by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "bench/timing.hpp"
#include "cli/bench/csv.hpp"
#include "cli/bench/plot.hpp"
#include "cli/bench/tables.hpp"

namespace {

using namespace mmverify::bench;
using namespace mmverify::cli;
using testing::HasSubstr;
using testing::Not;

std::string printed(const Result& result) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* const out = open_memstream(&text, &size);
  print_result(out, result);
  std::fclose(out);
  std::string copy(text, size);
  std::free(text);
  return copy;
}

std::string printed(const Table& table) {
  const std::string all = printed(Result{.topic = "t", .settings = {}, .about = "", .tables = {table}});
  EXPECT_EQ(all.substr(0, 3), "t\n\n");
  return all.substr(3);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Value n(std::uint64_t number) { return number; }
Value rows(std::vector<Row> all) { return all; }

// ---- Tables

TEST(BenchPrint, HeadingsUnitsAndNumbersAsTheyAreAskedFor) {
  EXPECT_EQ(printed({.columns = {{.heading = "map", .leads = true},
                                 {.key = "a", .heading = "time", .unit = "ns", .print = {.digits = 1}},
                                 {.key = "b",
                                  .heading = "share",
                                  .print = {.digits = 1, .factor = per_cent, .unit = "%"}},
                                 {.key = "c"},
                                 {.heading = "rate", .print = {.type = 'e', .none = "none"}}},
                     .rows = {{"leaf", 2.25, 0.125, n(7), 0.001}, {"x", 1234.0, 1.0, n(8), Value()}}}),
            "map     time  share      rate\n"
            "          ns      %\n"
            "leaf     2.2   12.5  1.00e-03\n"
            "x     1234.0  100.0      none\n");
}

TEST(BenchPrint, SettingsAboutAndMembersComeBeforeTheTables) {
  EXPECT_EQ(printed(Result{.topic = "t",
                           .settings = {{"seed", n(1)}, {"samples", n(20000)}},
                           .about = "What it is",
                           .tables = {{.form = Form::members,
                                       .columns = {{.key = "file"},
                                                   {.key = "n", .heading = "triangles"},
                                                   {.key = "ms", .heading = "ready in", .unit = "ms"}},
                                       .rows = {{"x.glb", n(1234), 0.5}}}}}),
            "t: seed 1, samples 20,000\n"
            "What it is\n"
            "\n"
            "triangles  1,234\n"
            "ready in    0.50 ms\n");
}

TEST(BenchPrint, RowsWithinAreLinesBelowOneAnother) {
  EXPECT_EQ(printed({.columns = {{.heading = "level", .leads = true},
                                 {.heading = "unknown", .print = {.digits = 0}},
                                 {.heading = "bakers",
                                  .columns = {{.heading = "baker", .leads = true}, {.heading = "wrong"}}}},
                     .rows = {{n(3), 5.0, rows({{"centre", n(9)}, {"ours", n(0)}})},
                              {n(4), 6.0, rows({{"centre", n(1)}})}}}),
            "level  baker   unknown  wrong\n"
            "    3  centre        5      9\n"
            "       ours                 0\n"
            "    4  centre        6      1\n");
}

TEST(BenchPrint, RowsWithinAreColumnsSideBySideUnderTheirNames) {
  const std::vector<Column> figures{{.key = "form", .heading = "form"},
                                    {.key = "x", .heading = "bits", .print = {.digits = 0}},
                                    {.key = "y", .heading = "lookup", .unit = "ns", .print = {.digits = 0}}};
  EXPECT_EQ(printed({.columns = {{.heading = "level", .leads = true},
                                 {.heading = "forms", .columns = figures, .within = RowLayout::beside}},
                     .rows = {{n(3), rows({{"flat", 1.0, 2.0}})},
                              {n(4), rows({{"flat", 3.0, 4.0}, {"ours", 5.0, 6.0}})}}}),
            "            bits       lookup, ns\n"
            "level    flat  ours    flat  ours\n"
            "    3       1     -       2     -\n"
            "    4       3     5       4     6\n");
}

TEST(BenchPrint, AGroupThatComesInPartsIsPrintedTogether) {
  EXPECT_EQ(printed({.columns = {{.heading = "a", .group = "A"},
                                 {.heading = "b", .group = "B"},
                                 {.heading = "c", .group = "A"}},
                     .rows = {{n(1), n(2), n(3)}}}),
            " A      B\n"
            "a  c    b\n"
            "1  3    2\n");
}

TEST(BenchPrint, RowsThatDifferInTheLastLeadingColumnStandSideBySide) {
  EXPECT_EQ(printed({.columns = {{.heading = "subject", .leads = true},
                                 {.heading = "level", .leads = true},
                                 {.heading = "time"}},
                     .rows = {{"f16", n(4), n(11)}, {"f32", n(4), n(12)}, {"f32", n(16), n(13)}},
                     .beside = true}),
            "            time\n"
            "subject     4  16\n"
            "f16        11   -\n"
            "f32        12  13\n");
}

TEST(BenchPrint, AWideTableComesInPartsThatBeginAlike) {
  Table table{.columns = {{.heading = "level", .leads = true}}, .rows = {{n(3)}, {n(4)}}};
  for (int k = 0; k < 40; ++k) {
    table.columns.push_back({.heading = "a heading", .group = k < 30 ? "first" : "second"});
    for (Row& row : table.rows) row.push_back(n(static_cast<std::uint64_t>(k)));
  }
  const std::string text = printed(table);
  std::size_t parts = 0, headings = 0;
  for (const std::string& line : lines_of(text)) {
    EXPECT_LE(line.size(), 150u);
    parts += line.starts_with("level");
    for (std::size_t at = line.find("a heading"); at != std::string::npos;
         at = line.find("a heading", at + 1))
      ++headings;
  }
  EXPECT_EQ(parts, 4u);
  EXPECT_EQ(headings, 40u);
}

TEST(BenchPrint, WhatHasNoHeadingIsWrittenAlone) {
  EXPECT_EQ(printed(Result{
                .topic = "t",
                .settings = {},
                .about = "",
                .tables = {{.key = "rows", .caption = "C", .columns = {{.key = "a"}}, .rows = {{n(1)}}}}}),
            "t\n");
}

// ---- Pictures

picture::Panel crowded() {
  picture::Panel panel{.x = {.logarithmic = true}, .y = {.logarithmic = true}};
  for (int k = 0; k < 8; ++k)
    panel.series.push_back({.colour = picture::blue,
                            .joined = false,
                            .points = {{10 + 0.01 * k, k < 4 ? 0.0 : 1e-3, "subject " + std::to_string(k)}}});
  return panel;
}

TEST(BenchPlot, ASpreadIsThatOfTheRounds) {
  const Spread spread = spread_of({8, 2, 4}, 2);
  EXPECT_EQ(spread.median, 2);
  EXPECT_EQ(spread.least, 1);
  EXPECT_EQ(spread.most, 4);
}

TEST(BenchPlot, SaysWhatThePictureHolds) {
  const picture::Picture drawn{
      .width = 400,
      .height = 300,
      .rows = {{{.title = "it's_so",
                 .x = {.title = "x"},
                 .y = {.title = "y"},
                 .series = {{.name = "ours", .colour = picture::green, .points = {{1, 2}, {3, 4}}},
                            {.name = "without points", .colour = picture::blue}},
                 .key = picture::Key::top_left,
                 .thresholds = {{3, "the bound"}}}}},
      .note = "below"};
  const std::string script = plot_script(drawn, PlotFormat::svg);
  for (const char* part : {"size 400,300", "set title 'it''s\\_so'", "1 2 \"\"\n3 4 \"\"\n", "title 'ours'",
                           "title 'without points'", "key top left", "'the bound'", "'below'",
                           "unset logscale x", picture::green})
    EXPECT_THAT(script, HasSubstr(part));
  EXPECT_THAT(script, Not(HasSubstr("'none'")));
  EXPECT_THAT(plot_script({.width = 400, .height = 300, .rows = {{crowded()}}}, PlotFormat::svg),
              HasSubstr("'none'"));
  EXPECT_THAT(plot_script(drawn, PlotFormat::png), HasSubstr("pngcairo size 800,600"));
  EXPECT_THAT(script, Not(HasSubstr("xerrorbars")));
  const picture::Panel repeated{
      .series = {{.colour = "#123456", .points = {{2, 3, "", picture::Range{1.5, 4}}, {5, 6}}}}};
  EXPECT_THAT(
      plot_script({.width = 400, .height = 300, .rows = {{repeated}}}, PlotFormat::svg),
      testing::AllOf(HasSubstr("2 3 \"\" 1.5 4\n5 6 \"\" NaN NaN\n"),
                     HasSubstr("$series0 using 1:2:4:5 with xerrorbars pt 0 lw 1 lc rgb '#123456' notitle")));
}

TEST(Csv, HasALineARowAndNamesOfTablesWithin) {
  const Column form{.key = "form"}, bits{.key = "bits"};
  Table table{.key = "rows"};
  table.columns = {
      {.key = "of"}, {.key = "count"}, {.key = "forms", .columns = {form, bits}}, {.heading = "printed"}};
  const auto within = [](double flat, double tree) {
    return std::vector<Row>{{Value(std::string("flat")), Value(flat)},
                            {Value(std::string("tree")), Value(tree)}};
  };
  table.rows = {{Value(std::string("a, \"b\"")), Value(std::uint64_t{3}), Value(within(2, 0.5)), Value(1.0)},
                {Value(std::string("c")), Value(), Value(within(2, 1.25)), Value(1.0)}};
  Table more{.key = "more"};
  more.columns = {{.key = "x"}};
  more.rows = {{Value(0.1)}};
  Table drawn{.form = Form::printed};
  EXPECT_EQ(result_csv({.topic = "t", .settings = {}, .about = "", .tables = {table, more, drawn}}),
            "of,count,forms.flat.form,forms.flat.bits,forms.tree.form,forms.tree.bits\n"
            "\"a, \"\"b\"\"\",3,flat,2,tree,0.5\n"
            "c,,flat,2,tree,1.25\n"
            "\n"
            "x\n"
            "0.1\n");
}

}  // namespace
