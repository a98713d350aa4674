// What the laws of topic vq are put together from: a check of one case, and the cases that it is run on.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>

#include "proofs/vq/subject.hpp"

namespace mmverify::proofs::vq {

/// What a check of one case found: a number for the digest, and what was wrong first.
struct Finding {
  std::uint64_t answer = 0;
  bool holds = true;
  std::string expected = {}, got = {};
};

inline Finding wrong(std::string expected, std::string got) {
  return {0, false, std::move(expected), std::move(got)};
}

/// Order-dependent hash of bytes or states, for digests.
template <class Array>
std::uint64_t hash_of(const Array& values) {
  std::uint64_t hash = 0xCBF29CE484222325u;  // FNV-1a
  for (const auto value : values) hash = (hash ^ static_cast<std::uint8_t>(value)) * 0x100000001B3u;
  return hash;
}

/// Of a law about one format.
template <class Format>
constexpr Levels level_alone{level_of<Format>, level_of<Format>};

/// Throws BadCase at another level than the format's.
template <class Format>
void check_level(Level n) {
  if (n != level_of<Format>) throw BadCase(fmt::format("level {}: this law's is {}", n, level_of<Format>));
}

/// Cases by number: how many, which, the text of one, the case of a text (or BadCase), and how one is judged.
template <class Case>
struct Cases {
  std::function<std::uint64_t(Level, const Run&)> count;
  std::function<Case(Level, std::uint64_t k, std::uint64_t seed)> number;
  std::function<std::string(const Case&)> text;
  std::function<Case(Level, const std::string&)> read;
  std::function<Finding(const VqSubject&, const Case&)> check;
  std::uint64_t chunk = 16;
};

/// Why a subject does not fit, if so.
using Lacks = std::function<std::optional<std::string>(const VqSubject&)>;

/// The law, case by case.  Its levels are those of `fast`, in the long tier as well.
template <class Case>
Law over(Law law, Lacks lacks, Cases<Case> cases) {
  law.topic = "vq";
  law.divisible = true;
  law.on_lines = false;
  law.long_run = law.fast;
  const auto of_vq = [](const Subject& s) -> const VqSubject& { return dynamic_cast<const VqSubject&>(s); };
  if (!law.how)
    law.how = [method = law.method](const Subject&, Level) { return std::string(to_string(method)); };
  law.unfit = [lacks, levels = law.fast](const Subject& s, Level n) -> std::optional<std::string> {
    const auto* subject = dynamic_cast<const VqSubject*>(&s);
    if (subject == nullptr) return "not a subject of topic vq";
    if (n < levels.first || n > levels.last)
      return fmt::format("2^level regions lie along a side: it is about level{} {}{}",
                         levels.first == levels.last ? "" : "s", levels.first,
                         levels.first == levels.last ? "" : fmt::format("..{}", levels.last));
    return lacks(*subject);
  };
  law.cases = cases.count;
  law.judge = [cases, of_vq](const Subject& s, Level n, const Run& run) {
    return sweep(run, cases.count(n, run), cases.chunk, [&](Chunk chunk, Tally& tally) {
      for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
        const Case one = cases.number(n, k, run.seed);
        const Finding found = cases.check(of_vq(s), one);
        tally.count(Kind::interior, 1);
        tally.digest(k, found.answer);
        if (!found.holds)
          tally.mismatch(Kind::interior, {n, k, 0}, [&] {
            return Counterexample{{n, k, 0}, n, cases.text(one), {}, found.expected, found.got};
          });
      }
    });
  };
  law.replay = [cases, of_vq](const Subject& s, Level n, const std::string& at) {
    const Finding found = cases.check(of_vq(s), cases.read(n, at));
    return found.holds ? Replayed{true, "ok", "ok", {}} : Replayed{false, found.expected, found.got, {}};
  };
  return law;
}

}  // namespace mmverify::proofs::vq
