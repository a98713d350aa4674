// Progress of a long run, on stderr: a bar on a terminal, a plain line every few seconds off one.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace mmverify::proofs {

class Progress {
 public:
  /// total: the number of cases of the whole run; shown: false keeps it silent (tests).
  Progress(std::uint64_t total, bool shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void now(const std::string& what);
  /// Cases that an earlier run has done: they count as done, not as fast.
  void resume(std::uint64_t cases) { resumed_.fetch_add(cases, std::memory_order_relaxed); }
  void add(std::uint64_t cases) { done_.fetch_add(cases, std::memory_order_relaxed); }

 private:
  void show();
  void watch();

  const std::uint64_t total_;
  const bool terminal_;
  const std::chrono::steady_clock::time_point start_;
  std::atomic<std::uint64_t> done_ = 0, resumed_ = 0;
  std::mutex lock_;
  std::condition_variable wake_;
  std::string what_;
  bool over_ = false, drawn_ = false;
  std::thread watcher_;
};

}  // namespace mmverify::proofs
