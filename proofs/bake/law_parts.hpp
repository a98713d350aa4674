// What the laws of topic bake are put together from: a check of one case, and the cases that it is run on.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>

#include "proofs/bake/subject.hpp"
#include "proofs/engine/cases.hpp"

namespace mmverify::proofs::bake {

inline Finding wrong(std::function<Words()> in_words) {
  Finding finding{.holds = false};
  finding.in_words = std::move(in_words);
  return finding;
}
using proofs::wrong;

/// The subject does not support the case.
inline Finding unsupported() { return {.declined = true}; }

/// What a law ranges over.  `number` gives case k of the level, for one subject what that declares; a family knows
/// its case's number, and its check may ask for the truth by it.
struct Cases {
  std::function<std::uint64_t(Level, const Run&)> count;
  std::function<Case(const Support&, Level, std::uint64_t k, std::uint64_t seed)> number;
  std::uint64_t chunk = 16;
};

/// Judges a case; `number` says which of the law's it is, none where it was read from a text.
using Check = std::function<Finding(const BakeSubject&, const Case&, Level,
                                    const std::optional<std::uint64_t>& number)>;
/// Draws it.
using Draw = std::function<std::string(const BakeSubject&, const Case&, Level)>;

/// Why a law does not fit a subject, if so.
using Lacks = std::function<std::optional<std::string>(const BakeSubject&, Level)>;

/// The law, case by case.  Its levels are those of `fast`, unless `long_run` is said.
Law on_cases(Law law, const Cases& cases, const Check& check, const Draw& draw = {}, const Lacks& lacks = {});

}  // namespace mmverify::proofs::bake
