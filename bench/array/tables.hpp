// A table of the savings and costs of sharing and merging in arrays.
#pragma once

#include <vector>

#include "bench/array/bench.hpp"
#include "bench/result.hpp"

namespace mmverify::bench {

Result array_tables(const std::vector<ArrayFigures>& figures, const ArrayBenchOptions& options);

}  // namespace mmverify::bench
