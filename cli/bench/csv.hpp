// A bench's result as comma-separated values.
#pragma once

#include <string>

#include "bench/result.hpp"

namespace mmverify::cli {

/// Each list of the result's JSON as a header line and a line a row, lists apart by an empty line.  A figure has its
/// JSON name; one of a table within has that table's name and its row's before it, as in forms.paper.bits.
/// Fields with a comma, a quote or a line's end stand in quotes (RFC 4180); numbers are as in JSON.
std::string result_csv(const bench::Result& result);

}  // namespace mmverify::cli
