// Error against run time of the index functions: how often and how far they are wrong, from which level on,
// and the cost of an index.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/growth.hpp"
#include "bench/index/inputs.hpp"

namespace mmverify::bench {

struct IndexBenchOptions {
  std::uint64_t samples =
      1'000'000;           ///< points a level and kind of inputs; rationals take a 256th; at least 1
  std::uint64_t seed = 1;  ///< of the points
  std::uint32_t first = 1, last = 16;  ///< levels, both included; last at most 16
  std::size_t rounds = 11;             ///< of the timing; 0 counts as 1
  /// Receives the number of further points judged, from any thread.
  std::function<void(std::uint64_t)> progress = {};
};

/// The errors on the points of one level.
struct IndexErrors {
  std::uint32_t level = 0;
  std::uint64_t samples = 0;
  std::uint64_t mismatches = 0;  ///< the index, or its micro-triangle, is not the specification's
  std::uint64_t off_grid = 0;    ///< mismatches that name a micro-triangle that does not exist
  std::array<std::uint64_t, stiff_recipes>
      by_kind{};                            ///< mismatches by StiffRecipe; zeros for uniform points
  double worst_heights = 0, worst_ulp = 0;  ///< over all mismatches on the grid; see distance()

  double rate() const { return static_cast<double>(mismatches) / static_cast<double>(samples); }
};

/// A time of one level; see add_index_times.
struct IndexTime {
  std::uint32_t level = 0;
  double ns_per_index = 0;           ///< processor time, median over the rounds
  double least_ns = 0, most_ns = 0;  ///< of the fastest and the slowest round
  /// Median over the rounds of ns / reference-f32's ns at this level in the same round; below 1 is faster.
  double ratio_to_reference_f32 = 0;
};

/// The figures of one subject.
struct IndexFigures {
  std::string name;
  std::string numbers;  ///< its number type
  std::string order;    ///< "curve" or "rows"
  std::uint32_t max_level = 16;
  std::vector<IndexErrors> uniform, stiff;  ///< by level, up to max_level
  std::vector<IndexTime> times;             ///< by level; empty until add_index_times
  Growth uniform_rate, stiff_rate;          ///< the laws of the mismatch rate
  Growth stiff_heights;                     ///< the law of the worst distance in heights on stiff points
};

/// Judges each subject against the exact specification on the very numbers that it received: points are made
/// in its number type (rationals receive binary32 numbers), and the specification runs on them exactly.
///   reference, step  in binary16 (to level 15), binary32, binary64, 64-bit fixed point and rationals
///   impl             one at a time and in batches, binary32
///   w-minor          row order in binary32; with a binary32 root for the way back (-sqrt); impl's
/// Fits leave out levels with fewer than 10 mismatches, which are noise.  The fit of the rate on uniform
/// points also leaves out rates above a quarter, which have no room to double.
/// The same for the same options on any number of threads, on any machine with IEEE arithmetic.
/// Throws std::invalid_argument unless first <= last <= 16 and samples > 0.
std::vector<IndexFigures> index_errors(const IndexBenchOptions& options = {});

/// The number of points that index_errors(options) judges in all.
std::uint64_t index_points(const IndexBenchOptions& options);

}  // namespace mmverify::bench
