// Common parts of the laws of topic vq: the check of a case, and the cases that it runs on.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>

#include "proofs/engine/cases.hpp"
#include "proofs/engine/kinds.hpp"
#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// The levels of a law about one format: the format's level.
template <class Format>
constexpr Levels level_alone{level_of<Format>, level_of<Format>};

/// Throws BadCase unless the level is the format's.
template <class Format>
void check_level(Level n) {
  if (n != level_of<Format>) throw BadCase(fmt::format("level {}: this law's is {}", n, level_of<Format>));
}

/// Cases by number, as DrawnCasesOf has them; a text and a check need no level.
template <class Case>
struct Cases {
  std::function<std::uint64_t(Level, const Run&)> count;
  std::function<Case(Level, std::uint64_t k, std::uint64_t seed)> number;
  std::function<std::string(const Case&)> text;
  std::function<Case(Level, const std::string&)> read;
  std::function<Finding(const VqSubject&, const Case&)> check;
  std::uint64_t chunk = 16;
};

/// The reason why a subject does not fit, if any.
using Lacks = std::function<std::optional<std::string>(const VqSubject&)>;

/// The law on numbered cases.  Its levels are those of `fast`, in the long tier as well.
template <class Case>
Law on_cases(Law law, Lacks lacks, Cases<Case> cases) {
  law.tiers.long_run = law.tiers.fast;
  law.unfit = unless_of_topic<VqSubject>(
      [lacks, levels = law.tiers.fast](const VqSubject& s, Level n) -> std::optional<std::string> {
        if (n >= levels.first && n <= levels.last) return lacks(s);
        return fmt::format("2^level regions lie along a side: it is about level{} {}{}",
                           levels.first == levels.last ? "" : "s", levels.first,
                           levels.first == levels.last ? "" : fmt::format("..{}", levels.last));
      });
  return on_drawn_cases<VqSubject, Case>(
      std::move(law),
      {std::move(cases.count), std::move(cases.number),
       [text = std::move(cases.text)](Level, const Case& one) { return text(one); }, std::move(cases.read),
       [check = std::move(cases.check)](const VqSubject& s, Level, const Case& one) { return check(s, one); },
       cases.chunk});
}

}  // namespace mmverify::proofs::vq
