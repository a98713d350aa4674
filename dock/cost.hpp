// What it costs to ask a subject in another process.
#pragma once

#include <string>

#include "dock/worker.hpp"

namespace mmverify::dock {

/// Nanoseconds an index, medians over rounds that take turns.
struct Cost {
  double bare = 0;  ///< the library loaded here, called in a loop over batches of 4096
  /// The same calls made by a worker, the switch of processes and all re-asking included.
  double isolated = 0;
  double ratio = 0;  ///< median of isolated / bare, round by round
};

/// Measures index_f32 at a level on `capacity` points of the triangle, one thread.  The library is loaded
/// into this process: for one that is trusted.  Throws CannotLoad; std::runtime_error where it has no
/// index_f32.
Cost measure_cost(const std::string& library, std::uint32_t level, const Options& options);

}  // namespace mmverify::dock
