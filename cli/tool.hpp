// What made a result, and on what: the member "tool" of every JSON that is written.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace mmverify::cli {

/// Version, compiler, flags and processor; then the command's own settings, an object; then the hash of the
/// specification.
nlohmann::ordered_json tool(const nlohmann::ordered_json& settings);

}  // namespace mmverify::cli
