// What the tool looks at while a worker has the turn: its memory, its threads, what it prints.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mmverify::dock {

/// A pipe that a worker prints to.  What comes is passed on to stderr line by line, up to a limit: as clean_text() and
/// behind `subject| `, so that no line can be taken for one of this program, or for a CI's command.
class Printed {
 public:
  static constexpr std::uint64_t most = 1u << 20;

  /// Throws NoResources where no pipe can be had.
  Printed();
  ~Printed();
  Printed(const Printed&) = delete;
  Printed& operator=(const Printed&) = delete;

  /// The end that the worker gets; closed here once it has it.
  int write_end() const { return ends_[1]; }
  void close_write_end();

  /// Passes on the lines that are there, without waiting.  False once it is more than `most` bytes in all.
  bool pass_on();

  /// "AddressSanitizer: heap-buffer-overflow mine.c:17 in bake": the summary of a sanitizer's report, once one has come.
  const std::string& report() const { return report_; }

 private:
  void take(std::string_view text);
  void end_line();

  std::string line_, report_;
  int ends_[2] = {-1, -1};
  std::uint64_t bytes_ = 0;
};

/// The bounds of a worker, which no limit of the system's can be trusted with: address space says nothing of memory in
/// sanitized programs, and root has no limit of processes.
struct Bounds {
  /// In memory or swapped out, huge pages too; and, apart, written to files in all.  MMVERIFY_WORKER_MEMORY sets it.
  std::uint64_t memory_mib = 4096;
  std::uint64_t threads = 512;
};

/// The bounds, by the environment.  Throws std::runtime_error where MMVERIFY_WORKER_MEMORY is no number from 1 on.
Bounds bounds();

/// Which bound the process is over, in words; empty where none, or where it is no more.
std::string over(const Bounds& bounds, int pid);

/// The process's state as the kernel's letter: 'T' stopped by a signal, 't' held by a debugger; 0 where it is no more.
char state_of(int pid);

}  // namespace mmverify::dock
