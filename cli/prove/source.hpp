// A source file as a subject of index.floats.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/planning/plan.hpp"

namespace mmverify::cli {

/// The values of --source, --function and --flag.
struct SourceOptions {
  std::string file, function = "index_of";
  std::vector<std::string> flags;
  bool published = false;  ///< --dialect published
};

/// The arguments that name the source: "--source mine.c --function index_of".
std::string to_text(const SourceOptions& options);

/// The law on the compiled function, at those levels. UsageError if the source does not compile or has no
/// such function; EnvironmentError if this machine or this build lacks a tool. If an instruction is not
/// known, the law is not_applicable.
proofs::Job source_job(const SourceOptions& options, const std::optional<proofs::Levels>& levels,
                       proofs::Tier tier, double timeout_seconds);

}  // namespace mmverify::cli
