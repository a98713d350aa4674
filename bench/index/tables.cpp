#include "bench/index/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace mmverify::bench {
namespace {

using F = IndexFigures;

// ---------------------------------------------------------------------------------------------------------------------
// At the highest level
// ---------------------------------------------------------------------------------------------------------------------

Value rate_of(const IndexErrors& e) { return e.mismatches == 0 ? Value() : Value(e.rate()); }

/// A worst distance; none if every mismatch is off the grid.
Value worst_of(const IndexErrors& e, double distance) {
  return e.mismatches == e.off_grid ? Value() : Value(distance);
}

Table highest_table(std::vector<F> figures) {
  std::erase_if(figures, [](const F& f) { return f.hard.empty(); });
  const Print rate{.digits = 2, .type = 'e', .none = "none"}, distance{.digits = 3, .type = 'g'};
  const std::string rates = "mismatch rate", worst = "worst distance, hard", time = "time";
  const Fields<F> fields{
      {{.heading = "subject", .leads = true}, [](const F& f) { return f.name; }},
      {{"", "level"}, [](const F& f) { return f.hard.back().level; }},
      {{"", "uniform", "", rate, rates}, [](const F& f) { return rate_of(f.uniform.back()); }},
      {{"", "hard", "", rate, rates}, [](const F& f) { return rate_of(f.hard.back()); }},
      {{"", "heights", "", distance, worst},
       [](const F& f) { return worst_of(f.hard.back(), f.hard.back().worst_heights); }},
      {{"", "ulp", "", distance, worst},
       [](const F& f) { return worst_of(f.hard.back(), f.hard.back().worst_ulp); }},
      {{"", "off grid"},
       [](const F& f) { return f.hard.back().off_grid == 0 ? Value() : Value(f.hard.back().off_grid); }},
      {{"", "an index", "ns", {}, time}, [](const F& f) { return f.times.back().ns_per_index; }},
      {{"", "/ reference-f32", "", {}, time},
       [](const F& f) { return f.times.back().ratio_to_reference_f32; }},
  };
  return table_of<F>({.caption = "At the highest level; the worst distance is that of a hard point from the "
                                 "micro-triangle returned",
                      .form = Form::printed},
                     fields, figures);
}

// ---------------------------------------------------------------------------------------------------------------------
// Level by level
// ---------------------------------------------------------------------------------------------------------------------

struct TimeOf {
  std::string subject;
  IndexTime time;
};

Table times_table(const std::vector<F>& figures) {
  std::vector<TimeOf> times;
  for (const F& f : figures)
    for (const IndexTime& t : f.times) times.push_back({f.name, t});
  const Fields<TimeOf> fields{
      {{.key = "subject", .heading = "subject", .leads = true}, [](const TimeOf& t) { return t.subject; }},
      {{.key = "level", .heading = "level", .leads = true}, [](const TimeOf& t) { return t.time.level; }},
      {{"ns_per_index", "an index, by level", "ns"}, [](const TimeOf& t) { return t.time.ns_per_index; }},
      {{"ratio_to_reference_f32", "/ reference-f32, by level"},
       [](const TimeOf& t) { return t.time.ratio_to_reference_f32; }},
  };
  return table_of<TimeOf>({.key = "rows", .caption = "Time on uniform points, one thread", .beside = true},
                          fields, times);
}

struct ErrorsOf {
  IndexErrors errors;
  bool hard;
};

std::vector<ErrorsOf> errors_of(const F& f) {
  std::vector<ErrorsOf> all;
  for (const IndexErrors& e : f.uniform) all.push_back({e, false});
  for (const IndexErrors& e : f.hard) all.push_back({e, true});
  return all;
}

Fields<ErrorsOf> errors_fields() {
  using E = ErrorsOf;
  Fields<E> fields{
      {{"level"}, [](const E& e) { return e.errors.level; }},
      {{"inputs"}, [](const E& e) { return e.hard ? "hard" : "uniform"; }},
      {{"samples"}, [](const E& e) { return e.errors.samples; }},
      {{"mismatches"}, [](const E& e) { return e.errors.mismatches; }},
      {{"off_grid"}, [](const E& e) { return e.errors.off_grid; }},
      {{.key = "worst_heights", .unit = "heights"}, [](const E& e) { return e.errors.worst_heights; }},
      {{.key = "worst_ulp", .unit = "ulp"}, [](const E& e) { return e.errors.worst_ulp; }},
  };
  for (std::size_t k = 0; k < hard_kinds; ++k)
    fields.push_back({{.key = fmt::format("by_kind.{}", to_string(static_cast<HardKind>(k)))},
                      [k](const E& e) { return e.hard ? Value(e.errors.by_kind[k]) : Value(); }});
  return fields;
}

// ---------------------------------------------------------------------------------------------------------------------
// Growth
// ---------------------------------------------------------------------------------------------------------------------

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

void add_line(Fields<GrowthOf>& fields, const std::string& name, Line Growth::*line) {
  const auto add = [&](const char* figure, double Line::*of) {
    fields.push_back({{.key = name + "." + figure}, [line, of](const GrowthOf& g) {
                        return fitted(g.growth) ? Value(g.growth.*line.*of) : Value();
                      }});
  };
  add("slope", &Line::slope);
  add("intercept", &Line::intercept);
  add("residual", &Line::residual);
}

Fields<GrowthOf> growth_fields() {
  using G = GrowthOf;
  const auto level = [](std::uint32_t Growth::*of) {
    return [of](const G& g) { return fitted(g.growth) ? Value(g.growth.*of) : Value(); };
  };
  Fields<G> fields{
      {{.heading = "figure"}, [](const G& g) { return g.figure; }},
      {{"law"}, [](const G& g) { return to_string(g.growth); }},
      {{.heading = "law"}, [](const G& g) { return in_short(g.growth); }},
      {{"levels"}, [](const G& g) { return std::uint64_t{g.growth.levels}; }},
      {{"first"}, level(&Growth::first)},
      {{"last"}, level(&Growth::last)},
  };
  add_line(fields, "exponential", &Growth::exponential);
  add_line(fields, "power", &Growth::power);
  return fields;
}

std::vector<GrowthOf> growths_of(const F& f) {
  return {
      {"uniform_rate", f.uniform_rate}, {"hard_rate", f.hard_rate}, {"hard_worst_heights", f.hard_heights}};
}

Table subjects_table(const std::vector<F>& figures) {
  const Fields<F> fields{
      {{.key = "subject", .heading = "subject", .leads = true}, [](const F& f) { return f.name; }},
      {{"numbers", "numbers"}, [](const F& f) { return f.numbers; }},
      {{"order"}, [](const F& f) { return f.order; }},
      {{"max_level"}, [](const F& f) { return f.max_level; }},
      within<F, ErrorsOf>({.key = "errors"}, errors_fields(), errors_of),
      within<F, GrowthOf>({.key = "growth",
                           .heading = "growth",
                           .group = "law",
                           .within = Within::beside,
                           .form = Form::object},
                          growth_fields(), growths_of),
  };
  return table_of<F>(
      {.key = "subjects",
       .caption = "Growth from level to level: the law, its slope (log2 a level; a power law's is the "
                  "power), (its residual)\nin log2, and the levels that it was fitted on"},
      fields, figures);
}

}  // namespace

Result index_tables(const std::vector<IndexFigures>& figures, const IndexBenchOptions& options) {
  return {.topic = "index",
          .settings = {{"seed", options.seed}, {"samples", options.samples}},
          .about =
              "As many uniform and as many hard points a level as there are samples (rationals: a 256th).\n"
              "A sample is checked, never proved: 'none' is none found",
          .tables = {highest_table(figures), times_table(figures), subjects_table(figures)},
          .drawn = index_picture(figures, options.samples)};
}

}  // namespace mmverify::bench
