// The tasks of a run, taken by one thread after another or by several side by side.
#pragma once

#include <atomic>
#include <mutex>

#include "proofs/engine/runner.hpp"

namespace mmverify::proofs {

/// The reason why the job has no level to run; empty if it has one.
std::string unfit_throughout(const Job& job);

/// A mutant of a law that some job runs.
struct MutantTask {
  const Law* law;
  const Mutant* mutant;
};

/// Jobs and mutants.  Threads that find no further task help with the sweeps of the others.
class TaskQueue {
 public:
  /// Domain: the run has an arena; all references outlive the queue.
  TaskQueue(const std::vector<Job>& jobs, const std::vector<MutantTask>& mutants, const RunOptions& options,
            const Run& run, Report& report, const OnResult& on_result);

  /// Runs all tasks on so many threads.  The report gets results and mutants in their order, and the tasks' times.
  void run(unsigned threads);

 private:
  const Law& law_of(std::size_t task) const;
  void put_dearest_first();
  void take_side_by_side(std::size_t end, unsigned threads);
  void take_until(std::size_t end);
  void run_task(std::size_t task);
  void run_job(std::size_t k);
  void run_mutant_task(std::size_t m);
  Result run_at(const Job& job, Level n, Run& run, std::uint64_t whole_law);
  void give_up(const std::string& why);
  bool gave_up();
  /// Reports a result of job k, at once if all earlier jobs have finished.
  void report(std::size_t k, Result r);
  void finish(std::size_t k);
  void pass_on(std::size_t k);

  /// A job's results that wait for those of earlier jobs.
  struct Held {
    std::vector<Result> results;
    bool finished = false;
  };

  const std::vector<Job>& jobs_;
  const std::vector<MutantTask>& mutants_;
  const RunOptions& options_;
  const Run& run_;
  Report& report_;
  const OnResult& on_result_;
  std::vector<std::uint64_t>
      whole_before_;                   ///< levels of laws that cannot be divided, in the jobs before each
  std::vector<std::size_t> order_;     ///< of tasks: jobs by their number, then mutants
  std::atomic<std::size_t> next_ = 0;  ///< in order_
  std::vector<std::optional<Spent>> spent_;           ///< by task; a thread writes those of its tasks
  std::vector<std::optional<MutantResult>> mutated_;  ///< by mutant, likewise
  std::mutex lock_;                                   ///< for all below, and the report
  std::vector<Held> held_;
  std::size_t first_unfinished_ = 0;
};

}  // namespace mmverify::proofs
