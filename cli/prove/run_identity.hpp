// The identity of a run, for its journal and its shards: two runs with the same identity do the same work.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/journal.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// The identity of this program and its specification.
proofs::Identity program_identity();

/// The identity of a run: program, specification, laws, subjects (a library by its contents), levels, and the
/// options that change results.
proofs::Identity identity_of(const std::vector<proofs::Job>& jobs, const proofs::RunOptions& options);

/// The journal of this run and shard; null if the path is empty. Prints on stderr if it ends in a partial
/// line.
/// Errors: BadJournal.
std::unique_ptr<proofs::Journal> open_journal(const std::string& path, proofs::Identity identity,
                                              const std::optional<proofs::Shard>& shard);

}  // namespace mmverify::cli
