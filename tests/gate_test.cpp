// The gate's comparison, figure by figure: which way a change points, and what is close enough to be none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "gate/compare.hpp"

namespace {

using namespace mmverify::gate;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

constexpr double tolerance = 1.5;

Value value(const std::string& json) {
  const Json j = Json::parse(json);
  return {json, j.is_number() ? j.get<double>() : 0};
}

/// What is said of one figure that was `before` and is `after`.
std::optional<Change> change(Rule rule, const std::string& before, const std::string& after) {
  const Baseline baseline{"s", "", {}, {{"group", {{"figure", value(before)}}}}};
  const Figures result{"s", "", {}, {{"group", {{"figure", {value(after), rule}}}}}};
  const Comparison c = compare(baseline, result, tolerance);
  EXPECT_EQ(c.figures, 1u);
  if (c.differences.empty()) return std::nullopt;
  EXPECT_EQ(c.differences.size(), 1u);
  EXPECT_EQ(c.differences.front().before, before);
  EXPECT_EQ(c.differences.front().after, after);
  return c.differences.front().change;
}

struct Case {
  Rule rule;
  const char *before, *after;
  std::optional<Change> change;
};

TEST(Gate, AChangePointsWhereItsRuleSays) {
  const std::optional<Change> none, worse = Change::worse, better = Change::better, changed = Change::changed,
                                    faster = Change::faster;
  for (const Case& c :
       {Case{Rule::yes, "false", "true", better}, Case{Rule::yes, "true", "false", worse},
        Case{Rule::more, "3", "4", better}, Case{Rule::more, "4", "3", worse},
        Case{Rule::less, "3", "4", worse}, Case{Rule::less, "4", "3", better},
        Case{Rule::same, "3", "4", changed}, Case{Rule::same, "\"a\"", "\"b\"", changed},
        // Sums of fractions: one in 10^9 is noise, one in 10^8 is not.
        Case{Rule::about, "1", "1.0000000005", none}, Case{Rule::about, "1", "1.00000001", changed},
        Case{Rule::about_more, "1", "0.9999999995", none}, Case{Rule::about_more, "1", "1.00000001", better},
        Case{Rule::about_more, "1", "0.99999999", worse}, Case{Rule::about_less, "1", "1.0000000005", none},
        Case{Rule::about_less, "1", "1.00000001", worse}, Case{Rule::about_less, "1", "0.99999999", better},
        // Speeds, by a factor of 1.5.
        Case{Rule::speed_more, "3", "2.01", none}, Case{Rule::speed_more, "3", "1.99", worse},
        Case{Rule::speed_more, "3", "4.49", none}, Case{Rule::speed_more, "3", "4.51", faster},
        Case{Rule::speed_less, "3", "4.49", none}, Case{Rule::speed_less, "3", "4.51", worse},
        Case{Rule::speed_less, "3", "2.01", none}, Case{Rule::speed_less, "3", "1.99", faster},
        // No ratio at all, where a time was too short to be taken.
        Case{Rule::speed_more, "3", "null", worse}, Case{Rule::speed_less, "3", "0", worse},
        Case{Rule::speed_more, "null", "3", changed}, Case{Rule::speed_less, "0", "3", changed}})
    EXPECT_EQ(change(c.rule, c.before, c.after), c.change)
        << static_cast<int>(c.rule) << ": " << c.before << " -> " << c.after;
}

TEST(Gate, VerdictsFromTheWorst) {
  const std::vector<std::string> from_worst{"\"refuted\"",        "\"broken\"",  "\"incomplete\"",
                                            "\"not_applicable\"", "\"checked\"", "\"proved\""};
  for (std::size_t a = 0; a < from_worst.size(); ++a)
    for (std::size_t b = 0; b < from_worst.size(); ++b)
      EXPECT_EQ(change(Rule::verdict, from_worst[a], from_worst[b]), a == b  ? std::nullopt
                                                                     : a < b ? std::optional(Change::better)
                                                                             : std::optional(Change::worse))
          << from_worst[a] << " -> " << from_worst[b];
}

/// Groups of figures that all are 1.
template <class Of>
Groups<Of> ones(const std::map<std::string, std::vector<std::string>>& names) {
  Groups<Of> groups;
  for (const auto& [group, figures] : names)
    for (const std::string& figure : figures)
      if constexpr (std::is_same_v<Of, Value>)
        groups[group][figure] = value("1");
      else
        groups[group][figure] = {value("1"), Rule::same};
  return groups;
}

TEST(Gate, NothingComesOrGoesUnsaid) {
  const Baseline baseline{"s", "", {}, ones<Value>({{"a", {"x", "y"}}, {"b", {"x"}}})};
  const Figures result{"s", "", {}, ones<Figure>({{"a", {"x", "z"}}, {"c", {"x"}}})};
  const Comparison c = compare(baseline, result, tolerance);
  EXPECT_EQ(c.figures, 1u);
  EXPECT_TRUE(c.red());
  std::vector<std::string> said;
  for (const Difference& d : c.differences)
    said.push_back((d.change == Change::gone ? "gone " : "new ") + d.group + " " + d.figure);
  EXPECT_THAT(said, testing::ElementsAre("gone a y", "gone b ", "new a z", "new c "));
  for (const Change kind : {Change::gone, Change::added}) EXPECT_EQ(c.count(kind), 2u);
}

TEST(Gate, OnlyAFasterSpeedIsGreen) {
  for (const Change kind : {Change::worse, Change::better, Change::changed, Change::gone, Change::added}) {
    Comparison c;
    c.differences.push_back({kind, "", "", "", ""});
    EXPECT_TRUE(c.red());
    c.differences.push_back({Change::faster, "", "", "", ""});
    EXPECT_TRUE(c.red());
  }
  Comparison c;
  EXPECT_FALSE(c.red());
  c.differences.push_back({Change::faster, "", "", "", ""});
  EXPECT_FALSE(c.red());
}

// Where no speed was compared, the processor does not matter.
TEST(Gate, ProcessorsAreNamedWhereSpeedsAreCompared) {
  for (const Rule rule : {Rule::same, Rule::speed_more}) {
    const Baseline baseline{"s", "one", {}, {{"g", {{"f", value("1")}}}}};
    const Figures result{"s", "another", {}, {{"g", {{"f", {value("1"), rule}}}}}};
    EXPECT_EQ(compare(baseline, result, tolerance).other_processor, rule == Rule::same ? "" : "one");
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// Rules and files
// ---------------------------------------------------------------------------------------------------------------------

// What the gate is for: the way that each kind of figure points, place by place.
TEST(Gate, TheFiguresThatMatterPointTheRightWay) {
  const struct {
    const char *schema, *place;
    Rule rule;
  } all[] = {{"mmverify.result/1", "results[].verdict", Rule::verdict},
             {"mmverify.result/1", "results[].cases_run", Rule::more},
             {"mmverify.result/1", "results[].mismatches", Rule::less},
             {"mmverify.result/1", "mutants[].killed", Rule::yes},
             {"mmverify.result/1", "scene.bake.states.T", Rule::more},
             {"mmverify.result/1", "scene.bake.states.UO", Rule::less},
             {"mmverify.result/1", "scene.bake.exact", Rule::less},
             {"mmverify.result/1", "scene.footprint.modes[].tree_bytes", Rule::less},
             {"mmverify.result/1", "scene.footprint.special_indices", Rule::more},
             {"mmverify.result/1", "scene.saved.opaque", Rule::about_more},
             {"mmverify.result/1", "scene.saved.unknown", Rule::about_less},
             {"mmverify.result/1", "scene.vq4.substitutions", Rule::less},
             {"mmverify.bench/1 index", "rows[].ratio_to_reference_f32", Rule::speed_less},
             {"mmverify.bench/1 index", "subjects[].errors[].mismatches", Rule::less},
             {"mmverify.bench/1 tree", "rows[].ratio_encode_obvious_to_ours", Rule::speed_more},
             {"mmverify.bench/1 tree", "rows[].ratio_ours_to_flat", Rule::speed_less},
             {"mmverify.bench/1 tree", "rows[].forms[].bits_per_micro_triangle", Rule::about_less},
             {"mmverify.bench/1 vq", "rows[].vq4[].substitutions", Rule::less},
             {"mmverify.bench/1 vq", "rows[].vq4[].times_paper", Rule::speed_less},
             {"mmverify.bench/1 vq", "decode.vq2.ratio_regions_to_map", Rule::speed_more},
             {"mmverify.bench/1 bake", "rows[].bakers[].wrong", Rule::less},
             {"mmverify.bench/1 bake", "rows[].bakers[].needless", Rule::less},
             {"mmverify.bench/1 bake", "rows[].bakers[].times_ours", Rule::speed_more},
             {"mmverify.bench/1 scene", "rows[].ratio_centre_to_ours", Rule::speed_more},
             {"mmverify.bench/1 subject", "judged_ratio", Rule::speed_less}};
  for (const auto& [schema, place, rule] : all) EXPECT_EQ(rule_of(schema, place), rule) << place;
  EXPECT_EQ(rule_of("mmverify.result/1", "results[].no_such_field"), std::nullopt);
}

Json run_of(const std::vector<std::string>& subjects) {
  Json run{{"schema", "mmverify.result/1"}, {"results", Json::array()}};
  for (const std::string& subject : subjects)
    run["results"].push_back({{"law", "l"}, {"subject", subject}, {"level", 1}, {"verdict", "proved"}});
  return run;
}

std::vector<std::string> groups_of(const Json& run) {
  std::vector<std::string> names;
  for (const auto& [name, figures] : figures_of(run).groups) names.push_back(name);
  return names;
}

// Also where a subject is called as the second of another would be.
TEST(Gate, TwoOfOneNameStayTwo) {
  EXPECT_THAT(groups_of(run_of({"impl", "impl"})),
              testing::UnorderedElementsAre("l impl level 1", "l impl level 1 (2)"));
  Json run = run_of({"impl", "impl", "impl"});
  run["results"][0]["level"] = Json::parse("\"1 (2)\"");
  run["results"][1]["level"] = "1";
  run["results"][2]["level"] = "1";
  EXPECT_THAT(groups_of(run), testing::UnorderedElementsAre("l impl 1", "l impl 1 (2)", "l impl 1 (2)'"));
}

template <class Read>
std::string complaint(Read read) {
  try {
    read();
  } catch (const NoResult& why) {
    return why.what();
  }
  return "no complaint";
}

TEST(Gate, WhatIsNoBaseline) {
  const auto baseline = [](const char* settings, const char* figures) {
    return complaint([&] {
      baseline_of(Json{{"schema", "mmverify.baseline/1"},
                       {"of", "mmverify.result/1"},
                       {"settings", Json::parse(settings)},
                       {"figures", Json::parse(figures)}});
    });
  };
  EXPECT_EQ(baseline("{}", R"({"g": {"f": 1}})"), "no complaint");
  EXPECT_THAT(baseline("{}", "{}"), HasSubstr("figures: there are none"));
  EXPECT_THAT(baseline("[]", R"({"g": {"f": 1}})"), HasSubstr("settings: no object"));
  EXPECT_THAT(baseline("{}", R"({"g": 1})"), HasSubstr("g: no object"));
  for (const char* figures : {R"({"g": {"f": [1]}})", R"({"g": {"f": {}}})"})
    EXPECT_THAT(baseline("{}", figures), HasSubstr("a figure is a text, a number, true, false or null"));
}

TEST(Gate, ABaselineSaysWhatTheResultSaid) {
  const Figures figures = figures_of(run_of({"a", "b"}));
  const Baseline back = baseline_of(Json::parse(to_json(baseline_of(figures))));
  const Comparison c = compare(back, figures, tolerance);
  EXPECT_EQ(c.figures, 2u);
  EXPECT_TRUE(c.differences.empty());
}

}  // namespace
