#include "cli/prove/run_identity.hpp"

#include <fmt/format.h>

#include "cli/build_info.hpp"
#include "cli/output/streams.hpp"
#include "proofs/index/options.hpp"

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
  identity.emplace_back("near", fmt::format("{}", options.near));
  identity.emplace_back("cells", has(options.options, proofs::index::interiors_only) ? "interior" : "all");
  if (options.cases != 0) identity.emplace_back("cases", fmt::format("{}", options.cases));
  identity.emplace_back("errors", fmt::format("{}", options.errors));
  identity.emplace_back("seed", fmt::format("{}", options.seed));
  return identity;
}

std::unique_ptr<Journal> open_journal(const std::string& path, Identity identity,
                                      const std::optional<Shard>& shard) {
  if (path.empty()) return nullptr;
  identity.emplace_back("shard", shard ? fmt::format("{}/{}", shard->number, shard->of) : "none");
  auto journal = std::make_unique<Journal>(path, std::move(identity));
  if (journal->dropped() != 0)
    say(stderr, "{}: {} of its bytes are in damaged lines; the work that these record is done again\n", path,
        journal->dropped());
  return journal;
}

}  // namespace mmverify::cli
