// bench vq: what block codecs lose, against what their encoders take.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "bench/vq/bench.hpp"
#include "cli/bench/output.hpp"

namespace mmverify::cli {

/// Measures and prints the tables.  Throws EnvironmentError for textures that cannot be read.
BenchOutput bench_vq(const bench::VqBenchOptions& options, bool quiet, std::FILE* out);

/// Savings, the maps in order of their own: VQ2 and VQ4 beside their sources and what the same memory buys
/// (figures 6 and 10 of Compressed Opacity Maps), and sources of several resolutions (figure 7); below,
/// substitutions over encode time.
std::string vq_plot_script(const bench::VqFigures& figures);

}  // namespace mmverify::cli
