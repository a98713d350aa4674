// The JSON Schemas of results, and the check of a value against one.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mmverify::gate {

/// A part of a JSON Schema, and the whole document, which "$ref" points into.
struct Schema {
  const nlohmann::ordered_json *document, *part;
};

/// The schema that a result names, "mmverify.result/1" or "mmverify.bench/1"; nothing for another name.
/// Source: docs/result.schema.json, as it was when the program was built, and use_bench_schema().
std::optional<Schema> schema_named(const std::string& name);

/// Says how mmverify.bench/1 is made, once, when it is first asked for: its makers have the tables, which the
/// gate may not see. Without it there is no schema of that name.
void use_bench_schema(nlohmann::ordered_json (*made)());

/// The schema and the schemas that apply with it: by "$ref", by "allOf", one of "oneOf", one outcome of "if".
/// For an unknown value (nullptr): all of "oneOf" and both outcomes.
std::vector<Schema> all_of(const Schema& schema, const nlohmann::ordered_json* value);

/// The schemas that these give for a member of this name; empty if they allow none.
std::vector<Schema> of_member(const std::vector<Schema>& schemas, const std::string& name);

/// The schemas that these give for a list's elements.
std::vector<Schema> of_elements(const std::vector<Schema>& schemas);

/// A value that does not fit; what() is "PLACE: a text should stand here, not 7".
struct Misfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value without the members that the schema does not name: additions of a later version are no misfit. A
/// text of more than 1000 bytes fits no "pattern".
/// place: the value's name in messages; "run.json" makes "run.json.results[1].level".
/// Domain: schemas of the keywords that the two schemas use; throws std::logic_error for another. Throws
/// Misfit.
nlohmann::ordered_json known_part(const Schema& schema, const nlohmann::ordered_json& value,
                                  const std::string& place);

}  // namespace mmverify::gate
