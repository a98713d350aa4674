// The types and references of what is read of a glTF file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mmverify::scene {

/// Whether brackets nest at most `deepest` deep; strings are skipped, nothing else is checked.
bool nests_at_most(const std::string& json, int deepest);

/// Errors: BadScene, with the JSON pointer of what is wrong, where a property that is read has another type
/// than glTF 2.0 gives it, a whole number lies outside [0, 2^31), an index names nothing, or a required one
/// is missing.
void check_json(const nlohmann::json& json, const std::string& file);

/// The same of a material's textures other than that of the base colour, which check_json leaves alone: whoever bakes
/// opacity reads none of them.
void check_texture_json(const nlohmann::json& json, const std::string& file);

}  // namespace mmverify::scene
