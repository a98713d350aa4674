// What a run is about, for its journal and its shards: two runs with the same identity do the same work.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/journal.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// This program and its specification.
proofs::Identity program_identity();

/// Program, specification, laws, subjects (a library by its contents), levels and options that change
/// results.
proofs::Identity identity_of(const std::vector<proofs::Job>& jobs, const proofs::RunOptions& options);

/// The journal of this run and shard; null where the path is empty.  On stderr, what of it was no whole line.
/// Errors: BadJournal.
std::unique_ptr<proofs::Journal> open_journal(const std::string& path, proofs::Identity identity,
                                              const std::optional<proofs::Shard>& shard);

}  // namespace mmverify::cli
