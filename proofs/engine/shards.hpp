// Puts the results of a run's shards together again, or says why they do not make up the run.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "proofs/engine/journal.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::proofs {

/// What one shard found.
struct ShardRun {
  std::string file;  ///< for messages
  Shard shard;
  Identity identity;
  Report report;
  bool finished = true;    ///< not interrupted, its mutants included
  bool as_written = true;  ///< nothing in its file was changed since; merge_shards does not ask
};

/// Shards that are not those of one run, or not all of them, or leave a part of a domain out or do it twice.
struct ShardsDoNotAddUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run that was divided: each result's counts, digest and counterexamples over all shares, in the order
/// of the first shard.  `law_of` gives a law by its id.
/// Domain: at least one shard.  Throws ShardsDoNotAddUp.
Report merge_shards(std::vector<ShardRun> shards, std::size_t errors,
                    const std::function<const Law&(const std::string&)>& law_of);

}  // namespace mmverify::proofs
