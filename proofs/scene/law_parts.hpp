// What the laws on a scene's parts are put together from: so many parts a level, and how one is judged.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs::scene {

/// What was found of one part; `expected` empty: it holds.
struct Finding {
  std::uint64_t answer = 0;  ///< for the digest
  std::string expected = {}, got = {};
};

/// A law on all parts of a level: `parts` says how many, `what` names them, `check` judges one.
struct Parts {
  std::string what;
  std::function<std::uint64_t(Level)> count;
  std::function<Finding(Level, std::uint64_t)> check;
};

inline Law over(Law law, Parts parts) {
  law.method = Method::exhaustive;
  law.divisible = true;
  law.on_lines = false;
  law.cases = [parts](Level n, const Run&) { return parts.count(n); };
  law.how = [](const Subject&, Level) { return std::string("exhaustive"); };
  law.domain = [parts](const Subject&, Level n) {
    return fmt::format("the {} {} of level {} of this scene", parts.count(n), parts.what, n);
  };
  law.unfit = [parts](const Subject&, Level n) -> std::optional<std::string> {
    if (parts.count(n) != 0) return std::nullopt;
    return fmt::format("no {}", parts.what);
  };
  law.judge = [parts](const Subject&, Level n, const Run& run) {
    return sweep(run, parts.count(n), 1, [&](Chunk chunk, Tally& tally) {
      for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
        const Finding found = parts.check(n, k);
        tally.count(Kind::interior, 1);
        tally.digest(k, found.answer);
        if (!found.expected.empty())
          tally.mismatch(Kind::interior, {n, k, 0}, [&] {
            return Counterexample{{n, k, 0}, n, fmt::format("{}", k), {}, found.expected, found.got};
          });
      }
    });
  };
  law.replay = [parts](const Subject&, Level n, const std::string& at) {
    std::uint64_t k = 0;
    if (std::sscanf(at.c_str(), "%lu", &k) != 1 || fmt::format("{}", k) != at || k >= parts.count(n))
      throw BadCase(fmt::format("{}: not one of the {} {}", at, parts.count(n), parts.what));
    const Finding found = parts.check(n, k);
    return found.expected.empty() ? Replayed{true, "ok", "ok", {}}
                                  : Replayed{false, found.expected, found.got, {}};
  };
  return law;
}

/// FNV-1a, for digests.
template <class Bytes>
std::uint64_t hash_of(const Bytes& bytes) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const auto byte : bytes) hash = (hash ^ static_cast<std::uint8_t>(byte)) * 0x100000001B3u;
  return hash;
}

}  // namespace mmverify::proofs::scene
