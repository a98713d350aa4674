// The loss of block codecs against the time that their encoders take, as tables and a picture.
#pragma once

#include "bench/result.hpp"
#include "bench/vq/bench.hpp"

namespace mmverify::bench {

Result vq_tables(const VqFigures& figures, const VqBenchOptions& options);

/// Savings, the maps in order of their own savings: VQ2 and VQ4 beside their sources and other maps of the
/// same memory (figures 6 and 10 of Compressed Opacity Maps), and sources of several resolutions (figure 7).
std::vector<picture::Panel> vq_savings_panels(const std::vector<VqRow>& rows);

/// These panels, and substitutions over encode time.
picture::Picture vq_picture(const VqFigures& figures);

}  // namespace mmverify::bench
