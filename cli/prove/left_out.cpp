#include "cli/prove/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

/// Whether one of the jobs' laws covers the level on this subject. If laws were named, every level counts as
/// requested.
bool is_asked(const Names& names, const std::vector<Job>& jobs, const std::string& subject, Level n) {
  return !names.laws.empty() || std::any_of(jobs.begin(), jobs.end(), [&](const Job& job) {
    const Levels& of_law = job.law->tiers.long_run;
    return job.subject->name() == subject && job.law->at_once.empty() && of_law.first <= n &&
           n <= of_law.last;
  });
}

/// Throws UsageError for a level of --levels that no law judged: on each named subject that is present, or,
/// if none was named, on all subjects together.
void refuse_levels(const Names& names, const std::vector<Job>& jobs, const Report& report) {
  if (!names.levels) return;
  const Levels asked = parse_levels(*names.levels);
  std::vector<std::string> subjects;
  if (names.subjects.empty()) subjects.emplace_back();
  for (const Job& job : jobs)
    if (!names.subjects.empty() && job.subject->absent().empty()) subjects.push_back(job.subject->name());
  for (const std::string& subject : subjects) {
    std::vector<Level> left = levels_not_judged(report.results, subject, asked);
    if (!subject.empty()) std::erase_if(left, [&](Level n) { return !is_asked(names, jobs, subject, n); });
    if (left.empty()) continue;
    const auto result = std::find_if(report.results.begin(), report.results.end(), [&](const Result& r) {
      return r.verdict == Verdict::not_applicable && r.at_once.empty() &&
             (r.level == left.front() || r.level == left.back()) && (subject.empty() || r.subject == subject);
    });
    throw UsageError(fmt::format("--levels {}: {} {} not judged{}{}; choose levels at which the law runs",
                                 *names.levels, left.size() == 1 ? "level" : "levels",
                                 level_ranges(left) + (left.size() == 1 ? " was" : " were"),
                                 subject.empty() ? "" : " of " + subject,
                                 result == report.results.end() ? "" : ": " + result->reason));
  }
}

/// The reason why none of the results that `is_of` selects judged anything; empty if one did, or if there is
/// none.
std::string why_nothing(const Report& report, const std::function<bool(const Result&)>& is_of) {
  std::string why;
  for (const Result& r : report.results) {
    if (!is_of(r)) continue;
    if (r.verdict != Verdict::not_applicable || r.share) return {};
    why = r.reason;
  }
  return why;
}

/// Throws UsageError for a named law or subject that judged nothing.
void refuse_names(const Names& names, const std::vector<Job>& jobs, const Report& report) {
  const auto refuse = [](const std::string& name, const std::string& why) {
    if (!why.empty())
      throw UsageError(fmt::format("{} was asked for, and nothing was judged: {}", name, why));
  };
  const auto is_here = [&](const std::string& subject) {
    return std::any_of(jobs.begin(), jobs.end(), [&](const Job& job) {
      return job.subject->name() == subject && job.subject->absent().empty();
    });
  };
  for (const std::string& law : names.laws)
    refuse(law, why_nothing(report, [&](const Result& r) { return r.law == law && is_here(r.subject); }));
  // The subjects of a library or shader have its name as a prefix.
  const auto is_of = [](const std::string& name, const std::string& subject) {
    return subject.starts_with(name);
  };
  for (const std::string& name : names.subjects) {
    const auto job =
        std::find_if(jobs.begin(), jobs.end(), [&](const Job& j) { return is_of(name, j.subject->name()); });
    if (job == jobs.end()) refuse(name, "none of these laws calls an entry point of it");
    if (job->subject->absent().empty())
      refuse(name, why_nothing(report, [&](const Result& r) { return is_of(name, r.subject); }));
  }
}

}  // namespace

void refuse_what_was_left_out(const Names& names, const std::vector<Job>& jobs, const Report& report) {
  refuse_levels(names, jobs, report);
  refuse_names(names, jobs, report);
}

std::vector<std::string> levels_left(const std::vector<Job>& jobs, const Report& report) {
  constexpr Level highest = 16;
  // The laws of each subject that have levels.
  std::map<std::string, std::vector<const Job*>> jobs_of;
  for (const Job& job : jobs)
    if (job.unfit.empty() && job.law->at_once.empty() && !job.subject->fingerprint().empty())
      jobs_of[job.subject->name()].push_back(&job);
  std::vector<std::string> lines;
  for (const auto& [name, of_subject] : jobs_of) {
    Level lowest = highest, ran = 0;
    bool holds = false;
    for (const Result& r : report.results) {
      if (r.subject != name || r.verdict == Verdict::not_applicable) continue;
      lowest = std::min(lowest, r.level);
      ran = std::max(ran, r.level);
      holds = r.verdict == Verdict::proved || r.verdict == Verdict::checked;
      if (!holds) break;
    }
    const auto is_judged = [&, of = of_subject](Level n) {
      return std::any_of(of.begin(), of.end(),
                         [n](const Job* job) { return !job->law->unfit(*job->subject, n); });
    };
    std::vector<Level> left;
    for (Level n = 0; n <= highest; ++n)
      if ((n < lowest || n > ran) && is_judged(n)) left.push_back(n);
    if (holds && !left.empty())
      lines.push_back(fmt::format("{} of {} {} not run: leave --levels out, or widen it",
                                  (left.size() == 1 ? "level " : "levels ") + level_ranges(left), name,
                                  left.size() == 1 ? "was" : "were"));
  }
  return lines;
}

}  // namespace mmverify::cli
