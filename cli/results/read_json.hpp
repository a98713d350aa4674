// Reads files that the program wrote.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "proofs/engine/shards.hpp"

namespace mmverify::cli {

/// The content of a file. Throws EnvironmentError, which names the file, if it cannot be read.
std::string read_text(const std::string& path);

/// A JSON file. Throws EnvironmentError, which names the file and the place in it, if it is missing or no
/// JSON.
nlohmann::ordered_json read_json(const std::string& path);

/// A shard's file, schema mmverify.result/1. Throws EnvironmentError, which names the file and the place in
/// it, if it is missing, no such file, or was not written with --shard.
proofs::ShardRun read_shard(const std::string& path);

/// The descriptions in such a file of where subjects ran. Throws as read_shard().
std::vector<RunsOn> read_runs_on(const std::string& path);

}  // namespace mmverify::cli
