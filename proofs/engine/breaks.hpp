// Cases on which a subject did something else than answer: a law goes on after them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "dock/broken.hpp"
#include "proofs/engine/result.hpp"

namespace mmverify::proofs {

/// Of one law and subject, at all levels.  Threads share it.
class Breaks {
 public:
  /// A law ends with so many, or with so many that took all the time that they may; before any case was answered, with
  /// fewer: the subject breaks on everything.
  static constexpr std::size_t most = 100, most_hung = 3, most_unanswered = 8;

  /// A law may end with fewer.
  explicit Breaks(std::size_t end_with = most) : most_(end_with) {}

  /// Notes case k of a level, which counts as not judged.  Throws SubjectBroken where it is one too many: as the first in
  /// the order of cases among those of its level does.
  void note(Level level, std::uint64_t k, const dock::CaseBroken& what);

  /// Says that the subject answered a case.
  void answered() {
    if (!answered_.load(std::memory_order_relaxed)) answered_ = true;
  }

  /// What the subject did at a level, in the order of its cases; the same words of several cases once.
  std::vector<std::string> at(Level level) const;

 private:
  std::size_t most_;
  std::atomic<bool> answered_ = false;
  mutable std::mutex lock_;
  std::map<std::pair<Level, std::uint64_t>, std::string> found_;
  std::size_t hung_ = 0;
};

}  // namespace mmverify::proofs
