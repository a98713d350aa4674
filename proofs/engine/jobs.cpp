#include <algorithm>
#include <chrono>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/journal.hpp"
#include "proofs/engine/task_queue.hpp"

namespace mmverify::proofs {
namespace {

/// The job's results at the levels that ran, if one of them is refuted; else none.
std::vector<Result> refuting(const Report& report, const Job& job) {
  std::vector<Result> of_job;
  for (const Result& r : report.results)
    if (r.law == job.law->id && r.subject == job.subject->name() && r.verdict != Verdict::not_applicable)
      of_job.push_back(r);
  if (std::none_of(of_job.begin(), of_job.end(),
                   [](const Result& r) { return r.verdict == Verdict::refuted; }))
    of_job.clear();
  return of_job;
}

/// Whether another law gave the same diagnosis.
bool said_before(const Report& report, const Diagnosis& diagnosis) {
  return std::any_of(report.diagnoses.begin(), report.diagnoses.end(), [&](const Diagnosis& d) {
    return d.subject == diagnosis.subject && d.lines == diagnosis.lines;
  });
}

/// Withdraws the results of subjects whose files have changed: they may come from either version.
void withdraw_changed(const std::vector<Job>& jobs, const RunOptions& options, Report& report) {
  if (!options.change_of) return;
  bool some = false;
  std::vector<const Subject*> looked_at;
  for (const Job& job : jobs) {
    const Subject* subject = job.subject.get();
    if (std::find(looked_at.begin(), looked_at.end(), subject) != looked_at.end()) continue;
    looked_at.push_back(subject);
    const std::string change = options.change_of(*subject);
    if (change.empty()) continue;
    some = true;
    report.gave_up = change;
    for (Result& r : report.results) {
      if (r.subject != subject->name() || r.verdict == Verdict::not_applicable) continue;
      r.verdict = Verdict::incomplete;
      r.reason = change;
      r.breaks.clear();
      r.by_kind = {};
      r.counterexamples.clear();
      r.digest = 0;
      r.resumed = 0;
    }
    std::erase_if(report.diagnoses, [&](const Diagnosis& d) { return d.subject == subject->name(); });
  }
  if (some && options.journal != nullptr) options.journal->discard();
}

Run run_by(const RunOptions& options, oneapi::tbb::task_arena& arena) {
  Run run;
  run.arena = &arena;
  run.errors = options.errors;
  run.seed = options.seed;
  run.tier = options.tier;
  run.cases = options.cases;
  run.options = options.options;
  run.near = options.near;
  return run;
}

std::uint64_t count_cases(const std::vector<Job>& jobs, const Run& run, const Shard& shard) {
  std::uint64_t total = 0;
  for (const Job& job : jobs)
    for (Level n = job.levels.first; job.unfit.empty() && n <= job.levels.last; ++n)
      if (!job.law->unfit(*job.subject, n)) total += job.law->cases(n, run) / shard.of;
  return total;
}

void diagnose(const std::vector<Job>& jobs, Report& report) {
  for (const Job& job : jobs)
    if (const auto results = refuting(report, job);
        job.law->diagnose && !results.empty() && !interrupted() && report.gave_up.empty()) {
      try {
        Diagnosis diagnosis{job.law->id, job.subject->name(), job.law->diagnose(*job.subject, results)};
        if (!said_before(report, diagnosis)) report.diagnoses.push_back(std::move(diagnosis));
      } catch (const Interrupted&) {
      } catch (const NoResources&) {
        // The verdict stands without the diagnosis.
      } catch (const SubjectBroken& broken) {
        report.diagnoses.push_back({job.law->id, job.subject->name(), {broken.what()}});
      }
    }
}

/// The mutants of the laws that are run at some level, each once.
std::vector<MutantTask> mutants_of(const std::vector<Job>& jobs) {
  std::vector<const Law*> laws;
  std::vector<MutantTask> mutants;
  for (const Job& job : jobs) {
    if (std::find(laws.begin(), laws.end(), job.law) != laws.end() || !unfit_throughout(job).empty())
      continue;
    laws.push_back(job.law);
    for (const Mutant& mutant : job.law->mutants) mutants.push_back({job.law, &mutant});
  }
  return mutants;
}

}  // namespace

Report run_jobs(const std::vector<Job>& jobs, const RunOptions& options, const OnResult& on_result) {
  const auto start = std::chrono::steady_clock::now();
  Report report;
  report.threads = options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
  oneapi::tbb::task_arena arena(static_cast<int>(report.threads));
  Run run = run_by(options, arena);
  const Shard shard = options.shard.value_or(Shard{});
  Progress progress(count_cases(jobs, run, shard), options.show_progress);
  const InterruptGuard guard;
  run.progress = &progress;
  const std::vector<MutantTask> mutants =
      shard.number == 1 && options.mutants ? mutants_of(jobs) : std::vector<MutantTask>{};
  TaskQueue(jobs, mutants, options, run, report, on_result).run(report.threads);

  run.progress = nullptr;
  withdraw_changed(jobs, options, report);
  diagnose(jobs, report);
  if (!report.gave_up.empty()) report.mutants.clear();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.interrupted = interrupted();
  return report;
}

}  // namespace mmverify::proofs
