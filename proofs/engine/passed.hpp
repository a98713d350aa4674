// The cases on which one subject's answer has passed the checks of several laws, so that one answer serves them all.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace mmverify::proofs {

/// Cases by number.  Threads share it: laws run side by side.
class Passed {
 public:
  explicit Passed(std::uint64_t cases) : state_(cases), answer_(cases) {}

  /// The number for the digest of the answer that passed all checks; nothing if none has yet.
  std::optional<std::uint64_t> answer(std::uint64_t k) const {
    return state_[k].load(std::memory_order_acquire) == passed ? std::optional(answer_[k]) : std::nullopt;
  }
  /// Whether the caller is the first to come to the case: it runs all checks.
  bool take(std::uint64_t k) {
    std::uint8_t expected = untouched;
    return state_[k].compare_exchange_strong(expected, taken);
  }
  /// All checks hold.  Domain: the caller took the case.
  void pass(std::uint64_t k, std::uint64_t answer) {
    answer_[k] = answer;
    state_[k].store(passed, std::memory_order_release);
  }

 private:
  enum : std::uint8_t { untouched, taken, passed };
  std::vector<std::atomic<std::uint8_t>> state_;
  std::vector<std::uint64_t> answer_;
};

}  // namespace mmverify::proofs
