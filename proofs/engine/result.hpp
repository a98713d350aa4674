// The results of a run: verdicts, counts, counterexamples.
#pragma once

#include <array>
#include <vector>

#include "proofs/engine/share.hpp"

namespace mmverify::proofs {

using Level = std::uint32_t;

/// proved: every case of the named domain was run, a witness settles the statement, or a prover discharged every
/// statement that it follows from.  checked: a sample passed.
enum class Verdict { proved, refuted, checked, broken, not_applicable, incomplete };

std::string to_string(Verdict v);

/// The kind that a case counts as: a number below `kinds`, named by its topic (proofs/engine/kinds.hpp).
enum class Kind : std::uint8_t;
constexpr std::size_t kinds = 3;

/// Counts of cases.  mismatches: wrong.  declined: not supported by the subject.  allowed: right only by an allowance
/// beside exact arithmetic (the published code's answer, or a near neighbour's).  unjudged: the subject broke on the
/// case, or on a case that it is compared with.
struct Count {
  std::uint64_t cases = 0, mismatches = 0, declined = 0, allowed = 0, unjudged = 0;
  friend bool operator==(const Count&, const Count&) = default;
};
using CountByKind = std::array<Count, kinds>;

/// The order of counterexamples: the simplest first.  For points: log2 of the common denominator, then v, then u.
using Simplicity = std::array<std::uint64_t, 3>;

/// One input that a law fails on.  `replay --case` reads the text `at`.
struct Counterexample {
  Simplicity simplicity{};
  Level level = 0;
  std::string at;
  std::string hex;  ///< the point as hexadecimal floats; empty if the input is not a point
  std::string expected, got;
};

/// One law on one subject at one level, or at all levels that at_once names.
struct Result {
  std::string law, topic, subject;
  Level level = 0;
  std::string at_once;  ///< "all levels": the range of levels instead of `level`; mostly empty
  std::string proof;    ///< "induction": the method, beside the verdict `proved`; empty if every case was run
  std::string method, domain;
  std::string fingerprint;  ///< the subject's; empty if the program itself is the subject
  std::string
      dialect;  ///< "exact", "published" or "either": the rule that answers on floats follow; mostly empty
  std::string replayed_by;  ///< as the law's
  /// The declined cases, if it is not the subject that declines them: "whose vertex alpha varies, ..."
  std::string undecided;
  Verdict verdict = Verdict::incomplete;
  std::string reason;               ///< why broken, not applicable or incomplete
  std::vector<std::string> breaks;  ///< the subject's failures on cases that it did not answer, in order
  std::uint64_t cases_expected = 0;
  CountByKind by_kind{};
  std::vector<Counterexample> counterexamples;  ///< the simplest first, at most --errors of them
  std::uint64_t digest = 0;
  double seconds = 0;            ///< of this run
  std::uint64_t resumed = 0;     ///< cases that an earlier run has finished, by the journal
  std::optional<Share> share{};  ///< the part of the domain that a shard ran; none: all of it

  std::uint64_t cases_run() const;
  std::uint64_t mismatches() const;
  std::uint64_t declined() const;  ///< of cases_run()
  std::uint64_t allowed() const;   ///< of cases_run()
};

/// Sets the verdict on a domain all of whose cases were run, and its reason.  refuted: some case was wrong.
/// not_applicable: there are no cases, or the subject declined more than half.  checked: it declined some, some were
/// allowed, or the cases are a sample.  proved: else.
void settle(Result& result, bool sample);

/// The proof that a law can fail: one mutant that it must refute.
struct MutantResult {
  std::string law, mutant;
  bool killed = false;
  Level level = 0;
  std::string at;
};

}  // namespace mmverify::proofs
