// A law over numbered cases: the finding of one case, and the law made from the check.
#pragma once

#include "proofs/engine/bytes.hpp"
#include "proofs/engine/law.hpp"

namespace mmverify::proofs {

/// A counterexample's words.
struct Words {
  std::string expected, got;
};

/// The finding of one case: a number for the digest, and the first thing that is wrong.
struct Finding {
  std::uint64_t answer = 0;
  bool holds = true;
  std::string expected = {}, got = {};
  bool declined = false;  ///< the subject does not claim to support the case
  bool broken = false;    ///< it broke instead of answering
  bool allowed = false;   ///< it holds only by an allowance
  bool lesser = false;    ///< a lesser fault, shown after all others
  /// Replaces expected and got; computed only if somebody reads them.
  std::function<Words()> in_words = {};

  Words words() const { return in_words ? in_words() : Words{expected, got}; }
};

inline Finding wrong(std::string expected, std::string got) {
  return {0, false, std::move(expected), std::move(got)};
}

/// The finding in the form of `replay`.
inline Replayed replayed(const Finding& found) {
  if (found.holds) return {true, "ok", "ok", {}};
  const Words words = found.words();
  return {false, words.expected, words.got, {}};
}

/// Counts that fall with the level: up to the level of each step its number, above the last one `beyond`.
inline CaseCount falling(std::vector<std::pair<Level, std::uint64_t>> steps, std::uint64_t beyond) {
  return [steps = std::move(steps), beyond](Level n) {
    for (const auto& [last, count] : steps)
      if (n <= last) return count;
    return beyond;
  };
}

/// Cases by number: their count at a level, the check of a case, its text, and the check of a text.
struct NumberedCases {
  CaseCount count;
  std::function<Finding(const Subject&, Level, std::uint64_t k, const Run&)> check;
  std::function<std::string(const Subject&, Level, std::uint64_t k, const Run&)> text;
  std::function<Finding(const Subject&, Level, const std::string&)> read;  ///< throws BadCase
  std::uint64_t chunk = 256;
  Kind kind;  ///< the kind that all cases count as
  /// A picture (SVG) of a case, for a subject at a level; an empty text means none.
  std::function<std::string(const Subject&, Level, const std::string&)> draw = {};
};

/// The law in one sweep over its cases: sets cases, judge and replay, and `how` if it is missing.
Law on_numbered_cases(Law law, const NumberedCases& cases);

/// Only the sweep, for a law that prepares something first.
Tally judge_numbered_cases(const NumberedCases& cases, const Subject& subject, Level n, const Run& run);

}  // namespace mmverify::proofs
