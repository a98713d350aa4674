// What a run says: verdicts, counts, counterexamples.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/share.hpp"

namespace mmverify::proofs {

using Level = std::uint32_t;

/// proved: every case of the named domain was run, a witness settles the statement, or a prover discharged
/// every statement that it follows from.  checked: a sample passed.
enum class Verdict { proved, refuted, checked, broken, not_applicable, incomplete };

std::string to_string(Verdict v);

/// What cases are counted by: numbers below `kinds`, whose names are the topics' (proofs/engine/kinds.hpp).
enum class Kind : std::uint8_t;
constexpr std::size_t kinds = 3;

/// Cases judged, those of them that were wrong, those that the subject does not claim to support, those whose answer
/// passed by what the run allows beside exact arithmetic (the published code's, or a near neighbour's), and those that
/// nobody judged, since the subject broke on them or on a case that they are compared with.
struct Count {
  std::uint64_t cases = 0, mismatches = 0, declined = 0, allowed = 0, unjudged = 0;
  friend bool operator==(const Count&, const Count&) = default;
};
using CountByKind = std::array<Count, kinds>;

/// Order of counterexamples: the simplest first. For points: log2 of the common denominator, then v, then u.
using Simplicity = std::array<std::uint64_t, 3>;

/// One input on which a law fails.  `at` is the text that `replay --case` takes back.
struct Counterexample {
  Simplicity simplicity{};
  Level level = 0;
  std::string at;
  std::string hex;  ///< the point as hexadecimal floats, empty where the input is not a point
  std::string expected, got;
};

/// One law on one subject at one level, or on all those that at_once names.
struct Result {
  std::string law, topic, subject;
  Level level = 0;
  std::string at_once;  ///< "all levels": what the result is about in the place of a level; mostly empty
  std::string proof;    ///< "induction": how, beside the verdict `proved`; empty where every case was run
  std::string method, domain;
  std::string fingerprint;  ///< the subject's; empty where the program itself is the subject
  std::string
      dialect;  ///< "exact", "published" or "either": what answers on floats are held to; mostly empty
  std::string replayed_by;  ///< as the law's
  Verdict verdict = Verdict::incomplete;
  std::string reason;               ///< why broken, not applicable or incomplete
  std::vector<std::string> breaks;  ///< what the subject did on cases that it did not answer, in their order
  std::uint64_t cases_expected = 0;
  CountByKind by_kind{};
  std::vector<Counterexample> counterexamples;  ///< the simplest first, at most --errors of them
  std::uint64_t digest = 0;
  double seconds = 0;            ///< of this run
  std::uint64_t resumed = 0;     ///< cases that an earlier run had done, by the journal
  std::optional<Share> share{};  ///< what a shard did of the domain; none: all of it

  std::uint64_t cases_run() const;
  std::uint64_t mismatches() const;
  std::uint64_t declined() const;  ///< of cases_run()
  std::uint64_t allowed() const;   ///< of cases_run()
};

/// The verdict on a domain all of whose cases were run, and its reason: refuted where one was wrong;
/// not_applicable where there is none or the subject declined more than half; checked where it declined some, where some were allowed, or
/// where they are a sample; else proved.
void settle(Result& result, bool sample);

/// Whether a law can fail: one wrong subject that it must refute.
struct MutantResult {
  std::string law, mutant;
  bool killed = false;
  Level level = 0;
  std::string at;
};

}  // namespace mmverify::proofs
