// What sharing and merging of arrays save and cost, as a table.
#pragma once

#include <vector>

#include "bench/array/bench.hpp"
#include "bench/result.hpp"

namespace mmverify::bench {

Result array_tables(const std::vector<ArrayFigures>& figures, const ArrayBenchOptions& options);

}  // namespace mmverify::bench
