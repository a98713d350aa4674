// The first fault of a text that is no JSON, in words.
#pragma once

#include <string>
#include <string_view>

namespace mmverify::scene {

/// "line 3, column 7: no JSON from here on", or that the text ends too early; empty for JSON.  Lines and columns count
/// from 1, a column in bytes.  Domain: any bytes.  Time: O(n).
std::string json_fault(std::string_view text);

}  // namespace mmverify::scene
