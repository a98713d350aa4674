// The parts of the bench of stiff inputs, a topic each.
#pragma once

#include <random>

#include "bench/rounds.hpp"
#include "bench/stiff/bench.hpp"

namespace mmverify::bench::stiff {

using Random = std::mt19937_64;

/// A number in [0, count).  The remainder favours small numbers by less than count / 2^64.
inline std::uint64_t below(Random& random, std::uint64_t count) { return random() % count; }
inline bool coin(Random& random) { return below(random, 2) != 0; }

/// A stream of its own for each kind, the same on every machine.
inline Random stream(std::uint64_t seed, std::uint32_t kind) {
  std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), kind};
  return Random(words);
}

/// Fills in the times of a method: pass(true) answers `stiff` stiff cases, pass(false) `ordinary` ordinary ones.
template <class Pass>
void add_times(StiffFigure& figure, std::size_t stiff, std::size_t ordinary, std::size_t rounds, Pass pass) {
  const RoundTimes times =
      times_in_rounds({{stiff, [&] { pass(true); }}, {ordinary, [&] { pass(false); }}}, rounds);
  const Spread stiff_ns = spread_of(times[0]);
  figure.ns = stiff_ns.median;
  figure.least_ns = stiff_ns.least;
  figure.most_ns = stiff_ns.most;
  figure.ratio = median_ratio(times[0], times[1]);
}

/// A subnormal number of binary32, of any number of significant bits.
float subnormal(Random& random);

void add_points(const StiffBenchOptions& options, std::vector<StiffFigure>& figures);
void add_triangles(const StiffBenchOptions& options, std::vector<StiffFigure>& figures);
void add_texels(const StiffBenchOptions& options, std::vector<StiffFigure>& figures);
void add_weights(const StiffBenchOptions& options, std::vector<StiffFigure>& figures);

}  // namespace mmverify::bench::stiff
