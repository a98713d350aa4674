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
      {{.key = "set", .heading = "attributes", .leads = true},
       [](const P& p) { return scene::name(p.plan->set); }},
      {{.key = "kind", .heading = "maps of", .leads = true}, [](const P& p) { return kind_of(*p.plan); }},
      {{.key = "wanted", .heading = "wanted RMSE", .unit = "codes", .leads = true},
       [](const P& p) { return p.plan->wanted; }},
      {{"triangles", "triangles"}, [](const P& p) { return p.plan->triangles; }},
      {{"special", "without map"}, [](const P& p) { return p.plan->special; }},
      {{"palette", "values of those"}, [](const P& p) { return p.plan->palette; }},
      {{"maps", "maps"}, [](const P& p) { return p.plan->distinct(); }},
      {{"shared", "equal ones"}, [](const P& p) { return p.plan->maps() - p.plan->distinct(); }},
      {{"not_kept", "error not kept"}, [](const P& p) { return p.plan->not_kept; }},
      {{"value_bytes", "bytes of values"}, [](const P& p) { return p.plan->value_bytes(); }},
      {{"bytes", "bytes"}, [](const P& p) { return p.plan_bytes(); }},
      {{"rmse", "RMSE", "codes", {.digits = 3}}, [](const P& p) { return optional(p.plan->error.rmse); }},
      {{"flip", "FLIP", "", {.digits = 4}}, [](const P& p) { return optional(p.plan->error.flip); }},
      {{"uniform.level", "level", "", {}, "one level, as close"},
       of_close([](const P&, const MapsAtLevel& at) { return std::uint64_t{at.level}; })},
      {{"uniform.rmse", "RMSE", "codes", {.digits = 3}, "one level, as close"},
       of_close([](const P&, const MapsAtLevel& at) { return *at.error.rmse; })},
      {{"uniform.bytes", "bytes", "", {}, "one level, as close"},
       of_close([](const P& p, const MapsAtLevel& at) { return p.bytes_of(at); })},
      {{"uniform.plan_to_it", "plan to it", "", {.digits = 3}, "one level, as close"},
       of_close([](const P& p, const MapsAtLevel& at) { return times(p.plan_bytes(), p.bytes_of(at)); })},
  };
  for (const Measure measure : {Measure::rmse, Measure::flip}) {
    const bool flip = measure == Measure::flip;
    const std::string key = flip ? "equal_flip." : "equal_rmse.",
                      group = flip ? "one level, at equal FLIP" : "one level, at equal RMSE";
    fields.push_back({{key + "bytes", "bytes", "", {}, group}, [measure](const P& p) {
                        const auto bytes = p.bytes_at_equal(measure);
                        return bytes ? Value(*bytes) : Value();
                      }});
    fields.push_back({{key + "plan_to_it", "plan to it", "", {.digits = 3}, group}, [measure](const P& p) {
                        const auto bytes = p.bytes_at_equal(measure);
                        return bytes ? times(p.plan_bytes(), *bytes) : Value();
                      }});
  }
  return fields;
}

Fields<LevelOfPlan> level_fields() {
  using L = LevelOfPlan;
  return {
      {{.key = "set", .heading = "attributes", .leads = true},
       [](const L& l) { return scene::name(l.plan->set); }},
      {{.key = "kind", .heading = "maps of", .leads = true}, [](const L& l) { return kind_of(*l.plan); }},
      {{.key = "wanted", .heading = "wanted RMSE", .unit = "codes", .leads = true},
       [](const L& l) { return l.plan->wanted; }},
      {{.key = "level", .heading = "level", .leads = true},
       [](const L& l) { return std::uint64_t{l.at->level}; }},
      {{"lowest", "lowest for"}, [](const L& l) { return l.at->lowest; }},
      {{"planned", "graded"}, [](const L& l) { return l.at->planned; }},
      {{"decimated", "with a decimated edge"}, [](const L& l) { return l.at->decimated; }},
      {{"maps", "maps"}, [](const L& l) { return l.at->distinct; }},
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
  return {table_of<PlanBesideUniform>(
              {.key = "plans", .caption = "maps, each triangle's of the level that it needs"}, plan_fields(),
              rows),
          table_of<LevelOfPlan>({.key = "plan_levels", .caption = "triangles of plans, by level"},
                                level_fields(), levels)};
}

}  // namespace mmverify::bench
