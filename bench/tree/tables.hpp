// Tables and a picture of size against time of the forms of a map.
#pragma once

#include <vector>

#include "bench/result.hpp"
#include "bench/tree/bench.hpp"

namespace mmverify::bench {

Result tree_tables(const std::vector<TreeFigures>& figures, const TreeBenchOptions& options);

/// Above two states, below four: bits a micro-triangle over ns a lookup, a line a form, its levels in order.
picture::Picture tree_picture(const std::vector<TreeFigures>& figures);

}  // namespace mmverify::bench
