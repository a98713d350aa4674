// A law case by case: what a check finds of one case, and the law over the numbers of all.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "proofs/engine/bytes.hpp"
#include "proofs/engine/law.hpp"

namespace mmverify::proofs {

/// A counterexample's words.
struct Words {
  std::string expected, got;
};

/// What a check of one case found: a number for the digest, and what was wrong first.
struct Finding {
  std::uint64_t answer = 0;
  bool holds = true;
  std::string expected = {}, got = {};
  bool declined = false;  ///< the subject does not claim to support the case
  bool broken = false;    ///< it did something else than answer
  bool allowed = false;   ///< it holds by an allowance alone
  bool lesser = false;    ///< what is wrong is less than what may be: shown after all that is not
  /// In the place of expected and got: worked out only where somebody reads it.
  std::function<Words()> in_words = {};

  Words words() const { return in_words ? in_words() : Words{expected, got}; }
};

inline Finding wrong(std::string expected, std::string got) {
  return {0, false, std::move(expected), std::move(got)};
}

/// A finding, for `replay`.
inline Replayed replayed(const Finding& found) {
  if (found.holds) return {true, "ok", "ok", {}};
  const Words words = found.words();
  return {false, words.expected, words.got, {}};
}

/// Cases by number: how many at a level, the check of one, the text that names it, and the check of a text.
struct NumberedCases {
  std::function<std::uint64_t(Level, const Run&)> count;
  std::function<Finding(const Subject&, Level, std::uint64_t k, const Run&)> check;
  std::function<std::string(const Subject&, Level, std::uint64_t k, const Run&)> text;
  std::function<Finding(const Subject&, Level, const std::string&)> read;  ///< throws BadCase
  std::uint64_t chunk = 256;
  Kind kind;  ///< that all are counted by
  /// Of a subject at a level, where a case is drawn: an SVG; empty: none.
  std::function<std::string(const Subject&, Level, const std::string&)> draw = {};
};

/// The law, case by case, in one sweep: its cases, judge and replay; `how` where it has none.
Law on_numbered_cases(Law law, const NumberedCases& cases);

/// The sweep of it alone, for a law that makes something ready first.
Tally judge_numbered_cases(const NumberedCases& cases, const Subject& subject, Level n, const Run& run);

}  // namespace mmverify::proofs
