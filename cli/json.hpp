// Results as JSON, schema mmverify.result/1 (docs/result.schema.json).
#pragma once

#include <cstdint>
#include <string>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

std::string to_json(const proofs::Report& report, std::uint64_t seed);

}  // namespace mmverify::cli
