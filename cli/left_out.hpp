// Refuses a run of mmverify prove in which a law, a subject or a level that was named was not judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"
#include "proofs/planning/plan.hpp"

namespace mmverify::cli {

/// The words of the command that name what is to be judged.
struct Names {
  const std::optional<std::string>& levels;  ///< of --levels
  const std::vector<std::string>&laws, &subjects;
};

/// UsageError for the first level of --levels, law or subject that was named and that nothing judged: whatever else was
/// judged, the run is no success.  A subject that is not here, as its device is not, is passed over.
void refuse_what_was_left_out(const Names& names, const std::vector<proofs::Job>& jobs,
                              const proofs::Report& report);

}  // namespace mmverify::cli
