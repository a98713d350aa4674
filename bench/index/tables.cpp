#include "bench/index/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace mmverify::bench {
namespace {

using F = IndexFigures;

// ---- At the highest level

Value rate_of(const IndexErrors& e) { return e.mismatches == 0 ? Value() : Value(e.rate()); }

/// A worst distance; none if every mismatch is off the grid.
Value worst_of(const IndexErrors& e, double distance) {
  return e.mismatches == e.off_grid ? Value() : Value(distance);
}

Table highest_table(std::vector<F> figures) {
  std::erase_if(figures, [](const F& f) { return f.stiff.empty(); });
  const Print rate{.digits = 2, .type = 'e', .none = "none"}, distance{.digits = 3, .type = 'g'};
  const std::string rates = "mismatch rate", worst = "worst distance, stiff", time = "time";
  const Fields<F> fields{
      {{.heading = "subject", .leads = true}, [](const F& f) { return f.name; }},
      {{"", "level"}, [](const F& f) { return f.stiff.back().level; }},
      {{"", "uniform", "", rate, rates}, [](const F& f) { return rate_of(f.uniform.back()); }},
      {{"", "stiff", "", rate, rates}, [](const F& f) { return rate_of(f.stiff.back()); }},
      {{"", "heights", "", distance, worst},
       [](const F& f) { return worst_of(f.stiff.back(), f.stiff.back().worst_heights); }},
      {{"", "ulp", "", distance, worst},
       [](const F& f) { return worst_of(f.stiff.back(), f.stiff.back().worst_ulp); }},
      {{"", "off grid"},
       [](const F& f) { return f.stiff.back().off_grid == 0 ? Value() : Value(f.stiff.back().off_grid); }},
      {{"", "an index", "ns", plain, time}, [](const F& f) { return f.times.back().ns_per_index; }},
      {{"", "/ reference-f32", "", plain, time},
       [](const F& f) { return f.times.back().ratio_to_reference_f32; }},
  };
  return table_of<F>({.caption = "At the highest level; the worst distance is that of a stiff point from the "
                                 "micro-triangle returned",
                      .form = Form::printed},
                     fields, figures);
}

// ---- Level by level

struct TimeOf {
  std::string subject;
  IndexTime time;
};

Table times_table(const std::vector<F>& figures) {
  std::vector<TimeOf> times;
  for (const F& f : figures)
    for (const IndexTime& t : f.times) times.push_back({f.name, t});
  const Fields<TimeOf> fields{
      {{.key = text("subject", key), .heading = "subject", .leads = true},
       [](const TimeOf& t) { return t.subject; }},
      {{.key = level(16), .heading = "level", .leads = true}, [](const TimeOf& t) { return t.time.level; }},
      {{time("ns_per_index", "ns of processor time an index, on uniform points, one thread"),
        "an index, by level", "ns"},
       [](const TimeOf& t) { return t.time.ns_per_index; }},
      {{number("least_ns_per_index", left_out, "of the fastest round").if_any()},
       [](const TimeOf& t) { return t.time.least_ns; }},
      {{number("most_ns_per_index", left_out, "of the slowest round").if_any()},
       [](const TimeOf& t) { return t.time.most_ns; }},
      {{ratio("ratio_to_reference_f32", speed_less,
              "its time / that of reference-f32 at this level: the median of the rounds' ratios"),
        "/ reference-f32, by level"},
       [](const TimeOf& t) { return t.time.ratio_to_reference_f32; }},
  };
  return table_of<TimeOf>(
      {.key = list("rows", "the times"), .caption = "Time on uniform points, one thread", .beside = true},
      fields, times);
}

struct ErrorsOf {
  IndexErrors errors;
  bool stiff;
};

std::vector<ErrorsOf> errors_of(const F& f) {
  std::vector<ErrorsOf> all;
  for (const IndexErrors& e : f.uniform) all.push_back({e, false});
  for (const IndexErrors& e : f.stiff) all.push_back({e, true});
  return all;
}

Fields<ErrorsOf> errors_fields() {
  using E = ErrorsOf;
  Fields<E> fields{
      {{level(16)}, [](const E& e) { return e.errors.level; }},
      {{one_of("inputs", key, {"uniform", "stiff"}, "stiff: a few ulp from where the answer changes")},
       [](const E& e) { return e.stiff ? "stiff" : "uniform"; }},
      {{positive("samples", same)}, [](const E& e) { return e.errors.samples; }},
      {{count("mismatches", less, "the index, or the micro-triangle made of it, is not the specification's")},
       [](const E& e) { return e.errors.mismatches; }},
      {{count("off_grid", less, "of these, the micro-triangle does not exist")},
       [](const E& e) { return e.errors.off_grid; }},
      {{.key = number("worst_heights", about_less,
                      "how far a point is from the micro-triangle returned, in its heights; 0 where nothing "
                      "was wrong or all of it off grid"),
        .unit = "heights"},
       [](const E& e) { return e.errors.worst_heights; }},
      {{.key = number("worst_ulp", about_less,
                      "the same in ulp of the number type, at the line that was crossed the furthest"),
        .unit = "ulp"},
       [](const E& e) { return e.errors.worst_ulp; }},
  };
  fields.push_back(note<E>(object("by_kind", no_rule, "mismatches on each kind of stiff points")
                               .if_so(R"({"inputs": {"const": "stiff"}})")));
  for (std::size_t k = 0; k < stiff_recipes; ++k)
    fields.push_back({{.key = count(fmt::format("by_kind.{}", to_string(static_cast<StiffRecipe>(k))), less)},
                      [k](const E& e) { return e.stiff ? Value(e.errors.by_kind[k]) : Value(); }});
  return fields;
}

// ---- Growth

struct GrowthOf {
  const char* figure;
  Growth growth;
};

bool fitted(const Growth& g) { return g.law != GrowthLaw::none && g.law != GrowthLaw::too_few; }

/// A law in short: "doubles  0.98 (0.17) 1..10", which is the law, its slope, its residual, the levels.
std::string in_short(const Growth& g) {
  if (!fitted(g)) return to_string(g);
  std::string law = to_string(g);
  law = g.law == GrowthLaw::power ? "power" : law.substr(0, law.find(' '));
  const Line& line = g.law == GrowthLaw::power ? g.power : g.exponential;
  return fmt::format("{:<7} {:>5.2f} ({:.2f}) {}..{}", law, line.slope, line.residual, g.first, g.last);
}

const char* const three_levels = R"({"levels": {"minimum": 3}})";

void add_line(Fields<GrowthOf>& fields, const std::string& name, const char* description,
              Line Growth::*line) {
  fields.push_back(note<GrowthOf>(object(name, no_rule, description).if_so(three_levels)));
  const auto add = [&](Property figure, double Line::*of) {
    figure.name = name + "." + figure.name;
    fields.push_back({{.key = std::move(figure)}, [line, of](const GrowthOf& g) {
                        return fitted(g.growth) ? Value(g.growth.*line.*of) : Value();
                      }});
  };
  add(real("slope", no_rule, {}), &Line::slope);
  add(real("intercept", no_rule, {}), &Line::intercept);
  add(number("residual", no_rule, "root of the mean squared difference, in log2"), &Line::residual);
}

Fields<GrowthOf> growth_fields() {
  using G = GrowthOf;
  const auto level_of = [](std::uint32_t Growth::*of) {
    return [of](const G& g) { return fitted(g.growth) ? Value(g.growth.*of) : Value(); };
  };
  Fields<G> fields{
      {{.key = one_of("", no_rule, {"uniform_rate", "stiff_rate", "stiff_worst_heights"}),
        .heading = "figure"},
       [](const G& g) { return g.figure; }},
      {{text("law", no_rule, "in words")}, [](const G& g) { return to_string(g.growth); }},
      {{.heading = "law"}, [](const G& g) { return in_short(g.growth); }},
      {{count("levels", no_rule, "how many the lines were fitted on; no lines below three")},
       [](const G& g) { return std::uint64_t{g.growth.levels}; }},
      {{whole("first", no_rule, {0, 16}).if_so(three_levels)}, level_of(&Growth::first)},
      {{whole("last", no_rule, {0, 16}).if_so(three_levels)}, level_of(&Growth::last)},
  };
  add_line(fields, "exponential", "log2 of the figure against the level", &Growth::exponential);
  add_line(fields, "power", "log2 of the figure against log2 of the level", &Growth::power);
  return fields;
}

std::vector<GrowthOf> growths_of(const F& f) {
  return {{"uniform_rate", f.uniform_rate},
          {"stiff_rate", f.stiff_rate},
          {"stiff_worst_heights", f.stiff_heights}};
}

Table subjects_table(const std::vector<F>& figures) {
  const Fields<F> fields{
      {{.key = text("subject", key), .heading = "subject", .leads = true}, [](const F& f) { return f.name; }},
      {{one_of("numbers", same, {"binary16", "binary32", "binary64", "fixed point", "rational"},
               "what it computes in"),
        "numbers"},
       [](const F& f) { return f.numbers; }},
      {{one_of("order", same, {"curve", "rows"})}, [](const F& f) { return f.order; }},
      {{whole("max_level", same, {0, 16})}, [](const F& f) { return f.max_level; }},
      within<F, ErrorsOf>(
          {.key = list("errors", "none above max_level", {}), .row = "one level and kind of inputs"},
          errors_fields(), errors_of),
      within<F, GrowthOf>({.key = object("growth", left_out),
                           .heading = "growth",
                           .group = "law",
                           .within = RowLayout::beside,
                           .form = Form::object,
                           .row = "from level to level"},
                          growth_fields(), growths_of),
      note<F>(object("growth.uniform_rate", no_rule, "of the mismatch rate on uniform points")),
      note<F>(object("growth.stiff_rate", no_rule, "of that on stiff points")),
      note<F>(object("growth.stiff_worst_heights", no_rule, "of worst_heights on stiff points")),
  };
  return table_of<F>(
      {.key = "subjects",
       .caption = "Growth from level to level: the law, its slope (log2 a level; a power law's is the "
                  "power), (its residual)\nin log2, and the levels that it was fitted on"},
      fields, figures);
}

}  // namespace

Result index_tables(const std::vector<IndexFigures>& figures, const IndexBenchOptions& options) {
  return {
      .topic = "index",
      .description =
          "mmverify bench index: how often and how far index functions are wrong, and what an index costs",
      .settings = {{seed_of_all(), options.seed},
                   {positive("samples", setting,
                             "points a level, of each kind of inputs; of rationals a 256th"),
                    options.samples}},
      .about =
          "As many uniform and as many stiff points a level as there are samples (rationals: a 256th).\n"
          "A sample is checked, never proved: 'none' is none found",
      .tables = {highest_table(figures), times_table(figures), subjects_table(figures)},
      .drawn = index_picture(figures, options.samples)};
}

}  // namespace mmverify::bench
