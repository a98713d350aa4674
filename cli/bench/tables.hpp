// What a bench returned, printed and as JSON.
#pragma once

#include <cstdio>
#include <string>

#include "bench/result.hpp"

namespace mmverify::cli {

/// Prints the settings, what the bench says of itself, and its tables.  A table wider than 150 characters comes in
/// parts, each of which begins with the leading columns.
void print_result(std::FILE* out, const bench::Result& result);

/// One object: schema, topic, tool, then the tables in their order, as docs/bench.schema.json has them.
std::string result_json(const bench::Result& result);

}  // namespace mmverify::cli
