// Results as JSON, schema mmverify.result/1 (docs/result.schema.json).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/arguments.hpp"
#include "proofs/engine/journal.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// A shard's says which it is, and of what run; `scene`: the JSON text of the member of that name, where
/// there is one; `runs_on`: of subjects that say where they run.
std::string to_json(const proofs::Report& report, std::uint64_t seed,
                    const std::optional<proofs::Shard>& shard = {}, const proofs::Identity& identity = {},
                    const std::string& scene = {}, const std::vector<RunsOn>& runs_on = {});

}  // namespace mmverify::cli
