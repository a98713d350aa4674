#include "delivery/gate/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string_view>

namespace mmverify::gate {
namespace {

using Json = nlohmann::ordered_json;
using Schemas = std::vector<Schema>;

// ---- One keyword

struct Type {
  std::string_view name, words;
  bool (*is)(const Json&);
};

constexpr Type types[] = {
    {"null", "null", [](const Json& j) { return j.is_null(); }},
    {"boolean", "true or false", [](const Json& j) { return j.is_boolean(); }},
    {"integer", "a whole number", [](const Json& j) { return j.is_number_integer(); }},
    {"number", "a number", [](const Json& j) { return j.is_number(); }},
    {"string", "a text", [](const Json& j) { return j.is_string(); }},
    {"array", "a list", [](const Json& j) { return j.is_array(); }},
    {"object", "an object", [](const Json& j) { return j.is_object(); }},
};

const Type& type_named(const std::string& name) {
  for (const Type& type : types)
    if (type.name == name) return type;
  throw std::logic_error("no type is called " + name);
}

/// The types that "type" allows: it is a name or a list of names.
std::vector<Type> types_of(const Json& names) {
  std::vector<Type> all;
  if (names.is_string()) return {type_named(names.get<std::string>())};
  for (const Json& name : names) all.push_back(type_named(name.get<std::string>()));
  return all;
}

bool matches(const std::string& text, const std::string& pattern) {
  // std::regex recurses for each character, so that long texts would overflow the stack.
  constexpr std::size_t longest = 1000;
  thread_local std::map<std::string, std::regex> compiled;
  return text.size() <= longest &&
         std::regex_search(text, compiled.try_emplace(pattern, pattern).first->second);
}

struct Keyword {
  std::string_view name;
  bool (*holds)(const Json& said, const Json& value);  ///< nullptr: the keyword alone refuses no value
};

constexpr Keyword keywords[] = {
    {"type",
     [](const Json& said, const Json& value) {
       const std::vector<Type> all = types_of(said);
       return std::any_of(all.begin(), all.end(), [&](const Type& type) { return type.is(value); });
     }},
    {"const", [](const Json& said, const Json& value) { return value == said; }},
    {"enum", [](const Json& said,
                const Json& value) { return std::find(said.begin(), said.end(), value) != said.end(); }},
    {"minimum", [](const Json& said, const Json& value) { return !value.is_number() || value >= said; }},
    {"maximum", [](const Json& said, const Json& value) { return !value.is_number() || value <= said; }},
    {"minLength",
     [](const Json& said, const Json& value) {
       return !value.is_string() || value.get_ref<const std::string&>().size() >= said.get<std::size_t>();
     }},
    {"pattern",
     [](const Json& said, const Json& value) {
       return !value.is_string() ||
              matches(value.get_ref<const std::string&>(), said.get_ref<const std::string&>());
     }},
    {"minItems",
     [](const Json& said, const Json& value) { return !value.is_array() || value.size() >= said; }},
    {"maxItems",
     [](const Json& said, const Json& value) { return !value.is_array() || value.size() <= said; }},
    // Keywords that all_of(), of_member() and of_elements() follow.
    {"$ref", nullptr},
    {"allOf", nullptr},
    {"oneOf", nullptr},
    {"if", nullptr},
    {"then", nullptr},
    {"else", nullptr},
    {"properties", nullptr},
    {"additionalProperties", nullptr},
    {"unevaluatedProperties", nullptr},
    {"items", nullptr},
    {"required", nullptr},  // check() handles it, with a message of its own
    // Keywords for readers and for delivery/gate/rules.cpp.
    {"$schema", nullptr},
    {"title", nullptr},
    {"description", nullptr},
    {"$comment", nullptr},
    {"$defs", nullptr},
    {"x-gate", nullptr},
};

const Keyword& keyword_named(const std::string& name) {
  for (const Keyword& keyword : keywords)
    if (keyword.name == name) return keyword;
  throw std::logic_error(fmt::format("a schema says {}, which nothing checks", name));
}

// ---- Schemas in words

/// The value as a message quotes it.
std::string as_quoted(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

/// The bounds in words: "1 or more", "0 to 31", "5 at most"; empty if there is none.
std::string bounds_in_words(const Json& part, const char* least, const char* most) {
  const bool from = part.contains(least), to = part.contains(most);
  if (from && to && part.at(least) == part.at(most)) return part.at(least).dump();
  if (from && to) return fmt::format("{} to {}", part.at(least).dump(), part.at(most).dump());
  if (from) return fmt::format("{} or more", part.at(least).dump());
  return to ? fmt::format("{} at most", part.at(most).dump()) : "";
}

/// The values that a schema allows, in words: "a whole number, 0 to 31, or null".
std::string wanted(const Json& part) {
  if (part.contains("const")) return part.at("const").dump();
  std::string words;
  if (part.contains("enum")) {
    for (const Json& one : part.at("enum")) words += (words.empty() ? "one of " : ", ") + one.dump();
    return words;
  }
  const auto with = [](const char* between, const std::string& bounds) {
    return bounds.empty() ? "" : between + bounds;
  };
  const std::string numbers = with(", ", bounds_in_words(part, "minimum", "maximum")),
                    items = with(" of ", bounds_in_words(part, "minItems", "maxItems"));
  if (!part.contains("type")) return numbers.empty() ? "a list" + items : "a number" + numbers;
  for (const Type& type : types_of(part.at("type"))) {
    if (!words.empty()) words += words.find(',') == std::string::npos ? " or " : ", or ";
    words += type.words;
    if (type.name == "integer" || type.name == "number") words += numbers;
    if (type.name == "array") words += items;
    if (type.name == "string" && part.contains("pattern"))
      words += fmt::format(" that matches {}", part.at("pattern").get<std::string>());
  }
  return words;
}

[[noreturn]] void throw_misfit(const std::string& place, const std::string& wants, const Json& value) {
  throw Misfit(fmt::format("{}: {} should stand here, not {}", place, wants, as_quoted(value)));
}

// ---- Schemas combined

Json known_part_of_all(const Schemas& schemas, const Json& value, const std::string& place);

bool fits(const Schema& schema, const Json& value) {
  try {
    known_part(schema, value, "");
    return true;
  } catch (const Misfit&) {
    return false;
  }
}

Schema referred(const Schema& schema) {
  const auto& name = schema.part->at("$ref").get_ref<const std::string&>();
  if (!name.starts_with('#')) throw std::logic_error("a schema points out of its file: " + name);
  return {schema.document, &schema.document->at(Json::json_pointer(name.substr(1)))};
}

/// The "type" of a schema, "$ref" followed; nullptr if it has none.
const Json* type_in(const Schema& schema) {
  if (schema.part->contains("type")) return &schema.part->at("type");
  return schema.part->contains("$ref") ? type_in(referred(schema)) : nullptr;
}

/// The first branch of "oneOf" that the value fits. If it fits none, a branch of the value's type, whose
/// message is to the point.
const Json* chosen(const Schema& schema, const Json& value) {
  const Json* of_type = nullptr;
  for (const Json& one : schema.part->at("oneOf")) {
    const Schema branch{schema.document, &one};
    if (fits(branch, value)) return &one;
    const Json* type = type_in(branch);
    if (type != nullptr && keyword_named("type").holds(*type, value)) of_type = &one;
  }
  return of_type;
}

void add_all_of(const Schema& schema, const Json* value, Schemas& all) {
  all.push_back(schema);
  const Json& part = *schema.part;
  if (!part.is_object()) return;
  const auto add = [&](const Json& other) { add_all_of({schema.document, &other}, value, all); };
  const auto add_if_there = [&](const char* name) {
    if (part.contains(name)) add(part.at(name));
  };
  if (part.contains("$ref")) add_all_of(referred(schema), value, all);
  if (part.contains("allOf"))
    for (const Json& one : part.at("allOf")) add(one);
  if (part.contains("if")) {
    const bool unknown = value == nullptr,
               holds = !unknown && fits({schema.document, &part.at("if")}, *value);
    if (unknown || holds) add_if_there("then");
    if (unknown || !holds) add_if_there("else");
  }
  if (!part.contains("oneOf")) return;
  if (value == nullptr) {
    for (const Json& one : part.at("oneOf")) add(one);
  } else if (const Json* one = chosen(schema, *value)) {
    add(*one);
  }
}

void check(const Schema& schema, const Json& value, const std::string& place) {
  const Json& part = *schema.part;
  if (part.is_boolean()) {
    if (!part.get<bool>()) throw_misfit(place, "nothing", value);
    return;
  }
  bool holds = true;
  for (const auto& [name, said] : part.items()) {
    const Keyword& keyword = keyword_named(name);
    holds = holds && (keyword.holds == nullptr || keyword.holds(said, value));
  }
  if (!holds) throw_misfit(place, wanted(part), value);
  if (part.contains("required") && value.is_object())
    for (const Json& member : part.at("required"))
      if (!value.contains(member.get_ref<const std::string&>()))
        throw Misfit(fmt::format("{}: no {}", place, member.dump()));
  if (!part.contains("oneOf") || chosen(schema, value) != nullptr) return;
  std::string words;
  for (const Json& one : part.at("oneOf")) {
    const Json* type = type_in({schema.document, &one});
    words += (words.empty() ? "" : " or ") + wanted(type != nullptr ? Json{{"type", *type}} : one);
  }
  throw_misfit(place, words, value);
}

Json known_part_of_all(const Schemas& schemas, const Json& value, const std::string& place) {
  Schemas all;
  for (const Schema& schema : schemas) add_all_of(schema, &value, all);
  for (const Schema& schema : all) check(schema, value, place);
  if (value.is_array()) {
    const Schemas of = of_elements(all);
    Json list = Json::array();
    if (!of.empty())
      for (const Json& one : value)
        list.push_back(known_part_of_all(of, one, fmt::format("{}[{}]", place, list.size())));
    return list;
  }
  if (!value.is_object()) return value;
  Json object = Json::object();
  for (const auto& [name, member] : value.items()) {
    const Schemas of = of_member(all, name);
    if (!of.empty()) object[name] = known_part_of_all(of, member, place + "." + name);
  }
  return object;
}

}  // namespace

std::vector<Schema> all_of(const Schema& schema, const Json* value) {
  Schemas all;
  add_all_of(schema, value, all);
  return all;
}

std::vector<Schema> of_member(const std::vector<Schema>& schemas, const std::string& name) {
  Schemas of;
  for (const auto& [document, part] : schemas) {
    if (!part->is_object()) continue;
    const auto named = part->find("properties"), others = part->find("additionalProperties");
    if (named != part->end() && named->contains(name))
      of.push_back({document, &named->at(name)});
    else if (others != part->end() && others->is_object())
      of.push_back({document, &*others});
  }
  return of;
}

std::vector<Schema> of_elements(const std::vector<Schema>& schemas) {
  Schemas of;
  for (const auto& [document, part] : schemas)
    if (part->is_object() && part->contains("items")) of.push_back({document, &part->at("items")});
  return of;
}

Json known_part(const Schema& schema, const Json& value, const std::string& place) {
  return known_part_of_all({schema}, value, place);
}

}  // namespace mmverify::gate
