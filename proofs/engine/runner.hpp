// Runs laws on subjects over levels and reports.
#pragma once

#include "proofs/engine/law.hpp"

namespace mmverify::proofs {

/// One law on one subject over a range of levels.
struct Job {
  const Law* law;
  SubjectPtr subject;
  Levels levels;
  std::string unfit = {};           ///< the reason why the law is not about this subject, if any
  const Law* brought_by = nullptr;  ///< the law whose companion this one is; null for a requested law
};

struct RunOptions {
  unsigned threads = 0;  ///< 0: as many as the machine has
  std::size_t errors = 1;
  std::uint64_t seed = 1;
  Tier tier = Tier::fast;
  std::uint64_t cases = 0;  ///< as in Run
  Options options = {};     ///< each law gets those that it heeds
  std::uint32_t near = 0;   ///< as in Run
  bool show_progress = true;
  std::optional<Shard> shard = {};  ///< none: the whole domain, without a shard's name
  Journal* journal = nullptr;
  bool mutants = true;  ///< run the mutants, which show that each law can fail
  /// Threads take jobs and mutants side by side, the dearest first; else all threads share one job after another, and
  /// take mutants side by side afterwards.
  /// Domain: subjects that this program itself implements; a worker serves one job at a time.
  bool side_by_side = false;
  /// The change of a subject since it was opened, as a sentence; empty if it is the same.  An empty function: no
  /// subject can change.
  std::function<std::string(const Subject&)> change_of = {};
};

/// A law's diagnosis of a subject that it refuted.
struct Diagnosis {
  std::string law, subject;
  std::vector<std::string> lines;
};

/// The time of a task: a law on a subject at all its levels, or on a mutant.
struct Spent {
  const Law* law;
  std::string subject;  ///< or the mutant
  bool mutant;
  double seconds;    ///< from its start to its end
  double processor;  ///< seconds of all threads
  double path;       ///< processor seconds that no further thread shortens
};

struct Report {
  std::vector<Result> results;
  std::vector<Diagnosis> diagnoses;
  std::vector<MutantResult> mutants;
  std::vector<Spent> spent;  ///< tasks that ran, jobs in their order, then mutants in theirs
  unsigned threads = 1;
  double seconds = 0;  ///< from the first job to the last mutant; 0 of shards that were merged
  bool interrupted = false;
  std::string gave_up;  ///< the resource that the machine lacked, if that ended the run
};

/// Called for each result as it arrives.
using OnResult = std::function<void(const Result&)>;

/// Runs the jobs and, if requested, the mutants of all their laws; reports the jobs' results in the jobs' order,
/// whatever runs first.  A shard runs its part of each divisible law, and every `of`-th of the other laws whole; the
/// first shard runs the mutants.  Throws BadJournal.
Report run_jobs(const std::vector<Job>& jobs, const RunOptions& options, const OnResult& on_result);

/// Runs one law on one subject at one level; fills in verdict, counts and reason.  A proof whose cases do not add up
/// to the closed form is an error of this program: std::logic_error.
Result run_level(const Law& law, const Subject& subject, Level level, const Run& run);

/// The result of a law that does not apply, `why`.
Result not_applicable(const Law& law, const Subject& subject, Level level, const Run& run,
                      const std::string& why);

/// The result of a law that ended before its verdict, `why`.
Result cut_short(const Law& law, const Subject& subject, Level level, const Run& run, const std::string& why);

/// Notes in a result the levels that its law settles together, and its method of proof.
void name_proof(Result& result, const Law& law);

/// Runs a mutant, lowest level first, until the law refutes it; nothing if an interrupt came first.  Samples have the
/// default seed and the fast tier's size.  A law that is not divisible may divide its work among the run's threads.
std::optional<MutantResult> run_mutant(const Law& law, const Mutant& mutant, const Run& run);

/// Runs every mutant of a law.
std::vector<MutantResult> run_mutants(const Law& law, const Run& run);

}  // namespace mmverify::proofs
