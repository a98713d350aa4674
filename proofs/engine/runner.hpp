// Runs laws on subjects over levels and reports.
#pragma once

#include <functional>
#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs {

/// One law on one subject over a range of levels.
struct Job {
  const Law* law;
  SubjectPtr subject;
  Levels levels;
  std::string unfit = {};           ///< why the law is not about this subject, if so
  const Law* brought_by = nullptr;  ///< the law whose companion this one is; null where it was asked for
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
  std::optional<Shard> shard = {};  ///< none: the whole domain, not called a shard
  Journal* journal = nullptr;
  bool mutants = true;  ///< show that each law can fail
  /// What a subject has become since it was opened, in a sentence; empty where it is the same.  Empty: none changes.
  std::function<std::string(const Subject&)> change_of = {};
};

/// What a law has to say about a subject that it refuted.
struct Diagnosis {
  std::string law, subject;
  std::vector<std::string> lines;
};

struct Report {
  std::vector<Result> results;
  std::vector<Diagnosis> diagnoses;
  std::vector<MutantResult> mutants;
  unsigned threads = 1;
  bool interrupted = false;
  std::string gave_up;  ///< what the machine had no room for, where that ended the run
};

/// Called as each result comes in.
using OnResult = std::function<void(const Result&)>;

/// Runs the jobs in order, then, where asked, the mutants of every law among them.  A shard runs its part of
/// each law that is divisible, every so many of the others whole, and the mutants where it is the first.
/// Throws BadJournal.
Report run_jobs(const std::vector<Job>& jobs, const RunOptions& options, const OnResult& on_result);

/// One law on one subject at one level; verdict, counts and reason filled in.
/// A proof whose cases do not add up to the closed form is an error of this program: std::logic_error.
Result run_level(const Law& law, const Subject& subject, Level level, const Run& run);

/// Says in a result what its law is about in the place of a level, and how it is proved.
void name_proof(Result& result, const Law& law);

/// Runs every mutant of a law, lowest level first, until the law refutes it.  Samples are those of the
/// default seed and the fast tier.
std::vector<MutantResult> run_mutants(const Law& law, const Run& run);

/// The same of several laws, side by side where the run has an arena; the results in the laws' order.
std::vector<MutantResult> run_mutants(const std::vector<const Law*>& laws, const Run& run);

}  // namespace mmverify::proofs
