// mmverify check attributes: checks a file of attribute micromaps.
#pragma once

#include <string>

namespace mmverify::cli {

/// Prints the content of the file, or the first wrong byte. Returns the exit code: 1 if the file is invalid.
/// Throws UsageError; BadScene for a file that cannot be read.
int check_attributes(const std::string& file);

}  // namespace mmverify::cli
