// Flags for clang that a source is not judged with.
#pragma once

#include <optional>
#include <string>

namespace mmverify::source {

/// Why a function compiled with the flag is not judged; empty if it is.
std::optional<std::string> why_not_judged(const std::string& flag);

}  // namespace mmverify::source
