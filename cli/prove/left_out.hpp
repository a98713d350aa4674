// Refuses a run of mmverify prove in which a named law, subject or level was not judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"
#include "proofs/planning/plan.hpp"

namespace mmverify::cli {

/// The arguments that name laws, subjects and levels.
struct Names {
  const std::optional<std::string>& levels;  ///< from --levels
  const std::vector<std::string>&laws, &subjects;
};

/// Throws UsageError for the first level of --levels, law or subject that was named and that nothing judged:
/// even if others were, the run is no success. A subject that is absent, because its device is, is skipped.
void refuse_what_was_left_out(const Names& names, const std::vector<proofs::Job>& jobs,
                              const proofs::Report& report);

/// A line for each library in which nothing is refuted and whose first law has cases above the levels of --levels.
std::vector<std::string> levels_left(const std::vector<proofs::Job>& jobs, const proofs::Report& report);

}  // namespace mmverify::cli
