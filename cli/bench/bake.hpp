// bench bake: what bakers get wrong, against what they take.
#pragma once

#include <cstdio>
#include <string>

#include "bench/bake/bench.hpp"
#include "cli/bench/output.hpp"

namespace mmverify::cli {

/// Measures and prints the tables.  Throws EnvironmentError for textures that cannot be read.
BenchOutput bench_bake(const bench::BakeBenchOptions& options, bool quiet, std::FILE* out);

/// Wrong states over the time of one, at the middle level; that time over the level, and over the size of the
/// texture; unknown states over the margin.
std::string bake_plot_script(const bench::BakeFigures& figures);

}  // namespace mmverify::cli
