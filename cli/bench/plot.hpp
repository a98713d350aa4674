// Draws pictures of a bench in gnuplot's language.
#pragma once

#include <string>

#include "bench/picture.hpp"

namespace mmverify::cli {

/// A picture is an SVG, or a PNG of twice as many pixels in each direction.
enum class PlotFormat { svg, png };

/// A script that makes gnuplot write the picture to standard output.
std::string plot_script(const bench::picture::Picture& picture, PlotFormat format);

}  // namespace mmverify::cli
