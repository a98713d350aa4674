// bench --sweep: cells per second of index.equals_reference, compared with a plain loop.
#pragma once

#include <functional>
#include <string>

#include "bench/sweep/tables.hpp"
#include "proofs/engine/law.hpp"

namespace mmverify::cli {

/// Measures sweeps of the subjects `step` and `impl` level by level, and the plain loop at low levels.
/// threads: 0 for as many as the machine has. progress: called with the name of each step.
/// Domain: levels up to 16. Throws EnvironmentError if the plain loop and the sweep disagree.
bench::SweepFigures sweep_figures(const proofs::Levels& levels, unsigned threads,
                                  const std::function<void(const std::string&)>& progress);

}  // namespace mmverify::cli
