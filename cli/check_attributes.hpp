// mmverify check attributes: a file of attribute micromaps.
#pragma once

#include <string>

namespace mmverify::cli {

/// Reads the file and says what it holds, or with which byte it is none.  Returns the exit code: 1 for the latter.
/// Throws UsageError, BadScene for a file that cannot be read.
int check_attributes(const std::string& file);

}  // namespace mmverify::cli
