#include "cli/run_identity.hpp"

#include <fmt/format.h>

#include "cli/build_info.hpp"

namespace mmverify::cli {

using namespace proofs;

Identity program_identity() {
  return {{"program", fmt::format("{} {}", build::version, build::source_hash)}, {"spec", build::spec_hash}};
}

Identity identity_of(const std::vector<Job>& jobs, const RunOptions& options) {
  std::vector<std::string> work;
  for (const Job& job : jobs) {
    const std::string fingerprint = job.subject->fingerprint();
    work.push_back(fmt::format("{} {}{} {}..{}", job.law->id, job.subject->name(),
                               fingerprint.empty() ? "" : " " + fingerprint, job.levels.first,
                               job.levels.last));
  }
  Identity identity = program_identity();
  identity.emplace_back("work", fmt::format("{}", fmt::join(work, "; ")));
  identity.emplace_back("tier", options.tier == Tier::fast ? "fast" : "long");
  identity.emplace_back("cells", options.interiors_only ? "interior" : "all");
  identity.emplace_back("errors", fmt::format("{}", options.errors));
  identity.emplace_back("seed", fmt::format("{}", options.seed));
  return identity;
}

}  // namespace mmverify::cli
