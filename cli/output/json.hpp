// Results as JSON, schema mmverify.result/1 (docs/result.schema.json).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/arguments/arguments.hpp"
#include "proofs/engine/journal.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// The report as JSON. `shard`, `identity`: the shard, and the run that it belongs to; `scene`: the JSON text
/// of the member "scene", if there is one; `runs_on`: for subjects that describe where they run; `cause`: the JSON
/// text of the member "cause", if there is one.
std::string to_json(const proofs::Report& report, std::uint64_t seed,
                    const std::optional<proofs::Shard>& shard = {}, const proofs::Identity& identity = {},
                    const std::string& scene = {}, const std::vector<RunsOn>& runs_on = {},
                    const std::string& cause = {});

}  // namespace mmverify::cli
