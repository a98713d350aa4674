#include "cli/run_identity.hpp"

#include <fmt/format.h>

#include "cli/build_info.hpp"

namespace mmverify::cli {

using namespace proofs;

Identity identity_of(const std::vector<Job>& jobs, const RunOptions& options) {
  std::vector<std::string> work;
  for (const Job& job : jobs) {
    const std::string fingerprint = job.subject->fingerprint();
    work.push_back(fmt::format("{} {}{} {}..{}", job.law->id, job.subject->name(),
                               fingerprint.empty() ? "" : " " + fingerprint, job.levels.first,
                               job.levels.last));
  }
  return {{"program", fmt::format("{} {}", build::version, build::source_hash)},
          {"spec", build::spec_hash},
          {"work", fmt::format("{}", fmt::join(work, "; "))},
          {"tier", options.tier == Tier::fast ? "fast" : "long"},
          {"cells", options.interiors_only ? "interior" : "all"},
          {"errors", fmt::format("{}", options.errors)},
          {"seed", fmt::format("{}", options.seed)}};
}

}  // namespace mmverify::cli
