#include "proofs/engine/task_queue.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>

#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/journal.hpp"
#include "proofs/engine/processor_time.hpp"

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

double seconds_of(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

}  // namespace

/// The reason why the job has no level to run; empty if it has one.
std::string unfit_throughout(const Job& job) {
  std::string why = job.unfit;
  for (Level n = job.levels.first; why.empty() && n <= job.levels.last; ++n)
    if (!job.law->unfit(*job.subject, n)) return {};
  return why.empty() ? job.law->unfit(*job.subject, job.levels.first).value_or("no level") : why;
}

TaskQueue::TaskQueue(const std::vector<Job>& jobs, const std::vector<MutantTask>& mutants,
                     const RunOptions& options, const Run& run, Report& report, const OnResult& on_result)
    : jobs_(jobs),
      mutants_(mutants),
      options_(options),
      run_(run),
      report_(report),
      on_result_(on_result),
      order_(jobs.size() + mutants.size()),
      spent_(order_.size()),
      mutated_(mutants.size()),
      held_(jobs.size()) {
  std::uint64_t levels = 0;
  for (const Job& job : jobs) {
    whole_before_.push_back(levels);
    if (!job.law->divisible && unfit_throughout(job).empty())
      levels += job.levels.last - job.levels.first + 1;
  }
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (options.side_by_side) put_dearest_first();
}

void TaskQueue::run(unsigned threads) {
  if (!options_.side_by_side) take_until(jobs_.size());
  take_side_by_side(order_.size(), threads);
  // Jobs that did not begin, for want of a resource, leave results of later ones waiting.
  for (std::size_t k = first_unfinished_; k < jobs_.size(); ++k) pass_on(k);
  for (const auto& m : mutated_)
    if (m) report_.mutants.push_back(*m);
  for (const auto& spent : spent_)
    if (spent) report_.spent.push_back(*spent);
}

const Law& TaskQueue::law_of(std::size_t task) const {
  return task < jobs_.size() ? *jobs_[task].law : *mutants_[task - jobs_.size()].law;
}

/// A law's seconds are those of its jobs and mutants together.
void TaskQueue::put_dearest_first() {
  constexpr double of_mutant = 0.25;  // of a job's time: it ends with its first refuted case
  const auto share = [&](std::size_t task) { return task < jobs_.size() ? 1 : of_mutant; };
  std::map<const Law*, double> shares;
  for (const std::size_t task : order_) shares[&law_of(task)] += share(task);
  const auto seconds = [&](std::size_t task) {
    return law_of(task).tiers.seconds * share(task) / shares[&law_of(task)];
  };
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return seconds(a) > seconds(b); });
}

void TaskQueue::take_side_by_side(std::size_t end, unsigned threads) {
  run_.arena->execute([&] {
    oneapi::tbb::parallel_for(
        0u, threads, [&](unsigned) { take_until(end); }, oneapi::tbb::simple_partitioner());
  });
}

void TaskQueue::take_until(std::size_t end) {
  while (!gave_up()) {
    std::size_t next = next_;
    while (next < end && !next_.compare_exchange_weak(next, next + 1)) continue;
    if (next >= end) return;
    // A thread that waits within a law must not begin another one: the first may have a lock.
    oneapi::tbb::this_task_arena::isolate([&] { run_task(order_[next]); });
  }
}

void TaskQueue::run_task(std::size_t task) {
  if (task < jobs_.size() && !jobs_[task].unfit.empty()) return run_job(task);
  ProcessorTime time;
  const auto start = std::chrono::steady_clock::now();
  {
    const Counting counting(&time, true);
    if (task < jobs_.size())
      run_job(task);
    else
      run_mutant_task(task - jobs_.size());
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const bool mutant = task >= jobs_.size();
  spent_[task] = {&law_of(task),
                  mutant ? mutants_[task - jobs_.size()].mutant->name : jobs_[task].subject->name(),
                  mutant,
                  seconds.count(),
                  seconds_of(time.spent),
                  seconds_of(time.path)};
}

void TaskQueue::run_mutant_task(std::size_t m) {
  Run run = run_;
  run.progress = nullptr;  // which counts the cases of jobs
  try {
    mutated_[m] = run_mutant(*mutants_[m].law, *mutants_[m].mutant, run);
  } catch (const NoResources& why) {
    give_up(why.what());
  }
}

void TaskQueue::run_job(std::size_t k) {
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

Result TaskQueue::run_at(const Job& job, Level n, Run& run, std::uint64_t whole_law) {
  const Shard shard = options_.shard.value_or(Shard{});
  Division division{options_.shard, options_.journal, about(job, n), {}, 0, false};
  run.division = options_.journal != nullptr || options_.shard ? &division : nullptr;
  try {
    const bool elsewhere = !job.law->divisible && whole_law % shard.of != shard.number - 1;
    return elsewhere ? of_another_shard(*job.law, *job.subject, n, run)
                     : run_level(*job.law, *job.subject, n, run);
  } catch (const NoResources& why) {
    // This shows nothing about the subject; earlier results stand.
    give_up(why.what());
    return cut_short(*job.law, *job.subject, n, run, why.what());
  }
}

void TaskQueue::give_up(const std::string& why) {
  const std::lock_guard hold(lock_);
  if (report_.gave_up.empty()) report_.gave_up = why;
}

bool TaskQueue::gave_up() {
  const std::lock_guard hold(lock_);
  return !report_.gave_up.empty();
}

void TaskQueue::report(std::size_t k, Result r) {
  // A scene has no file, and its fingerprint takes a second.
  if (options_.change_of) r.fingerprint = jobs_[k].subject->fingerprint();
  const std::lock_guard hold(lock_);
  held_[k].results.push_back(std::move(r));
  if (k == first_unfinished_) pass_on(k);
}

void TaskQueue::finish(std::size_t k) {
  const std::lock_guard hold(lock_);
  held_[k].finished = true;
  while (first_unfinished_ < held_.size() && held_[first_unfinished_].finished) {
    ++first_unfinished_;
    if (first_unfinished_ < held_.size()) pass_on(first_unfinished_);
  }
}

void TaskQueue::pass_on(std::size_t k) {
  for (const Result& r : held_[k].results) {
    report_.results.push_back(r);
    on_result_(r);
  }
  held_[k].results.clear();
}

}  // namespace mmverify::proofs
