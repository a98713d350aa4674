// What a run is about, for its journal and its shards: two runs with the same identity do the same work.
#pragma once

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

}  // namespace mmverify::cli
