// How many micro-triangles of a level a law of baking looks at: all where that is little work, else a sample.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "proofs/scene/claim.hpp"
#include "proofs/scene/subject.hpp"

namespace mmverify::proofs::scene {

/// A law judges a whole level from nodes of 4^piece micro-triangles down.
inline constexpr Level piece = 4;

/// The micro-triangles that a law looks at: a number, as many of each level that occurs; or those that some work
/// allows; all if neither is given.  The unit of work is the exact state of a micro-triangle of few texels.
struct BakeSample {
  std::optional<std::uint64_t> size = {};
  std::optional<std::uint64_t> work = {};
  std::uint64_t whole =
      0;  ///< beside `work`: all micro-triangles if they take no more than this; see work_of_a_minute
};

/// The work below which all of a file's maps are looked at: less than a minute on two cores.  Where vertex alpha varies,
/// each state counts as many, as it takes rationals.
inline constexpr std::uint64_t states_of_rationals = 16, work_of_a_minute = states_of_rationals * 4'000'000;

/// The work that takes about as long as loading and baking do, by the texels and micro-triangles that these read.
/// The same on every machine.
std::uint64_t usual_work(const Data& data);
/// The work that a machine does in so many seconds on `threads` threads, by the time that some exact states take.
/// Domain: seconds > 0; threads 0: as many as the machine has.
std::uint64_t work_of_seconds(const Data& data, double seconds, unsigned threads);

/// The number of micro-triangles of a level that a claim is about, and of those that the law looks at.
struct Looked {
  std::uint64_t all = 0, at = 0;
  bool whole() const { return at == all; }
};
using LookedByLevel = std::array<Looked, 13>;
LookedByLevel looked_at(const Claim& claim, const Data& data, const BakeSample& sample);

}  // namespace mmverify::proofs::scene
