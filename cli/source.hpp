// Somebody's source as a subject of index.floats.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/planning/plan.hpp"

namespace mmverify::cli {

/// What --source, --function and --flag name.
struct SourceOptions {
  std::string file, function = "index_of";
  std::vector<std::string> flags;
};

/// The command line that names it again: "--source mine.c --function index_of".
std::string to_text(const SourceOptions& options);

/// The law and the function, compiled, at those levels.  UsageError where it does not compile or has no such function;
/// where this machine or this build has no means, or an instruction is not known, the law is not_applicable.
proofs::Job source_job(const SourceOptions& options, const std::optional<proofs::Levels>& levels,
                       proofs::Tier tier, double timeout_seconds);

}  // namespace mmverify::cli
