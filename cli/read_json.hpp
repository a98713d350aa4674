// Files that the program wrote, read back.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "cli/arguments.hpp"
#include "proofs/engine/shards.hpp"

namespace mmverify::cli {

/// All of a file.  Throws EnvironmentError, which names it, where it cannot be read.
std::string read_text(const std::string& path);

/// A file of JSON.  Throws EnvironmentError, which names the file and the place in it, where it is missing or
/// is none.
nlohmann::ordered_json read_json(const std::string& path);

/// One shard's file, schema mmverify.result/1.  Throws EnvironmentError, which names the file and the place
/// in it, where it is missing, is no such file or was not written with --shard.
proofs::ShardRun read_shard(const std::string& path);

/// Where the subjects of such a file ran, as far as they said.  Throws as read_shard().
std::vector<RunsOn> read_runs_on(const std::string& path);

}  // namespace mmverify::cli
