#include "cli/exit_code.hpp"

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

bool nothing_applied(const Report& report) {
  return !report.interrupted &&
         std::all_of(report.results.begin(), report.results.end(),
                     [](const Result& r) { return r.verdict == Verdict::not_applicable && !r.share; });
}

}  // namespace mmverify::cli
