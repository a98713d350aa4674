// JSON as it is written.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mmverify::cli {

/// The value as text, `indent` spaces a level and a line break at the end.  Names and messages come from files and
/// subjects and may be any bytes: what is no UTF-8 is written as U+FFFD.
std::string json_text(const nlohmann::ordered_json& json, int indent = 1);

/// The text with U+FFFD in the place of what is no UTF-8.
std::string as_utf8(const std::string& text);

}  // namespace mmverify::cli
