// A finder of names that a JSON object has twice.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mmverify::scene {

/// The JSON pointer of the first member whose name its object already has: a reader takes one of the two
/// values, and loses the other.  None if there is no such member before the text's end, or before its first
/// fault.
/// Source: glTF 2.0, 2.6, "names (keys) within JSON objects MUST be unique"; RFC 8259, 4.
std::optional<std::string> twice_named(std::string_view json);

}  // namespace mmverify::scene
