// Results that `prove --shard` wrote, read back.
#pragma once

#include <string>

#include "proofs/engine/shards.hpp"

namespace mmverify::cli {

/// One shard's file, schema mmverify.result/1.  Throws EnvironmentError, which names the file and the place
/// in it, where it is missing, is no such file or was not written with --shard.
proofs::ShardRun read_shard(const std::string& path);

}  // namespace mmverify::cli
