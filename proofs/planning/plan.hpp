// From what was asked on the command line to the jobs that answer it.
#pragma once

#include "proofs/engine/runner.hpp"

namespace mmverify::proofs {

struct Request {
  std::vector<const Law*> laws;      ///< empty: every law
  std::vector<SubjectPtr> subjects;  ///< empty: each law's own
  std::optional<Levels> levels;      ///< none: the tier's
  Tier tier = Tier::fast;
  std::string dialect = "exact";   ///< by which laws about floats are held
  std::vector<std::string> by_id;  ///< of the laws those that were named themselves, not by their topic
  bool companions = true;          ///< whether laws bring theirs along
};

/// The jobs of a request. A law whose cells decide nothing for a float subject brings its companion on floats
/// along, and that one its own.
std::vector<Job> plan(const Request& request);

/// The weaker of two verdicts, in the order of weakest().
Verdict weaker(Verdict a, Verdict b);

/// The weakest of a subject's verdicts, laws that do not apply left out: broken, refuted, incomplete,
/// checked, proved. not_applicable where no law applied.
Verdict weakest(const std::vector<Result>& results, const std::string& subject);

/// The levels of those asked for at which no law judged the subject, nor, where it is empty, any; none where only laws ran
/// that settle many levels at once.  What other shards run is judged.
std::vector<Level> levels_not_judged(const std::vector<Result>& results, const std::string& subject,
                                     const Levels& asked);

/// Subjects that the fast tier judges by a law on other levels than Law::fast, and which.
std::vector<std::pair<std::string, Levels>> fast_levels_apart(const Law& law);

/// The levels that the fast tier judges the subject on: its own, or Law::fast.
Levels fast_levels(const Law& law, const Subject& subject);

}  // namespace mmverify::proofs
