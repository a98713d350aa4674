// The cost of an index.
#pragma once

#include <vector>

#include "bench/index/bench.hpp"

namespace mmverify::bench {

/// Times every subject of `figures`, which index_errors made, on uniform points, one thread, by Google
/// Benchmark: at levels 4, 10, 15 and 16, as far as they are in the range, and at the last one.
/// Every round measures everything once, so that a ratio compares neighbours in time. Drives Google
/// Benchmark's registry, which is the process's: call from one thread, with nothing else registered.
/// Throws std::runtime_error if Google Benchmark reports an error or leaves a row out.
void add_index_times(const IndexBenchOptions& options, std::vector<IndexFigures>& figures);

}  // namespace mmverify::bench
