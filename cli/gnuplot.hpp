// gnuplot, asked for a picture.
#pragma once

#include <string>

namespace mmverify::cli {

/// What gnuplot makes of a script that writes to its standard output.
/// Throws EnvironmentError where there is no gnuplot, naming the Debian package, or where it fails.
std::string run_gnuplot(const std::string& script);

}  // namespace mmverify::cli
