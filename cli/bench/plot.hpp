// Draws pictures of a bench in gnuplot's language.
#pragma once

#include <string>

#include "bench/picture.hpp"

namespace mmverify::cli {

/// A script for run_gnuplot that writes SVG.
std::string plot_script(const bench::picture::Picture& picture);

}  // namespace mmverify::cli
