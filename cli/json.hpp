// Results as JSON, schema mmverify.result/1 (docs/result.schema.json).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "proofs/engine/journal.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// A shard's says which it is, and of what run; `scene`: the JSON text of the member of that name, where
/// there is one.
std::string to_json(const proofs::Report& report, std::uint64_t seed,
                    const std::optional<proofs::Shard>& shard = {}, const proofs::Identity& identity = {},
                    const std::string& scene = {});

}  // namespace mmverify::cli
