// Measures the cost of calling a subject in another process.
#pragma once

#include <string>

#include "subjects/dock/worker.hpp"

namespace mmverify::dock {

/// Nanoseconds per index: medians over alternating rounds.
struct Cost {
  double bare = 0;  ///< the library in this process, called in a loop over batches of 4096
  /// The same calls by a worker, with the switch of processes and all repeated questions.
  double isolated = 0;
  double ratio = 0;  ///< median of isolated / bare over rounds
};

/// Measures index_f32 at a level on `capacity` points of the triangle with one thread. The library is loaded
/// into this process, so it must be trusted. Throws CannotLoad; std::runtime_error if it has no index_f32.
Cost measure_cost(const std::string& library, std::uint32_t level, const Options& options);

}  // namespace mmverify::dock
