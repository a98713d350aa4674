#include "bench/schema/schema.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/scene/examples.hpp"

namespace mmverify::bench {
namespace {

using Json = nlohmann::ordered_json;
using Type = Property::Type;

const char* name_of(Rule rule) {
  constexpr const char* names[] = {"",           "key",        "setting", "verdict",    "more",
                                   "less",       "same",       "about",   "about_more", "about_less",
                                   "speed_more", "speed_less", "left_out"};
  return names[static_cast<std::size_t>(rule)];
}

Json empty_object() {
  return {{"type", "object"},
          {"additionalProperties", false},
          {"required", Json::array()},
          {"properties", Json::object()}};
}

void add_facts(Json& schema, const Property& property) {
  if (!property.description.empty()) schema["description"] = property.description;
  if (property.rule != no_rule) schema["x-gate"] = name_of(property.rule);
}

void add_bounds(Json& schema, const Bounds& bounds, const char* least, const char* most) {
  if (bounds.least) schema[least] = *bounds.least;
  if (bounds.most) schema[most] = *bounds.most;
}

/// The schema of a value.  Throws std::logic_error, which names the property, if it has no facts.
Json value_schema(const Property& property) {
  Json schema = Json::object();
  if (property.type == Type::words) {
    Json words = Json::array();
    for (const auto& word : property.words) std::visit([&](const auto& w) { words.push_back(w); }, word);
    if (words.size() == 1)
      schema["const"] = words.front();
    else
      schema["enum"] = words;
  } else if (property.type == Type::text) {
    schema = {{"type", "string"}, {"minLength", 1}};
  } else if (property.type == Type::integer || property.type == Type::number) {
    schema["type"] = property.type == Type::integer ? "integer" : "number";
    add_bounds(schema, property.bounds, "minimum", "maximum");
  } else {
    throw std::logic_error(property.name + ": the schema has no facts of it");
  }
  if (property.elements.least) {
    if (property.rule != no_rule) schema["x-gate"] = name_of(property.rule);
    Json list{{"type", "array"}, {"items", schema}};
    add_bounds(list, property.elements, "minItems", "maxItems");
    list["description"] = property.description;
    return list;
  }
  add_facts(schema, property);
  return schema;
}

/// Says that the object has the property: always, if it can, or exactly if a condition holds.
void add_presence(Json& object, const std::string& name, const Property& property) {
  Json& required = object["required"];
  if (const auto at = std::find(required.begin(), required.end(), name); at != required.end())
    required.erase(at);
  if (!property.there_if.empty()) {
    object["if"]["properties"] = Json::parse(property.there_if);
    object["then"]["required"].push_back(name);
    object["else"]["properties"][name] = false;
  } else if (property.required) {
    required.push_back(name);
  }
}

/// The object that a property "a.b" is a member of.
Json& object_with(Json& object, const std::string& name) {
  const auto dot = name.find('.');
  if (dot == std::string::npos) return object;
  const std::string first = name.substr(0, dot);
  Json& properties = object["properties"];
  if (!properties.contains(first)) {
    properties[first] = empty_object();
    object["required"].push_back(first);
  }
  return object_with(properties[first], name.substr(dot + 1));
}

void add_property(Json& whole, const Property& property, const Json& schema) {
  Json& object = object_with(whole, property.name);
  const std::string name = property.name.substr(property.name.rfind('.') + 1);
  object["properties"][name] = schema;
  add_presence(object, name, property);
}

/// The facts of an object whose members are other properties.
void add_note(Json& whole, const Property& property) {
  Json& object = object_with(whole, property.name);
  const std::string name = property.name.substr(property.name.rfind('.') + 1);
  if (!object["properties"].contains(name)) object["properties"][name] = empty_object();
  add_facts(object["properties"][name], property);
  add_presence(object, name, property);
}

void add_columns(Json& object, const std::vector<Column>& columns);

/// Adds rows of a table, or of a table within: a list of objects, or an object whose members a column names.
void add_rows(Json& object, const Property& key, Form form, const std::string& row,
              const std::vector<Column>& columns) {
  Json of_row = empty_object();
  if (!row.empty()) of_row["description"] = row;
  add_columns(of_row, columns);
  Json rows = empty_object();
  if (form == Form::object) {
    for (const auto& word : columns.front().key.words) {
      Property member = key;
      member.name = std::get<std::string>(word);
      add_property(rows, member, of_row);
    }
  } else {
    rows = {{"type", "array"}};
    add_bounds(rows, key.type == Type::list ? key.bounds : Bounds{1}, "minItems", "maxItems");
    rows["items"] = of_row;
  }
  add_facts(rows, key);
  add_property(object, key, rows);
}

void add_columns(Json& object, const std::vector<Column>& columns) {
  for (const Column& column : columns) {
    if (column.key.name.empty()) continue;
    if (!column.columns.empty())
      add_rows(object, column.key, column.form, column.row, column.columns);
    else if (column.key.type == Type::object)
      add_note(object, column.key);
    else
      add_property(object, column.key, value_schema(column.key));
  }
}

Json constant(const std::string& value) { return {{"x-gate", "left_out"}, {"const", value}}; }

/// Adds what a result of a topic adds to the topic's schema: another result may have other tables.
void add_result(Json& topic, const Result& result) {
  if (topic.is_null()) {
    topic = empty_object();
    topic["description"] = result.description;
    add_property(topic, {"schema"}, constant("mmverify.bench/1"));
    add_property(topic, {"topic"}, constant(result.topic));
    add_property(topic, {"tool"}, {{"$ref", "#/$defs/tool"}, {"unevaluatedProperties", false}});
  }
  Json& tool = topic["properties"]["tool"];
  for (const Setting& one : result.settings) {
    if (!tool.contains("required")) tool["required"] = Json::array();
    add_property(tool, one.key, value_schema(one.key));
  }
  for (const Table& table : result.tables)
    if (table.form == Form::members)
      add_columns(topic, table.columns);
    else if (table.form != Form::printed)
      add_rows(topic, table.key, table.form, table.row, table.columns);
}

/// The schema of "tool", which cli/tool.hpp writes.
Json tool() {
  Json schema{{"description", "what made it, and on what"},
              {"type", "object"},
              {"required", Json::array()},
              {"properties", Json::object()}};
  for (const char* name : {"version", "compiler", "flags", "cpu"})
    add_property(schema, {name}, value_schema(text(name, left_out)));
  schema["properties"]["flags"].erase("minLength");
  add_property(schema, {"spec_hash"},
               value_schema(text("spec_hash", left_out, "of the specification's sources")));
  return schema;
}

std::vector<std::string> topics_of(const std::vector<Result>& results) {
  std::vector<std::string> topics;
  for (const Result& result : results)
    if (std::find(topics.begin(), topics.end(), result.topic) == topics.end()) topics.push_back(result.topic);
  return topics;
}

}  // namespace

Json schema() {
  const std::vector<Result> several = examples_of_topics(), others = other_examples();
  std::vector<Result> all = several;
  all.insert(all.end(), others.begin(), others.end());
  const std::vector<std::string> together = topics_of(several), topics = topics_of(all);
  Json run = empty_object(), defs;
  run.erase("additionalProperties");
  add_property(run, {"schema"}, {{"const", "mmverify.bench/1"}});
  add_property(run, {"topic"}, {{"enum", topics}});
  for (const std::string& topic : topics)
    run["allOf"].push_back({{"if", {{"properties", {{"topic", {{"const", topic}}}}}}},
                            {"then", {{"$ref", "#/$defs/" + topic}}}});
  defs = {{"run", run}, {"tool", tool()}};
  for (const Result& result : all) add_result(defs[result.topic], result);
  const Json ref_run{{"$ref", "#/$defs/run"}};
  return {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "mmverify.bench/1"},
      {"description",
       "What mmverify bench writes with --json: one topic, or a list of several. Times are of one machine; "
       "ratios are of one run. scripts/check-schema also checks what a schema cannot say: the sums."},
      {"$comment", "x-gate: how mmverify gate compares a field; result.schema.json has the list."},
      {"if", {{"type", "array"}}},
      {"then",
       {{"minItems", 2},
        {"maxItems", together.size()},
        {"items", {{"allOf", {ref_run, {{"properties", {{"topic", {{"enum", together}}}}}}}}}}}},
      {"else", ref_run},
      {"$defs", defs}};
}

}  // namespace mmverify::bench
