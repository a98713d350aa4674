// The JSON Schemas of results, and whether a value fits one.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mmverify::gate {

/// A part of a JSON Schema, and the whole, which "$ref" points into.
struct Schema {
  const nlohmann::ordered_json *document, *part;
};

/// The schema that a result names as its own, "mmverify.result/1" or "mmverify.bench/1"; nothing for another
/// name.  Source: docs/result.schema.json and docs/bench.schema.json, as they were when the program was built.
std::optional<Schema> schema_named(const std::string& name);

/// The schema, and what holds together with it: "$ref", "allOf", of "oneOf" one, of "if" one outcome.  Of an
/// unknown value (nullptr) all of "oneOf" and both outcomes.
std::vector<Schema> all_of(const Schema& schema, const nlohmann::ordered_json* value);

/// What they say of a member of this name; empty where none names it.
std::vector<Schema> of_member(const std::vector<Schema>& schemas, const std::string& name);

/// What they say of a list's elements.
std::vector<Schema> of_elements(const std::vector<Schema>& schemas);

/// A value that does not fit; what() is "PLACE: a text should stand here, not 7".
struct Misfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value without the members that the schema does not name: what a later version adds is no misfit.
/// place: what the value is called in a message; "run.json" makes "run.json.results[1].level".
/// Domain: schemas of the keywords that the two schemas use; throws std::logic_error for another.  Throws
/// Misfit.  A text of more than 1000 bytes fits no "pattern".
nlohmann::ordered_json known_part(const Schema& schema, const nlohmann::ordered_json& value,
                                  const std::string& place);

}  // namespace mmverify::gate
