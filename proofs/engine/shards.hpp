// Merges the results of a run's shards, or explains why they do not make up the run.
#pragma once

#include "proofs/engine/journal.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::proofs {

/// The report of one shard.
struct ShardRun {
  std::string file;  ///< for messages
  Shard shard;
  Identity identity;
  Report report;
  bool finished = true;    ///< not interrupted, its mutants included
  bool as_written = true;  ///< its file is unchanged since it was written; merge_shards ignores this
};

/// Shards that belong to different runs, are incomplete, or leave out or repeat a part of a domain.
struct ShardsDoNotAddUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The report of the divided run: each result's counts, digest and counterexamples over all shares, in the order of
/// the first shard.  `law_of` gives a law by its id.
/// Domain: at least one shard.  Throws ShardsDoNotAddUp.
Report merge_shards(std::vector<ShardRun> shards, std::size_t errors,
                    const std::function<const Law&(const std::string&)>& law_of);

}  // namespace mmverify::proofs
