// Runs gnuplot.
#pragma once

#include <string>

namespace mmverify::cli {

/// The output of gnuplot for a script that writes to standard output.
/// Throws EnvironmentError if gnuplot fails, or is missing; the message then names the Debian package.
std::string run_gnuplot(const std::string& script);

}  // namespace mmverify::cli
