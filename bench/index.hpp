// How fast impl's index is beside the specification's formula in plain floats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace mmverify::bench {

/// One subject at one level.
struct IndexRow {
  std::string name;  ///< "reference-f32", "impl-scalar" or "impl-batched"
  std::uint32_t level = 0;
  double ns_per_index = 0;  ///< processor time, median over the rounds
  /// Median over the rounds of ns / reference-f32's ns in the same round; below 1 is faster.
  double ratio_to_reference_f32 = 0;
};

struct IndexBenchOptions {
  std::size_t rounds = 11;  ///< at least 1; 0 counts as 1
  /// Passes over the 4096 points per measurement; enough for milliseconds.  0 counts as 1.
  std::size_t passes = 256;
  std::uint64_t seed = 1;
};

/// Times reference-f32 (spec's reference<float>, inlined in a loop), impl-scalar (a loop) and impl-batched
/// (one call) on the same 4096 uniform points of the triangle at levels 4, 10 and 16: nine rows, by level, in
/// this order of names.
/// Every round measures every row once, so that a ratio compares neighbours in time.  Prints nothing.
/// Drives Google Benchmark's registry, which is the process's: call from one thread, with nothing else
/// registered.
/// Throws std::runtime_error if Google Benchmark reports an error or leaves a row out.
std::vector<IndexRow> run_index_bench(const IndexBenchOptions& options = {});

}  // namespace mmverify::bench
