#include "delivery/gate/baseline.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace mmverify::gate {
namespace {

using Json = nlohmann::ordered_json;
constexpr char schema[] = "mmverify.baseline/1";
/// Names the groups that have the figures of this one. No field of a result has this name.
constexpr char also[] = "also";

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

/// The law that a group is about: its name up to the first word with a point.
std::string law_of(const std::string& group) { return group.substr(0, group.find(' ', group.find('.'))); }

/// A line of the file: groups of one law that have the same figures.
struct Line {
  std::string group, figures, others;

  std::string text() const {
    const std::string list = others.empty() ? "" : fmt::format("{}: [{}], ", quoted(also), others);
    return fmt::format("  {}: {{{}{}}}", quoted(group), list, figures);
  }
  void add(const std::string& other) {
    others += fmt::format("{}{}", others.empty() ? "" : ", ", quoted(other));
  }
};

std::vector<Line> lines_of(const Groups<Value>& groups) {
  std::vector<Line> lines;
  std::map<std::pair<std::string, std::string>, std::size_t> line_of;
  for (const auto& [group, members] : groups) {
    std::string figures;
    for (const auto& [name, value] : members)
      figures += fmt::format("{}{}: {}", figures.empty() ? "" : ", ", quoted(name), value.text);
    const auto [known, is_new] = line_of.try_emplace({law_of(group), figures}, lines.size());
    // A longer line is hard to compare by eye.
    if (constexpr std::size_t longest = 800;
        !is_new && lines[known->second].text().size() + group.size() <= longest) {
      lines[known->second].add(group);
      continue;
    }
    known->second = lines.size();
    lines.push_back({group, figures, ""});
  }
  return lines;
}

void read_group(const std::string& group, const Json& members, Groups<Value>& groups) {
  std::vector<std::string> names{group};
  std::map<std::string, Value> figures;
  for (const auto& [name, value] : members.items()) {
    if (name != also) {
      figures[name] = value_of(value);
      continue;
    }
    if (!value.is_array()) throw NoResult(fmt::format("{}: {}: no list", group, also));
    for (const Json& other : value) {
      if (!other.is_string()) throw NoResult(fmt::format("{}: {}: a group's name is a text", group, also));
      names.push_back(other.get<std::string>());
    }
  }
  if (figures.empty()) return;
  for (const std::string& name : names)
    if (!groups.emplace(name, figures).second)
      throw NoResult(fmt::format("{}: two groups of this name", name));
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
    read_group(group, object_in(groups, group), baseline.groups);
  if (baseline.groups.empty()) throw NoResult("figures: it has none");
  return baseline;
}

std::string to_json(const Baseline& baseline) {
  std::string settings, groups;
  for (const auto& [name, text] : baseline.settings)
    settings += fmt::format("{}{}: {}", settings.empty() ? "" : ", ", quoted(name), text);
  for (const Line& line : lines_of(baseline.groups))
    groups += fmt::format("{}\n{}", groups.empty() ? "" : ",", line.text());
  return fmt::format(
      "{{\n \"schema\": {},\n \"of\": {},\n \"processor\": {},\n \"settings\": {{{}}},\n \"figures\": {{{}\n "
      "}}\n}}\n",
      quoted(schema), quoted(baseline.schema), quoted(baseline.processor), settings, groups);
}

}  // namespace mmverify::gate
