// bench --sweep: cells a second of index.equals_reference, beside the obvious loop.
#pragma once

#include <functional>
#include <string>

#include "bench/sweep/tables.hpp"
#include "proofs/engine/law.hpp"

namespace mmverify::cli {

/// Measures, level by level, sweeps of `step` and of `impl`, and the plain loop where that is short.
/// threads: 0 is as many as the machine has.  progress: told what begins.
/// Domain: levels up to 16.  Throws EnvironmentError where the plain loop and the sweep do not agree.
bench::SweepFigures sweep_figures(const proofs::Levels& levels, unsigned threads,
                                  const std::function<void(const std::string&)>& progress);

}  // namespace mmverify::cli
