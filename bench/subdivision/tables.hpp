// The bench of topic subdivision, as tables.
#pragma once

#include <vector>

#include "bench/result.hpp"
#include "bench/subdivision/bench.hpp"

namespace mmverify::bench {

Result subdivision_tables(const std::vector<SubdivisionTimes>& times,
                          const std::vector<DisplacementSizes>& sizes,
                          const SubdivisionBenchOptions& options);

}  // namespace mmverify::bench
