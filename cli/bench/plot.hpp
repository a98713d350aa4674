// Pictures of a bench run, drawn by gnuplot.
#pragma once

#include <string>
#include <vector>

#include "bench/index/bench.hpp"

namespace mmverify::cli {

/// The gnuplot script: above, error against time, a mark a subject at its highest level; below, the mismatch
/// rate against the level on uniform and on hard points, with the fitted laws.
std::string index_plot_script(const std::vector<bench::IndexFigures>& figures, std::uint64_t samples);

/// What gnuplot makes of a script that writes to its standard output.
/// Throws EnvironmentError where there is no gnuplot, naming the Debian package, or where it fails.
std::string run_gnuplot(const std::string& script);

}  // namespace mmverify::cli
