#include "cli/output/exit_code.hpp"

#include <algorithm>

namespace mmverify::cli {

using namespace proofs;

ExitCode exit_code(const Report& report) {
  const auto any = [&](Verdict v) {
    return std::any_of(report.results.begin(), report.results.end(),
                       [v](const Result& r) { return r.verdict == v; });
  };
  if (!report.gave_up.empty()) return ExitCode::environment;
  const bool survived =
      std::any_of(report.mutants.begin(), report.mutants.end(), [](const auto& m) { return !m.killed; });
  if (any(Verdict::refuted) || any(Verdict::broken) || survived) return ExitCode::failed;
  if (report.interrupted || any(Verdict::incomplete)) return ExitCode::interrupted;
  return ExitCode::complete;
}

void refuse_nothing(const Report& report) {
  const auto& results = report.results;
  if (report.interrupted || std::any_of(results.begin(), results.end(),
                                        [](const Result& r) { return r.verdict != Verdict::not_applicable; }))
    return;
  // An empty shard: the laws do apply, in other shards.
  if (std::any_of(results.begin(), results.end(), [](const Result& r) { return r.share.has_value(); }))
    throw UsageError(
        "nothing was run: this shard has 0 cases; merge takes its file, and with fewer shards each has "
        "cases");
  throw UsageError("nothing was run: none of these laws applies to its subject");
}

}  // namespace mmverify::cli
