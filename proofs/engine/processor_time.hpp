// The processor's time of a task, counted over all threads that work for it, and the part that no further thread shortens.
#pragma once

#include <atomic>
#include <cstdint>

namespace mmverify::proofs {

/// The calling thread's processor time so far, in nanoseconds; 0 where the system keeps none.
std::int64_t thread_nanoseconds();

/// A task's processor time in nanoseconds.  Threads share it.
struct ProcessorTime {
  std::atomic<std::int64_t> spent = 0;  ///< by all threads
  std::atomic<std::int64_t> path =
      0;  ///< of one thread at least: outside sweeps, and of each sweep the longest part
};

/// Counts the calling thread's processor time for a task while it lives; the task that it displaces is counted again
/// afterwards.
class Counting {
 public:
  /// alone: outside the sweeps, so that the time is part of the task's path.
  Counting(ProcessorTime* task, bool alone);
  ~Counting();
  Counting(const Counting&) = delete;
  Counting& operator=(const Counting&) = delete;

  /// The task that the calling thread's time counts for; null if none.
  static ProcessorTime* task();

 private:
  static void settle(std::int64_t now);

  ProcessorTime* displaced_;
  bool displaced_alone_;
};

}  // namespace mmverify::proofs
