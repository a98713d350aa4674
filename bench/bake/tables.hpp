// The errors of bakers against the time that they take, as tables and a picture.
#pragma once

#include "bench/bake/bench.hpp"
#include "bench/result.hpp"

namespace mmverify::bench {

Result bake_tables(const BakeFigures& figures, const BakeBenchOptions& options);

/// Wrong and needless states over the time of one state, at the middle level; that time over the level, and
/// over the size of the texture; unknown states over the margin.
picture::Picture bake_picture(const BakeFigures& figures);

}  // namespace mmverify::bench
