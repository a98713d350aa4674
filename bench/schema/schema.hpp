// The JSON Schema of what the benches write, made of the columns of their tables.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace mmverify::bench {

/// The schema mmverify.bench/1, which `mmverify schema bench` prints. Each topic has a place in "$defs".
nlohmann::ordered_json schema();

}  // namespace mmverify::bench
