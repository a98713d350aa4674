#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/journal.hpp"
#include "proofs/engine/runner.hpp"

namespace mmverify::proofs {
namespace {

/// The result of a law that cannot be divided and that another shard runs.
Result of_another_shard(const Law& law, const Subject& subject, Level level, const Run& run) {
  if (const auto why = law.unfit(subject, level)) return not_applicable(law, subject, level, run, *why);
  Result r = not_applicable(law, subject, level, run, "another shard runs all of it");
  r.cases_expected = law.cases(level, run);
  r.share = Share{0, 0, 1};
  return r;
}

/// The journal's name for a job's level.
std::string about(const Job& job, Level level) {
  return fmt::format("{} {} level {}", job.law->id, job.subject->name(), level);
}

/// The reason why the job has no level to run; empty if it has one.
std::string unfit_throughout(const Job& job) {
  std::string why = job.unfit;
  for (Level n = job.levels.first; why.empty() && n <= job.levels.last; ++n)
    if (!job.law->unfit(*job.subject, n)) return {};
  return why.empty() ? job.law->unfit(*job.subject, job.levels.first).value_or("no level") : why;
}

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

/// The laws of the jobs that are run at some level, each once.
std::vector<const Law*> laws_run(const std::vector<Job>& jobs) {
  std::vector<const Law*> laws;
  for (const Job& job : jobs)
    if (unfit_throughout(job).empty() && std::find(laws.begin(), laws.end(), job.law) == laws.end())
      laws.push_back(job.law);
  return laws;
}

/// The jobs of a run, which one thread takes one after another or several side by side.
class JobQueue {
 public:
  JobQueue(const std::vector<Job>& jobs, const RunOptions& options, const Run& run, Report& report,
           const OnResult& on_result)
      : jobs_(jobs),
        options_(options),
        run_(run),
        report_(report),
        on_result_(on_result),
        held_(jobs.size()) {
    order_.resize(jobs.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (options.side_by_side)
      std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
        return jobs[a].law->tiers.seconds > jobs[b].law->tiers.seconds;
      });
    std::uint64_t levels = 0;
    for (const Job& job : jobs) {
      whole_before_.push_back(levels);
      if (!job.law->divisible && unfit_throughout(job).empty())
        levels += job.levels.last - job.levels.first + 1;
    }
  }

  void run(unsigned threads) {
    if (options_.side_by_side)
      run_.arena->execute([&] {
        oneapi::tbb::parallel_for(
            0u, threads, [&](unsigned) { take_until_empty(); }, oneapi::tbb::simple_partitioner());
      });
    else
      take_until_empty();
    // Jobs that did not begin, for want of a resource, leave results of later ones waiting.
    for (std::size_t k = first_unfinished_; k < jobs_.size(); ++k) pass_on(k);
  }

 private:
  void take_until_empty() {
    for (std::size_t k = next_++; k < jobs_.size() && !gave_up(); k = next_++)
      // A thread that waits within a law must not begin another one: the first may have a lock.
      oneapi::tbb::this_task_arena::isolate([&] { run_job(order_[k]); });
  }

  void run_job(std::size_t k) {
    const Job& job = jobs_[k];
    Run run = run_;
    if (const std::string why = unfit_throughout(job); !why.empty()) {
      report(k, not_applicable(*job.law, *job.subject, job.levels.first, run, why));
      return finish(k);
    }
    Breaks breaks;
    run.breaks = &breaks;
    std::uint64_t whole_laws = whole_before_[k];  // dealt to the shards in turn
    for (Level n = job.levels.first; n <= job.levels.last && !gave_up(); ++n) {
      const Result r = run_at(job, n, run, whole_laws++);
      report(k, r);
      // A subject that breaks on all of a level would do so at the next level; the run continues with the next law.
      if (r.verdict == Verdict::broken && r.breaks.empty()) break;
    }
    finish(k);
  }

  Result run_at(const Job& job, Level n, Run& run, std::uint64_t whole_law) {
    const Shard shard = options_.shard.value_or(Shard{});
    Division division{options_.shard, options_.journal, about(job, n), {}, 0, false};
    run.division = options_.journal != nullptr || options_.shard ? &division : nullptr;
    try {
      const bool elsewhere = !job.law->divisible && whole_law % shard.of != shard.number - 1;
      return elsewhere ? of_another_shard(*job.law, *job.subject, n, run)
                       : run_level(*job.law, *job.subject, n, run);
    } catch (const NoResources& why) {
      // This shows nothing about the subject; earlier results stand.
      {
        const std::lock_guard hold(lock_);
        if (report_.gave_up.empty()) report_.gave_up = why.what();
      }
      return cut_short(*job.law, *job.subject, n, run, why.what());
    }
  }

  bool gave_up() {
    const std::lock_guard hold(lock_);
    return !report_.gave_up.empty();
  }

  /// Reports a result of job k, at once if all earlier jobs have finished.
  void report(std::size_t k, Result r) {
    // A scene has no file, and its fingerprint takes a second.
    if (options_.change_of) r.fingerprint = jobs_[k].subject->fingerprint();
    const std::lock_guard hold(lock_);
    held_[k].results.push_back(std::move(r));
    if (k == first_unfinished_) pass_on(k);
  }

  void finish(std::size_t k) {
    const std::lock_guard hold(lock_);
    held_[k].finished = true;
    while (first_unfinished_ < held_.size() && held_[first_unfinished_].finished) {
      ++first_unfinished_;
      if (first_unfinished_ < held_.size()) pass_on(first_unfinished_);
    }
  }

  void pass_on(std::size_t k) {
    for (const Result& r : held_[k].results) {
      report_.results.push_back(r);
      on_result_(r);
    }
    held_[k].results.clear();
  }

  /// A job's results that wait for those of earlier jobs.
  struct Held {
    std::vector<Result> results;
    bool finished = false;
  };

  const std::vector<Job>& jobs_;
  const RunOptions& options_;
  const Run& run_;
  Report& report_;
  const OnResult& on_result_;
  std::vector<std::size_t> order_;  ///< of jobs
  std::vector<std::uint64_t>
      whole_before_;                   ///< levels of laws that cannot be divided, in the jobs before each
  std::atomic<std::size_t> next_ = 0;  ///< in order_
  std::mutex lock_;                    ///< for all below, and the report
  std::vector<Held> held_;
  std::size_t first_unfinished_ = 0;
};

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
  JobQueue(jobs, options, run, report, on_result).run(report.threads);

  run.progress = nullptr;
  withdraw_changed(jobs, options, report);
  diagnose(jobs, report);
  if (shard.number == 1 && options.mutants && report.gave_up.empty())
    report.mutants = run_mutants(laws_run(jobs), run);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.interrupted = interrupted();
  return report;
}

}  // namespace mmverify::proofs
