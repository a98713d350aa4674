// Writes JSON as text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mmverify::cli {

/// The value as text, indented by `indent` spaces a level, with a final line break. Names and messages come
/// from files and subjects and may be any bytes: invalid UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::ordered_json& json, int indent = 1);

/// The text with U+FFFD in place of invalid UTF-8.
std::string as_utf8(const std::string& text);

}  // namespace mmverify::cli
