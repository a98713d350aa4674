// Changes of a JSON text that leave the rest of it as it is.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mmverify::scene {

/// The text with the values of `is`.  Values that are equal keep their bytes, and so does the space between them; a new
/// member or element stands behind the last one, after the same space as that.
/// Domain: `text` is JSON, `was` its value, no member of an object twice.  Errors: std::invalid_argument where the text
/// is not that of `was`.
/// Test: scene_edit_test
std::string patched_json(const std::string& text, const nlohmann::json& was, const nlohmann::json& is);

}  // namespace mmverify::scene
