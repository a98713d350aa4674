// Error against run time of the index functions, as tables and a picture.
#pragma once

#include <vector>

#include "bench/index/bench.hpp"
#include "bench/result.hpp"

namespace mmverify::bench {

/// Domain: figures with their times; see add_index_times.
Result index_tables(const std::vector<IndexFigures>& figures, const IndexBenchOptions& options);

/// Above, error against time, a mark a subject at its highest level; below, the mismatch rate against the
/// level on uniform and on stiff points, with the fitted laws.
picture::Picture index_picture(const std::vector<IndexFigures>& figures, std::uint64_t samples);

}  // namespace mmverify::bench
