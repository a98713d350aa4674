// Checks of the types and references that are read from a glTF file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mmverify::scene {

/// Whether brackets nest at most `deepest` deep; strings are skipped, nothing else is checked.
bool nests_at_most(const std::string& json, int deepest);

/// Errors: BadScene with the JSON pointer of the fault, if a property that is read has another type than in
/// glTF 2.0, a whole number lies outside [0, 2^31), an index has no target, or a required property is
/// missing.
void check_json(const nlohmann::json& json, const std::string& file);

/// The same checks for a material's textures other than the base colour's.  check_json() leaves them out,
/// since baking of opacity reads none of them.
void check_texture_json(const nlohmann::json& json, const std::string& file);

}  // namespace mmverify::scene
