// Prints a bench's result, and writes it as JSON.
#pragma once

#include <cstdio>
#include <string>

#include "bench/result.hpp"

namespace mmverify::cli {

/// Prints the settings, the bench's remarks, and its tables. A table wider than 150 characters is printed in
/// parts, each of which begins with the leading columns.
void print_result(std::FILE* out, const bench::Result& result);

/// One JSON object as `mmverify schema bench` says: schema, topic, tool, then the tables in their order.
std::string result_json(const bench::Result& result);

}  // namespace mmverify::cli
