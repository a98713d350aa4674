// The cases on which one subject's answer has passed the checks of several laws, so that one answer serves them all.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
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

/// The passed cases of one subject, level by level from 0; it lies among the subject's functions.  A copy of the functions
/// belongs to another subject, such as a mutant, and keeps nothing.
class PassedOfSubject {
 public:
  PassedOfSubject() = default;
  explicit PassedOfSubject(const std::vector<std::uint64_t>& cases_of_level) {
    for (const std::uint64_t cases : cases_of_level) levels_.push_back(std::make_unique<Passed>(cases));
  }
  PassedOfSubject(const PassedOfSubject&) {}
  PassedOfSubject(PassedOfSubject&&) = default;
  PassedOfSubject& operator=(PassedOfSubject other) {
    levels_ = std::move(other.levels_);
    return *this;
  }
  ~PassedOfSubject() = default;

  /// Null if nothing is kept at that level.
  Passed* at(std::size_t level) const { return level < levels_.size() ? levels_[level].get() : nullptr; }

 private:
  std::vector<std::unique_ptr<Passed>> levels_;
};

}  // namespace mmverify::proofs
