// Watches a worker while it has the turn: its memory, its threads, its output.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace mmverify::dock {

/// A pipe for a worker's output. It is passed on to stderr line by line, up to a limit: as clean_text() after
/// `subject| `, so that no line can be mistaken for one of this program or for a CI's command.
class Printed {
 public:
  static constexpr std::uint64_t most = 1u << 20;

  /// Throws NoResources if no pipe can be made.
  Printed();
  ~Printed();
  Printed(const Printed&) = delete;
  Printed& operator=(const Printed&) = delete;

  /// The worker's end; closed here once the worker has it.
  int write_end() const { return ends_[1]; }
  void close_write_end();

  /// Passes on the available lines without waiting. False once there are more than `most` bytes in all.
  bool pass_on();

  /// The summary of a sanitizer's report, "AddressSanitizer: heap-buffer-overflow mine.c:17 in bake"; empty
  /// without one.
  const std::string& report() const { return report_; }

 private:
  void take(std::string_view text);
  void end_line();

  std::string line_, report_;
  int ends_[2] = {-1, -1};
  std::uint64_t bytes_ = 0;
};

/// The bounds of a worker. No limit of the system serves: address space does not measure memory in sanitized
/// programs, and root has no limit of processes.
struct Bounds {
  /// MiB in memory or swapped out, huge pages included; also, separately, MiB written to files in all.
  /// MMVERIFY_WORKER_MEMORY sets it.
  std::uint64_t memory_mib = 4096;
  std::uint64_t threads = 512;
};

/// The bounds that the environment sets. Throws std::runtime_error if MMVERIFY_WORKER_MEMORY is no number
/// from 1 on.
Bounds bounds();

/// The bound that the process exceeds, in words; empty if none, or if the process has ended.
std::string over(const Bounds& bounds, int pid);

/// The kernel's letter for the process's state: 'T' stopped by a signal, 't' by a debugger; 0 if it has
/// ended.
char state_of(int pid);

/// Time that threads of a process wait for a processor.
class Waiting {
 public:
  explicit Waiting(int pid) : pid_(pid) { seconds(); }
  /// Seconds since the last call, or the start, that the thread which waited most has waited; 0 if the kernel does not say.
  /// One of the first 16 threads: a subject of hundreds would cost more to look at than to run.
  double seconds();

 private:
  int pid_;
  std::map<std::string, std::uint64_t> nanoseconds_;  ///< by thread, so far
};

}  // namespace mmverify::dock
