#include "bench/scene/attribute_plan_tables.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bench/scene/attribute_tables.hpp"
#include "scene/attribute/equal_error.hpp"

namespace mmverify::bench {
namespace {

using scene::MapsAtLevel;
using scene::Measure;
using scene::PlannedMaps;

/// A plan, and the set with all triangles at one level, level by level.
struct PlanBesideUniform {
  const PlannedMaps* plan;
  std::vector<const MapsAtLevel*> uniform;  ///< of the same kind, by level

  std::uint64_t plan_bytes() const {
    return plan->value_bytes() + plan->triangles * (scene::bytes_of_place + scene::bytes_of_level);
  }
  std::uint64_t bytes_of(const MapsAtLevel& at) const {
    return at.bytes() + plan->triangles * scene::bytes_of_place;
  }
  /// The lowest level with at most the plan's error; nullptr if there is none, or no texel is shown.
  const MapsAtLevel* as_close() const {
    if (!plan->error.rmse) return nullptr;
    const auto at = std::find_if(uniform.begin(), uniform.end(), [this](const MapsAtLevel* one) {
      return one->error.rmse <= plan->error.rmse;
    });
    return at == uniform.end() ? nullptr : *at;
  }
  /// The bytes of uniform levels at the plan's error, interpolated; none if the measure is missing, or the
  /// error is not between two levels.
  std::optional<std::uint64_t> bytes_at_equal(Measure measure) const {
    const std::optional<double> error = error_by(plan->error, measure);
    if (!error) return std::nullopt;
    std::vector<scene::BytesAndError> sizes;
    for (auto at = uniform.rbegin(); at != uniform.rend(); ++at)
      sizes.push_back({static_cast<double>(bytes_of(**at)), error_by((*at)->error, measure).value_or(0)});
    const scene::BytesAtError found = scene::bytes_at_error(sizes, *error);
    if (found.where != scene::AmongSizes::within) return std::nullopt;
    return static_cast<std::uint64_t>(std::llround(found.bytes));
  }
};

std::string kind_of(const PlannedMaps& plan) {
  return plan.kind == scene::MapKind::faces ? "faces" : "vertices";
}

/// A level of a plan.
struct LevelOfPlan {
  const PlannedMaps* plan;
  const scene::PlannedLevel* at;
};

Value times(std::uint64_t plan, std::uint64_t uniform) {
  return static_cast<double>(plan) / static_cast<double>(uniform);
}

Fields<PlanBesideUniform> plan_fields() {
  using P = PlanBesideUniform;
  const auto of_close = [](auto value) {
    return [value](const P& p) -> Value {
      const MapsAtLevel* at = p.as_close();
      return at == nullptr ? Value() : Value(value(p, *at));
    };
  };
  Fields<P> fields{
      {{.key = set_key(), .heading = "attributes", .leads = true},
       [](const P& p) { return scene::name(p.plan->set); }},
      {{.key = one_of("kind", key, {"faces", "vertices"}, "what the maps are of"),
        .heading = "maps of",
        .leads = true},
       [](const P& p) { return kind_of(*p.plan); }},
      {{.key = real("wanted", key, {0, 255}, "error of a triangle, in codes of 8 bits"),
        .heading = "wanted RMSE",
        .unit = "codes",
        .leads = true},
       [](const P& p) { return p.plan->wanted; }},
      {{count("triangles", no_rule, "of the set"), "triangles"},
       [](const P& p) { return p.plan->triangles; }},
      {{count("special", no_rule, "without a map: one value keeps the error, or no texel's centre is shown"),
        "without map"},
       [](const P& p) { return p.plan->special; }},
      {{count("palette", no_rule, "different values of those"), "values of those"},
       [](const P& p) { return p.plan->palette; }},
      {{count("maps", no_rule, "of the others, equal ones of a level once"), "maps"},
       [](const P& p) { return p.plan->distinct(); }},
      {{count("shared", no_rule, "triangles with a map, less the maps"), "equal ones"},
       [](const P& p) { return p.plan->maps() - p.plan->distinct(); }},
      {{count("not_kept", no_rule, "triangles that do not keep the error at the last level either"),
        "error not kept"},
       [](const P& p) { return p.plan->not_kept; }},
      {{count("value_bytes", no_rule, "4 a value of maps and palette"), "bytes of values"},
       [](const P& p) { return p.plan->value_bytes(); }},
      {{count("bytes", no_rule,
              "the same, and 5 a triangle: 4 that say where its map or value is, 1 of its level"),
        "bytes"},
       [](const P& p) { return p.plan_bytes(); }},
      {{number("rmse", no_rule,
               "reached over the set, as in rows, in codes; not there where no texel is shown")
            .if_any(),
        "RMSE", "codes", digits(3)},
       [](const P& p) { return optional(p.plan->error.rmse); }},
      {{number("flip", no_rule, "the same; of sRGB textures").if_any(), "FLIP", "", digits(4)},
       [](const P& p) { return optional(p.plan->error.flip); }},
      note<P>(object("uniform", no_rule,
                     "all triangles at the lowest level measured whose error is as small; not there where "
                     "there is none")
                  .if_any()),
      {{whole("uniform.level", no_rule, {0, 10}).if_any(), "level", "", plain, "one level, as close"},
       of_close([](const P&, const MapsAtLevel& at) { return std::uint64_t{at.level}; })},
      {{number("uniform.rmse", no_rule, "as in rows, in codes").if_any(), "RMSE", "codes", digits(3),
        "one level, as close"},
       of_close([](const P&, const MapsAtLevel& at) { return *at.error.rmse; })},
      {{count("uniform.bytes", no_rule, "as in rows, and 4 a triangle that say where its map is").if_any(),
        "bytes", "", plain, "one level, as close"},
       of_close([](const P& p, const MapsAtLevel& at) { return p.bytes_of(at); })},
      {{number("uniform.plan_to_it", no_rule, "the plan's bytes / these").if_any(), "plan to it", "",
        digits(3), "one level, as close"},
       of_close([](const P& p, const MapsAtLevel& at) { return times(p.plan_bytes(), p.bytes_of(at)); })},
  };
  for (const Measure measure : {Measure::rmse, Measure::flip}) {
    const bool flip = measure == Measure::flip;
    const std::string object_key = flip ? "equal_flip" : "equal_rmse",
                      group = flip ? "one level, at equal FLIP" : "one level, at equal RMSE";
    fields.push_back(note<P>(object(object_key, no_rule,
                                    flip ? "the same at the plan's FLIP"
                                         : "between two levels, at the plan's RMSE, on a line of logarithms "
                                           "of bytes and errors; not there where it is not between")
                                 .if_any()));
    fields.push_back(
        {{count(object_key + ".bytes", no_rule, "as of uniform").if_any(), "bytes", "", plain, group},
         [measure](const P& p) {
           const auto bytes = p.bytes_at_equal(measure);
           return bytes ? Value(*bytes) : Value();
         }});
    fields.push_back({{number(object_key + ".plan_to_it", no_rule, "the plan's bytes / these").if_any(),
                       "plan to it", "", digits(3), group},
                      [measure](const P& p) {
                        const auto bytes = p.bytes_at_equal(measure);
                        return bytes ? times(p.plan_bytes(), *bytes) : Value();
                      }});
  }
  return fields;
}

Fields<LevelOfPlan> level_fields() {
  using L = LevelOfPlan;
  return {
      {{.key = set_key(), .heading = "attributes", .leads = true},
       [](const L& l) { return scene::name(l.plan->set); }},
      {{.key = one_of("kind", key, {"faces", "vertices"}, "what the maps are of"),
        .heading = "maps of",
        .leads = true},
       [](const L& l) { return kind_of(*l.plan); }},
      {{.key = real("wanted", key, {0, 255}, "error of a triangle, in codes of 8 bits"),
        .heading = "wanted RMSE",
        .unit = "codes",
        .leads = true},
       [](const L& l) { return l.plan->wanted; }},
      {{.key = level(10), .heading = "level", .leads = true},
       [](const L& l) { return std::uint64_t{l.at->level}; }},
      {{count("lowest", no_rule, "triangles of which it is the lowest that keeps the error, or the last"),
        "lowest for"},
       [](const L& l) { return l.at->lowest; }},
      {{count("planned", no_rule, "once neighbours differ by one at most"), "graded"},
       [](const L& l) { return l.at->planned; }},
      {{count("decimated", no_rule, "of these, with a decimated edge"), "with a decimated edge"},
       [](const L& l) { return l.at->decimated; }},
      {{count("maps", no_rule, "of these, equal ones once"), "maps"},
       [](const L& l) { return l.at->distinct; }},
  };
}

}  // namespace

std::vector<Table> attribute_plan_tables(const scene::AttributeFigures& figures,
                                         const std::vector<PlannedMaps>& plans) {
  std::vector<PlanBesideUniform> rows;
  std::vector<LevelOfPlan> levels;
  for (const PlannedMaps& plan : plans) {
    PlanBesideUniform row{&plan, {}};
    for (const scene::AttributeSetFigures& set : figures.sets)
      for (const MapsAtLevel& at : set.levels)
        if (set.set == plan.set && at.kind == plan.kind) row.uniform.push_back(&at);
    rows.push_back(std::move(row));
    for (const scene::PlannedLevel& at : plan.levels) levels.push_back({&plan, &at});
  }
  return {
      table_of<PlanBesideUniform>({.key = list("plans",
                                               "maps, each triangle's of the lowest level that keeps an "
                                               "error, those of vertices graded; not there without --plan",
                                               {1}, left_out)
                                              .if_any(),
                                   .row = "a set and an error",
                                   .caption = "maps, each triangle's of the level that it needs"},
                                  plan_fields(), rows),
      table_of<LevelOfPlan>(
          {.key =
               list("plan_levels", "triangles with a map, by level; not there without --plan", {1}, left_out)
                   .if_any(),
           .row = "a level of a plan",
           .caption = "triangles of plans, by level"},
          level_fields(), levels)};
}

}  // namespace mmverify::bench
