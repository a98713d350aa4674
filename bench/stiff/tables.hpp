// The figures of stiff inputs as a table and a picture.
#pragma once

#include "bench/result.hpp"
#include "bench/stiff/bench.hpp"

namespace mmverify::bench {

Result stiff_tables(const std::vector<StiffFigure>& figures, const StiffBenchOptions& options);

/// A panel a kind: the share of wrong answers over the time of one, each method on ordinary and on stiff inputs.
picture::Picture stiff_picture(const std::vector<StiffFigure>& figures);

}  // namespace mmverify::bench
