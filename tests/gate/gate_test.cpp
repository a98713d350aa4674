// [sanitized] The gate's comparison, figure by figure: which way a change points, and what is close enough to be none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "delivery/gate/compare.hpp"
#include "delivery/gate/contradictions.hpp"
#include "tests/complaint.hpp"

namespace {

using namespace mmverify::gate;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

constexpr double tolerance = 1.5;

Value value(const std::string& json) {
  const Json j = Json::parse(json);
  return {json, j.is_number() ? j.get<double>() : 0};
}

/// The change of one figure from `before` to `after`.
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

/// A law's result of a verdict, as the only group of a result and of a baseline.
Figures judged(const std::string& verdict) {
  return {"s", "", {}, {{"law", {{"verdict", {value("\"" + verdict + "\""), Rule::verdict}}}}}};
}
Baseline baseline_with(const std::string& verdict) {
  return {"s", "", {}, {{"law", {{"verdict", value("\"" + verdict + "\"")}}}}};
}

// A baseline of an earlier version has laws that do not apply; a new one has none.
TEST(Gate, LawsThatDoNotApplyAreNoPartOfABaseline) {
  EXPECT_TRUE(baseline_of(judged("not_applicable")).groups.empty());
  EXPECT_EQ(baseline_of(judged("checked")).groups.size(), 1u);
  const Baseline none{"s", "", {}, {}};
  for (const Baseline& before : {none, baseline_with("not_applicable")}) {
    EXPECT_FALSE(compare(before, judged("not_applicable"), tolerance).red());
    const Comparison begins = compare(before, judged("proved"), tolerance);
    ASSERT_EQ(begins.differences.size(), 1u);
    EXPECT_EQ(begins.differences.front().change, Change::added);
    EXPECT_FALSE(begins.has_fallen());
  }
  const Comparison ends = compare(baseline_with("proved"), judged("not_applicable"), tolerance);
  ASSERT_EQ(ends.differences.size(), 1u);
  EXPECT_EQ(ends.differences.front().change, Change::worse);
}

TEST(Gate, ALawThatHeldAndIsRefutedOrBrokenHasFallen) {
  for (const char* before : {"proved", "checked"}) {
    for (const char* after : {"refuted", "broken"})
      EXPECT_TRUE(compare(baseline_with(before), judged(after), tolerance).has_fallen()) << before << after;
    for (const char* after : {"checked", "proved", "incomplete"})
      EXPECT_FALSE(compare(baseline_with(before), judged(after), tolerance).has_fallen()) << before << after;
  }
  EXPECT_FALSE(compare(baseline_with("refuted"), judged("refuted"), tolerance).has_fallen());
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

// The processor does not matter unless speeds are compared.
TEST(Gate, ProcessorsAreNamedWhereSpeedsAreCompared) {
  for (const Rule rule : {Rule::same, Rule::speed_more}) {
    const Baseline baseline{"s", "one", {}, {{"g", {{"f", value("1")}}}}};
    const Figures result{"s", "another", {}, {{"g", {{"f", {value("1"), rule}}}}}};
    EXPECT_EQ(compare(baseline, result, tolerance).other_processor, rule == Rule::same ? "" : "one");
  }
}

TEST(Gate, OfSeveralRunsTheBestSpeedCounts) {
  const auto run = [](const char* same, const char* more, const char* less) {
    return Figures{"s",
                   "",
                   {},
                   {{"group",
                     {{"same", {value(same), Rule::same}},
                      {"more", {value(more), Rule::speed_more}},
                      {"less", {value(less), Rule::speed_less}}}}}};
  };
  const auto best = [&](Figures result, const Figures& other) {
    take_better_speeds(result, other);
    std::string all;
    for (const auto& [name, figure] : result.groups.at("group")) all += figure.value.text + " ";
    return all;
  };
  // Figures come in the order of their names: less, more, same.
  EXPECT_EQ(best(run("1", "2", "2"), run("3", "4", "1")), "1 4 1 ");
  EXPECT_EQ(best(run("1", "2", "2"), run("3", "1", "3")), "2 2 1 ");
  // No ratio is no better one, and any is better than none.
  EXPECT_EQ(best(run("1", "2", "2"), run("1", "null", "0")), "2 2 1 ");
  EXPECT_EQ(best(run("1", "null", "0"), run("1", "2", "2")), "2 2 1 ");
  // A figure that one of the two runs lacks stays as it is.
  Figures bare = run("1", "2", "2");
  bare.groups["group"].erase("more");
  bare.groups["more of it"] = {};
  EXPECT_EQ(best(bare, run("1", "4", "2")), "2 1 ");
  EXPECT_EQ(best(run("1", "2", "2"), bare), "2 2 1 ");
  Figures other_seed = run("1", "2", "2");
  other_seed.settings["seed"] = "2";
  EXPECT_THROW(best(run("1", "2", "2"), other_seed), NoResult);
}

// ---- Rules and files

// The gate's purpose: each kind of figure has a direction, place by place.
TEST(Gate, TheFiguresThatMatterPointTheRightWay) {
  const struct {
    const char *schema, *place;
    Rule rule;
  } all[] = {{"mmverify.result/1", "results[].verdict", Rule::verdict},
             {"mmverify.result/1", "results[].cases_run", Rule::more},
             {"mmverify.result/1", "results[].mismatches", Rule::less},
             {"mmverify.result/1", "results[].by_kind.vertex.cases", Rule::more},
             {"mmverify.result/1", "results[].by_kind.edge.mismatches", Rule::less},
             {"mmverify.result/1", "results[].by_kind.interior.declined", Rule::less},
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
  for (const auto& [schema, place, rule] : all) {
    EXPECT_EQ(rule_of(schema, place), rule) << place;
    // Nor does it lie in something that is left out.
    const std::string whole = place;
    for (std::size_t at = whole.find_first_of(".["); at != std::string::npos;
         at = whole.find_first_of(".[", at + 1))
      EXPECT_NE(rule_of(schema, whole.substr(0, at)), Rule::left_out) << whole.substr(0, at);
  }
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
  return mmverify::tests::complaint_of<NoResult>([&] { read(); }, "no complaint");
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
  EXPECT_THAT(baseline("{}", "{}"), HasSubstr("figures: it has none"));
  EXPECT_THAT(baseline("[]", R"({"g": {"f": 1}})"), HasSubstr("settings: no object"));
  EXPECT_THAT(baseline("{}", R"({"g": 1})"), HasSubstr("g: no object"));
  for (const char* figures : {R"({"g": {"f": [1]}})", R"({"g": {"f": {}}})"})
    EXPECT_THAT(baseline("{}", figures), HasSubstr("a figure is a text, a number, true, false or null"));
  EXPECT_THAT(baseline("{}", R"({"g": {"also": [1], "f": 1}})"),
              HasSubstr("g: also: a group's name is a text"));
  EXPECT_THAT(baseline("{}", R"({"g": {"also": "h", "f": 1}})"), HasSubstr("g: also: no list"));
  EXPECT_THAT(baseline("{}", R"({"g": {"also": ["g"], "f": 1}})"), HasSubstr("g: two groups of this name"));
}

// Equal figures of a law share a line, up to its longest; other laws and other figures have lines of their own.
TEST(Gate, EqualGroupsOfALawAreOneLine) {
  const std::string far = "t.a " + std::string(800, 'x');
  Baseline baseline{"s", "", {}, {}};
  for (const char* group : {"t.a one", "t.a two", far.c_str(), "t.b one"})
    baseline.groups[group]["f"] = value("1");
  baseline.groups["t.a three"]["f"] = value("2");
  EXPECT_THAT(to_json(baseline), HasSubstr(R"({
  "t.a one": {"also": ["t.a two"], "f": 1},
  "t.a three": {"f": 2},
  ")" + far + R"(": {"f": 1},
  "t.b one": {"f": 1}
 })"));
  const Baseline back = baseline_of(Json::parse(to_json(baseline)));
  EXPECT_EQ(back.groups.size(), 5u);
  for (const auto& [group, figures] : back.groups)
    EXPECT_EQ(figures.at("f").text, baseline.groups.at(group).at("f").text) << group;
}

/// A result of two kinds of cells, as one that passed or as one that was refuted.
Json result_of(const std::string& verdict) {
  Json passed = Json::parse(R"({"verdict": "proved", "cases_expected": 9, "cases_run": 9, "mismatches": 0,
      "by_kind": {"vertex": {"cases": 4, "mismatches": 0}, "edge": {"cases": 5, "mismatches": 0, "declined": 0}},
      "counterexample": null})");
  if (verdict == "refuted") {
    passed["mismatches"] = passed["by_kind"]["edge"]["mismatches"] = 2;
    passed["counterexample"] = {{"case", "x"}};
    passed["more_counterexamples"] = Json::array({{{"case", "y"}}});
  }
  passed["verdict"] = verdict;
  return passed;
}

TEST(Contradictions, ThereAreNoneInWhatIsWritten) {
  for (const char* verdict : {"proved", "checked", "refuted", "incomplete"})
    EXPECT_EQ(contradiction_in(result_of(verdict)), std::nullopt) << verdict;
  for (const char* verdict : {"broken", "not_applicable", "incomplete"}) {
    Json none = result_of(verdict);
    none["cases_run"] = none["by_kind"]["vertex"]["cases"] = none["by_kind"]["edge"]["cases"] = 0;
    EXPECT_EQ(contradiction_in(none), std::nullopt) << verdict;
  }
  EXPECT_EQ(contradiction_in(Json::object()), std::nullopt);
}

TEST(Contradictions, EachIsFound) {
  const struct {
    const char *verdict, *pointer;
    Json value;
    const char* words;
  } all[] = {
      {"proved", "/counterexample", {{"case", "x"}}, "a counterexample, beside 0 mismatches"},
      {"proved", "/more_counterexamples", Json::array({1}), "more counterexamples, beside 0 mismatches"},
      {"refuted", "/counterexample", nullptr, "no counterexample, beside 2 mismatches"},
      {"proved", "/by_kind/vertex/cases", 5, "by_kind adds up to 10 cases, the result says 9"},
      {"proved", "/by_kind/vertex/mismatches", 1, "by_kind adds up to 1 mismatches, the result says 0"},
      {"refuted", "/mismatches", 3, "by_kind adds up to 2 mismatches, the result says 3"},
      {"refuted", "/verdict", "proved", "proved, with 2 mismatches"},
      {"refuted", "/verdict", "checked", "checked, with 2 mismatches"},
      {"proved", "/verdict", "refuted", "refuted, with 0 mismatches"},
      {"proved", "/cases_expected", 10, "proved, with 9 of 10 cases run"},
      {"checked", "/cases_expected", 8, "9 cases run, more than the 8 expected"},
      {"proved", "/by_kind/edge/declined", 1, "proved, with 1 cases declined"},
      {"checked", "/by_kind/edge/declined", 6,
       "edge: more mismatches, declined and allowed cases than cases"},
      {"proved", "/by_kind/edge/allowed", 1, "proved, with 1 cases allowed"},
      {"checked", "/by_kind/edge/allowed", 6, "edge: more mismatches, declined and allowed cases than cases"},
      {"refuted", "/by_kind/edge/declined", 4,
       "edge: more mismatches, declined and allowed cases than cases"}};
  for (const auto& [verdict, pointer, value, words] : all) {
    Json changed = result_of(verdict);
    changed[Json::json_pointer(pointer)] = value;
    EXPECT_EQ(contradiction_in(changed), words) << pointer;
  }
  Json none = result_of("checked");
  none["cases_run"] = none["by_kind"]["vertex"]["cases"] = none["by_kind"]["edge"]["cases"] = 0;
  EXPECT_EQ(contradiction_in(none), "checked, with no case run");
  // A domain with fewer pieces than shards leaves some shards without a case: they have judged nothing.
  none["share"] = {{"from", 4}, {"to", 4}, {"of", 9}};
  EXPECT_EQ(contradiction_in(none), "checked, with no case run");
  none["verdict"] = "not_applicable";
  EXPECT_EQ(contradiction_in(none), std::nullopt);
}

TEST(Contradictions, ACountIsAWholeNumber) {
  for (const Json& value : {Json(1.5), Json("9"), Json(-1), Json(nullptr)}) {
    Json changed = result_of("proved");
    changed["by_kind"]["edge"]["cases"] = value;
    EXPECT_THAT(complaint([&] { contradiction_in(changed); }), HasSubstr("where a whole number should be"));
  }
}

TEST(Contradictions, TheyAreNamedByPlaceAndLaw) {
  Json run = run_of({"a", "b"});
  run["results"][1]["mismatches"] = 1;
  EXPECT_THAT(complaint([&] { figures_of(run); }),
              HasSubstr("results[1] (\"l\" on \"b\", level 1) contradicts itself: "));
}

TEST(Gate, ABaselineSaysWhatTheResultSaid) {
  const Figures figures = figures_of(run_of({"a", "b"}));
  const Baseline back = baseline_of(Json::parse(to_json(baseline_of(figures))));
  const Comparison c = compare(back, figures, tolerance);
  EXPECT_EQ(c.figures, 2u);
  EXPECT_TRUE(c.differences.empty());
}

}  // namespace
