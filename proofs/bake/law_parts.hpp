// Common parts of the laws of topic bake: the check of a case, and the cases that it runs on.
#pragma once

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

inline Finding wrong(std::function<Words()> in_words) {
  Finding finding{.holds = false};
  finding.in_words = std::move(in_words);
  return finding;
}
using proofs::wrong;

/// The finding for a case that the subject does not support.
inline Finding unsupported() { return {.declined = true}; }

/// The cases of a law.  `number` gives case k of the level, fitted to what the subject declares.  A family knows its
/// case's number, by which its check can look up the true states.
struct Cases {
  CaseCount count;
  std::function<Case(const Support&, Level, std::uint64_t k, std::uint64_t seed)> number;
  std::uint64_t chunk = 16;
};

/// Judges a case; `number` is its number in the law, or nothing for a case read from text.
using Check = std::function<Finding(const BakeSubject&, const Case&, Level,
                                    const std::optional<std::uint64_t>& number)>;
/// Draws a case as a picture.
using Draw = std::function<std::string(const BakeSubject&, const Case&, Level)>;

/// The reason why a law does not fit a subject, if any.
using Lacks = std::function<std::optional<std::string>(const BakeSubject&, Level)>;

/// The law on numbered cases.  Its levels are those of `fast`, unless it has `long_run`.
Law on_cases(Law law, const Cases& cases, const Check& check, const Draw& draw = {}, const Lacks& lacks = {});

}  // namespace mmverify::proofs::bake
