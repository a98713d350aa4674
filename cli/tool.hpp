// The program and machine that made a result: the member "tool" of all JSON output.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace mmverify::cli {

/// Version, compiler, flags and processor; then the command's settings, an object; then the hash of the
/// specification.
nlohmann::ordered_json tool(const nlohmann::ordered_json& settings);

}  // namespace mmverify::cli
