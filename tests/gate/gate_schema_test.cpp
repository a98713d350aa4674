// The schemas in the program: whether a value fits, in what words it does not, and each field's rule.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "bench/schema/schema.hpp"
#include "delivery/gate/rules.hpp"
#include "delivery/gate/schema.hpp"
#include "tests/complaint.hpp"

namespace {

using namespace mmverify::gate;
using testing::HasSubstr;
using Tree = nlohmann::ordered_json;

// The program of these tests has the benches' schema, as mmverify has.
[[maybe_unused]] const bool has_bench_schema = (use_bench_schema(mmverify::bench::schema), true);

/// The complaint about a value; empty where it fits.
std::string misfit(const Tree& schema, const Tree& value) {
  return mmverify::tests::complaint_of<Misfit>([&] { known_part({&schema, &schema}, value, "file"); }, "");
}
std::string misfit(const char* schema, const char* value) {
  return misfit(Tree::parse(schema), Tree::parse(value));
}

TEST(Schema, EachKeywordIsCheckedAndSaysWhatItWants) {
  const struct {
    const char *schema, *good, *bad, *words;
  } all[] = {
      {R"({"type": "string"})", R"("")", "7", "file: a text should stand here, not 7"},
      {R"({"type": "number"})", "0.5", R"("x")", R"(a number should stand here, not "x")"},
      {R"({"type": "integer"})", "-3", "0.5", "a whole number should stand here, not 0.5"},
      {R"({"type": "boolean"})", "false", "0", "true or false should"},
      {R"({"type": "object"})", "{}", "[1, 2]", "an object should stand here, not a list of 2"},
      {R"({"type": "array"})", "[]", "{}", "a list should stand here, not an object"},
      {R"({"type": ["integer", "null"], "minimum": 0, "maximum": 31})", "null", "32",
       "a whole number, 0 to 31, or null should stand here, not 32"},
      {R"({"minimum": 1})", "1", "0", "a number, 1 or more should"},
      {R"({"maximum": 1})", R"("no number")", "1.5", "a number, 1 at most should"},
      {R"({"const": "a/1"})", R"("a/1")", R"("a/2")", R"("a/1" should stand here, not "a/2")"},
      {R"({"enum": ["a", 2]})", "2", R"("2")", R"(one of "a", 2 should)"},
      {R"({"type": "string", "minLength": 1})", R"("x")", R"("")", R"(a text should stand here, not "")"},
      {R"({"type": "string", "pattern": "^[0-9a-f]{2}$"})", R"("0f")", R"("0F")",
       "a text that matches ^[0-9a-f]{2}$"},
      {R"({"type": "array", "minItems": 1})", "[1]", "[]",
       "a list of 1 or more should stand here, not a list of 0"},
      {R"({"minItems": 2, "maxItems": 2})", "[1, 2]", "[1, 2, 3]", "a list of 2 should"},
      {R"({"required": ["a"]})", R"({"a": null})", "{}", R"(file: no "a")"},
      {R"({"properties": {"a": {"type": "null"}}})", R"({"b": 1})", R"({"a": 1})", "file.a: null should"},
      {R"({"properties": {"a": false}})", "{}", R"({"a": 1})", "file.a: nothing should"},
      {R"({"additionalProperties": {"type": "null"}})", R"({"a": null})", R"({"a": 1})",
       "file.a: null should"},
      {R"({"items": {"type": "null"}})", "[null]", "[null, 1]", "file[1]: null should"},
      {R"({"$ref": "#/$defs/a", "$defs": {"a": {"minimum": 1}}})", "1", "0", "1 or more"},
      {R"({"allOf": [{"minimum": 1}, {"maximum": 2}]})", "2", "3", "2 at most"},
      {R"({"oneOf": [{"type": "null"}, {"type": "object", "required": ["a"]}]})", "null", "5",
       "null or an object should stand here, not 5"},
      {R"({"oneOf": [{"type": "null"}, {"type": "object", "required": ["a"]}]})", R"({"a": 1})", "{}",
       R"(file: no "a")"},
      {R"({"if": {"required": ["a"]}, "then": {"required": ["b"]}, "else": {"required": ["c"]}})",
       R"({"a": 1, "b": 1})", R"({"a": 1})", R"(no "b")"},
      {R"({"if": {"required": ["a"]}, "then": {"required": ["b"]}, "else": {"required": ["c"]}})",
       R"({"c": 1})", "{}", R"(no "c")"},
  };
  for (const auto& [schema, good, bad, words] : all) {
    EXPECT_EQ(misfit(schema, good), "") << schema;
    EXPECT_THAT(misfit(schema, bad), HasSubstr(words)) << schema;
  }
}

TEST(Schema, AKeywordThatNothingChecksIsNoSilence) {
  EXPECT_THROW(misfit(R"({"multipleOf": 2})", "2"), std::logic_error);
  EXPECT_THROW(misfit(R"({"$ref": "other.json#/x"})", "2"), std::logic_error);
}

TEST(Schema, APatternSurvivesAnyText) {
  EXPECT_THAT(misfit(Tree::parse(R"({"type": "string", "pattern": "^[a-z]+(\\.[a-z]+)+$"})"),
                     std::string(1 << 20, 'a')),
              HasSubstr("not \"aaa"));
}

TEST(Schema, WhatItDoesNotNameIsLeftOut) {
  const Tree schema = Tree::parse(
      R"({"properties": {"a": {"items": {"properties": {"b": {}}}}}, "allOf": [{"properties": {"d": {}}}]})");
  EXPECT_EQ(known_part({&schema, &schema}, Tree::parse(R"({"a": [{"b": 1, "c": 2}], "c": 3, "d": 4})"), ""),
            Tree::parse(R"({"a": [{"b": 1}], "d": 4})"));
}

/// Every part of a schema that is a schema, with its place.
void for_each_part(const Tree& part, const std::string& place,
                   const std::function<void(const Tree&, const std::string&)>& call) {
  call(part, place);
  for (const char* name : {"properties", "$defs"})
    if (part.contains(name))
      for (const auto& [key, one] : part.at(name).items())
        for_each_part(one, place + "/" + name + "/" + key, call);
  for (const char* name : {"allOf", "oneOf"})
    if (part.contains(name))
      for (const Tree& one : part.at(name)) for_each_part(one, place + "/" + name, call);
  for (const char* name : {"items", "additionalProperties", "if", "then", "else"})
    if (part.contains(name)) for_each_part(part.at(name), place + "/" + name, call);
}

TEST(Schema, BothSchemasSayOnlyWhatIsChecked) {
  for (const char* name : {"mmverify.result/1", "mmverify.bench/1"}) {
    const Schema schema = *schema_named(name);
    for_each_part(*schema.document, name, [&](const Tree& part, const std::string& place) {
      try {
        known_part({schema.document, &part}, Tree(), place);
      } catch (const Misfit&) {  // a null, which most parts do not take
      } catch (const std::logic_error& unknown) {
        ADD_FAILURE() << place << ": " << unknown.what();
      }
    });
  }
  EXPECT_FALSE(schema_named("mmverify.result/2"));
}

// ---- Rules

TEST(SchemaRules, EachFieldOfBothSchemasHasOne) {
  EXPECT_NO_THROW(Rules(*schema_named("mmverify.result/1"), Tree::object()));
  const Schema bench = *schema_named("mmverify.bench/1");
  const Tree topics = bench.document->at("/$defs/run/properties/topic/enum"_json_pointer);
  ASSERT_FALSE(topics.empty());
  for (const Tree& topic : topics) EXPECT_NO_THROW(Rules(bench, Tree{{"topic", topic}})) << topic;
}

TEST(SchemaRules, AFieldWithoutOneIsNamed) {
  // Rules of the real schema taken away.
  std::size_t taken = 0;
  const Tree whole = *schema_named("mmverify.result/1")->document;
  for (const char* at : {"/$defs/kind/properties/declined", "/$defs/saved/properties/area",
                         "/$defs/result/properties/digest", "/$defs/result/properties/counterexample"}) {
    Tree changed = whole;
    taken += changed.at(Tree::json_pointer(at)).erase("x-gate");
    EXPECT_THROW(Rules({&changed, &changed}, Tree::object()), std::logic_error) << at;
  }
  EXPECT_EQ(taken, 4u);
  const Tree nameless =
      Tree::parse(R"({"properties": {"a": {"items": {"properties": {"b": {"type": "null"}}}}}})");
  EXPECT_THAT(mmverify::tests::complaint_of<std::logic_error>([&] {
                Rules({&nameless, &nameless}, Tree::object());
              }),
              HasSubstr("a[].b: "));
}

TEST(SchemaRules, TheRuleBesideAReferenceComesFirst) {
  const Tree schema = Tree::parse(R"({"properties": {
    "a": {"x-gate": "more", "$ref": "#/$defs/n"}, "b": {"$ref": "#/$defs/n"},
    "c": {"additionalProperties": {"x-gate": "same"}}, "d": {"x-gate": "left_out", "properties": {"e": {}}}},
    "$defs": {"n": {"x-gate": "less"}}})");
  const Rules rules({&schema, &schema}, Tree::object());
  EXPECT_EQ(rules.at("a"), Rule::more);
  EXPECT_EQ(rules.at("b"), Rule::less);
  EXPECT_EQ(rules.at("c.anything"), Rule::same);
  EXPECT_EQ(rules.at("d"), Rule::left_out);
  for (const char* none : {"c", "e", "a.b", "a[]", "d.e", "c[]", "", ".", "[]", "c."})
    EXPECT_EQ(rules.at(none), std::nullopt) << none;
}

}  // namespace
