// The sizes of maps in each form, as tables and a picture.
#pragma once

#include <vector>

#include "bench/dag/bench.hpp"
#include "bench/result.hpp"

namespace mmverify::bench {

Result dag_tables(const std::vector<DagFigures>& figures, const DagBenchOptions& options);

/// Above two states, below four: bytes over ns a lookup, a line a form, its levels in order.
picture::Picture dag_picture(const std::vector<DagFigures>& figures);

}  // namespace mmverify::bench
