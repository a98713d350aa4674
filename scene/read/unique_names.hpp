// Objects of JSON that have a name twice.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mmverify::scene {

/// The JSON pointer of the first member whose name its object already has: a reader takes one of the two values, and the
/// other is lost.  Nothing where there is none before the text's end, or before its first fault.
/// Source: glTF 2.0, 2.6, "names (keys) within JSON objects MUST be unique"; RFC 8259, 4.
std::optional<std::string> twice_named(std::string_view json);

}  // namespace mmverify::scene
