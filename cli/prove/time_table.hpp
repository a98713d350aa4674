// The times of a run, law by law.
#pragma once

#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// A line for each law that ran, the dearest first: its tasks, seconds, processor seconds, those of its mutants, and the
/// longest path of one task.  Then the sums, how busy the threads were, and the critical path.
/// processor_seconds: of the whole process.
std::vector<std::string> time_table(const proofs::Report& report, double processor_seconds);

/// The processor seconds of this process so far.
double processor_seconds();

}  // namespace mmverify::cli
