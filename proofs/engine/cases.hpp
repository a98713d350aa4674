// A law case by case: what a check finds of one case, and the sweep over the numbers of all.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "proofs/engine/law.hpp"

namespace mmverify::proofs {

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
/// Source: FNV-1a, 64 bits.
template <class Bytes>
std::uint64_t hash_of(const Bytes& bytes) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const auto byte : bytes) hash = (hash ^ static_cast<std::uint8_t>(byte)) * 0x100000001B3u;
  return hash;
}

/// Judges the cases 0 .. count-1 of a level: check(k) -> Finding, text(k) -> what names the case.
template <class Check, class Text>
Tally each_case(const Run& run, Level n, std::uint64_t count, std::uint64_t chunk_size, const Check& check,
                const Text& text) {
  return sweep(run, count, chunk_size, [&](Chunk chunk, Tally& tally) {
    for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
      const Finding found = check(k);
      tally.count(Kind::interior, 1);
      tally.digest(k, found.answer);
      if (!found.holds)
        tally.mismatch(Kind::interior, {n, k, 0}, [&] {
          return Counterexample{{n, k, 0}, n, text(k), {}, found.expected, found.got};
        });
    }
  });
}

/// A finding, for `replay`.
inline Replayed replayed(const Finding& found) {
  return found.holds ? Replayed{true, "ok", "ok", {}} : Replayed{false, found.expected, found.got, {}};
}

}  // namespace mmverify::proofs
