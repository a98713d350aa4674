// bench sweep: cells a second of index.equals_reference, beside the obvious loop.
#pragma once

#include <cstdio>
#include <string>

#include "proofs/engine/law.hpp"

namespace mmverify::cli {

/// Prints, level by level, what a sweep of `step` and of `impl` costs, what the plain loop costs where that
/// is short, their ratio, how the cost grows, and the memory taken; returns the figures as JSON text.
/// Domain: levels up to 16.  Throws EnvironmentError where the plain loop and the sweep do not agree.
std::string bench_sweep(const proofs::Levels& levels, unsigned threads, std::FILE* out);

}  // namespace mmverify::cli
