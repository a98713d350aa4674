#include "delivery/gate/baseline.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace mmverify::gate {
namespace {

using Json = nlohmann::ordered_json;
constexpr char schema[] = "mmverify.baseline/1";

Value value_of(const Json& j) {
  if (j.is_structured()) throw NoResult("a figure is a text, a number, true, false or null");
  return {j.dump(), j.is_number() ? j.get<double>() : 0};
}

/// The member `name`. Throws NoResult if it is no object.
const Json& object_in(const Json& j, const std::string& name) {
  if (!j.contains(name) || !j.at(name).is_object()) throw NoResult(fmt::format("{}: no object", name));
  return j.at(name);
}

std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Baseline baseline_of(const Figures& figures) {
  Baseline baseline{figures.schema, figures.processor, figures.settings, {}};
  for (const auto& [group, members] : figures.groups) {
    const auto verdict = members.find("verdict");
    if (verdict != members.end() && is_not_applicable(verdict->second.value)) continue;
    for (const auto& [name, figure] : members) baseline.groups[group][name] = figure.value;
  }
  return baseline;
}

bool is_not_applicable(const Value& verdict) { return unquoted(verdict.text) == "not_applicable"; }

bool is_baseline(const Json& file) {
  return file.is_object() && file.value("schema", Json()) == Json(schema);
}

Baseline baseline_of(const Json& file) {
  if (!is_baseline(file)) return baseline_of(figures_of(file));
  Baseline baseline;
  if (!file.contains("of") || !file.at("of").is_string())
    throw NoResult("of: the result's schema should stand here");
  baseline.schema = file.at("of").get<std::string>();
  if (file.contains("processor") && file.at("processor").is_string())
    baseline.processor = file.at("processor").get<std::string>();
  for (const auto& [name, value] : object_in(file, "settings").items())
    baseline.settings[name] = value_of(value).text;
  const Json& groups = object_in(file, "figures");
  for (const auto& [group, members] : groups.items())
    for (const auto& [name, value] : object_in(groups, group).items())
      baseline.groups[group][name] = value_of(value);
  if (baseline.groups.empty()) throw NoResult("figures: it has none");
  return baseline;
}

std::string to_json(const Baseline& baseline) {
  std::string settings, groups;
  for (const auto& [name, text] : baseline.settings)
    settings += fmt::format("{}{}: {}", settings.empty() ? "" : ", ", quoted(name), text);
  for (const auto& [group, members] : baseline.groups) {
    std::string figures;
    for (const auto& [name, value] : members)
      figures += fmt::format("{}{}: {}", figures.empty() ? "" : ", ", quoted(name), value.text);
    groups += fmt::format("{}\n  {}: {{{}}}", groups.empty() ? "" : ",", quoted(group), figures);
  }
  return fmt::format(
      "{{\n \"schema\": {},\n \"of\": {},\n \"processor\": {},\n \"settings\": {{{}}},\n \"figures\": {{{}\n "
      "}}\n}}\n",
      quoted(schema), quoted(baseline.schema), quoted(baseline.processor), settings, groups);
}

}  // namespace mmverify::gate
