// bench tree: size against time of the forms of a map.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "bench/tree/bench.hpp"
#include "cli/bench/output.hpp"

namespace mmverify::cli {

/// Measures and prints the tables.  Throws EnvironmentError for textures that cannot be read.
BenchOutput bench_tree(const bench::TreeBenchOptions& options, bool quiet, std::FILE* out);

/// Above two states, below four: bits a micro-triangle over ns a lookup, a line a form, its levels in order.
std::string tree_plot_script(const std::vector<bench::TreeFigures>& figures);

}  // namespace mmverify::cli
