// bench index: error against run time of the float instances and the fast library.
#pragma once

#include <cstdio>

#include "bench/index/bench.hpp"
#include "cli/bench/output.hpp"

namespace mmverify::cli {

/// Measures and prints the tables.  Throws proofs::Interrupted.
BenchOutput bench_index(const bench::IndexBenchOptions& options, bool quiet, std::FILE* out);

}  // namespace mmverify::cli
