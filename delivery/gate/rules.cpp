#include "delivery/gate/rules.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "delivery/gate/schema.hpp"

namespace mmverify::gate {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::pair<std::string_view, Rule> rules_by_name[] = {
    {"key", Rule::key},
    {"setting", Rule::setting},
    {"verdict", Rule::verdict},
    {"yes", Rule::yes},
    {"more", Rule::more},
    {"less", Rule::less},
    {"same", Rule::same},
    {"digest", Rule::digest},
    {"about_more", Rule::about_more},
    {"about_less", Rule::about_less},
    {"about", Rule::about},
    {"speed_more", Rule::speed_more},
    {"speed_less", Rule::speed_less},
    {"left_out", Rule::left_out},
};

Rule rule_named(const std::string& name) {
  for (const auto& [known, rule] : rules_by_name)
    if (known == name) return rule;
  throw std::logic_error("no rule is called " + name);
}

/// The rule of a field: the first "x-gate" among the schemas that describe it.
std::optional<Rule> rule_in(const std::vector<Schema>& schemas) {
  for (const Schema& schema : schemas)
    if (schema.part->is_object() && schema.part->contains("x-gate"))
      return rule_named(schema.part->at("x-gate").get<std::string>());
  return std::nullopt;
}

/// Each schema with the schemas that it refers to, for a value that is not known.
std::vector<Schema> all_of_each(const std::vector<Schema>& schemas) {
  std::vector<Schema> all;
  for (const Schema& schema : schemas)
    for (const Schema& one : all_of(schema, nullptr)) all.push_back(one);
  return all;
}

bool has_others(const std::vector<Schema>& schemas) { return !of_member(schemas, "").empty(); }

}  // namespace

// The schema as a tree: each "$ref" is replaced by its target.
struct Rules::Field {
  std::optional<Rule> rule;
  std::map<std::string, Field, std::less<>> members;
  std::unique_ptr<Field> others, element;

  Field(const std::vector<Schema>& schemas, const std::string& place) : rule(rule_in(schemas)) {
    if (rule == Rule::left_out) return;
    for (const Schema& schema : schemas) {
      if (!schema.part->is_object() || !schema.part->contains("properties")) continue;
      for (const auto& [name, _] : schema.part->at("properties").items())
        if (!members.contains(name))
          members.try_emplace(name, all_of_each(of_member(schemas, name)),
                              place.empty() ? name : place + "." + name);
    }
    if (has_others(schemas))
      others = std::make_unique<Field>(all_of_each(of_member(schemas, "")), place + ".*");
    if (const std::vector<Schema> of = of_elements(schemas); !of.empty())
      element = std::make_unique<Field>(all_of_each(of), place + "[]");
    if (!rule && members.empty() && !others && !element)
      throw std::logic_error(fmt::format("{}: the schema has no x-gate for it", place));
  }

  const Field* member(std::string_view name) const {
    const auto found = members.find(name);
    return found != members.end() ? &found->second : others.get();
  }
};

Rules::Rules(const Schema& schema, const Json& header)
    : root_(std::make_unique<Field>(all_of(schema, &header), "")) {}
Rules::Rules(Rules&&) noexcept = default;
Rules::~Rules() = default;

std::optional<Rule> Rules::at(std::string_view place) const {
  const Field* field = root_.get();
  while (field != nullptr && !place.empty()) {
    if (place.starts_with("[]")) {
      field = field->element.get();
      place.remove_prefix(2);
    } else {
      if (place.front() == '.') place.remove_prefix(1);
      const std::string_view name = place.substr(0, place.find_first_of(".["));
      field = field->member(name);
      place.remove_prefix(name.size());
      if (name.empty() && !place.starts_with("[]")) return std::nullopt;
    }
  }
  return field != nullptr ? field->rule : std::nullopt;
}

std::optional<int> rank_of_verdict(const std::string& verdict) {
  constexpr std::array<std::string_view, 6> from_worst{"refuted",        "broken",  "incomplete",
                                                       "not_applicable", "checked", "proved"};
  for (std::size_t k = 0; k < from_worst.size(); ++k)
    if (from_worst[k] == verdict) return static_cast<int>(k);
  return std::nullopt;
}

std::optional<Rule> rule_of(const std::string& schema, const std::string& place) {
  static const auto all = [] {
    std::map<std::string, Rules, std::less<>> by_name;
    by_name.emplace("mmverify.result/1", Rules(*schema_named("mmverify.result/1"), Json::object()));
    if (const auto bench = schema_named("mmverify.bench/1"))
      for (const Json& topic : bench->document->at("/$defs/run/properties/topic/enum"_json_pointer))
        by_name.emplace("mmverify.bench/1 " + topic.get<std::string>(),
                        Rules(*bench, Json{{"topic", topic}}));
    return by_name;
  }();
  const auto known = all.find(schema);
  return known != all.end() ? known->second.at(place) : std::nullopt;
}

}  // namespace mmverify::gate
