// Common parts of the laws of topic vq: the check of a case, and the cases that it runs on.
#pragma once

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
  CaseCount count;
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
        return fmt::format(
            "a block has 2^level regions along a side, so it is judged at level{} {}{}; leave --levels out",
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

/// The levels of vectors, which have 2^level regions along a side.
inline constexpr Levels both_sides{1, 2};

/// Calls f(std::integral_constant<std::size_t, side>) for a level.  Throws BadCase at other levels.
template <class F>
auto at_side(Level n, F f) {
  if (n == 1) return f(std::integral_constant<std::size_t, 2>());
  if (n == 2) return f(std::integral_constant<std::size_t, 4>());
  throw BadCase(fmt::format("level {}: vectors have 2 or 4 regions along a side, levels 1 and 2", n));
}

inline std::optional<std::string> lacks_vectors(const VqSubject& s) {
  if (!s.functions.of2.valid || !s.functions.composed)
    return s.name() + " has no entry point of vectors: they are the specification's";
  return std::nullopt;
}

}  // namespace mmverify::proofs::vq
