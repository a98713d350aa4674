// Cases that a subject broke on instead of answering; a law continues after them.
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <mutex>
#include <utility>

#include "proofs/engine/result.hpp"
#include "subjects/dock/broken.hpp"

namespace mmverify::proofs {

/// The breaks of one law and subject, at all levels.  Threads share it.
class Breaks {
 public:
  /// The number of breaks that ends a law, and of breaks by timeout that does.  Before any answer fewer end it, since
  /// the subject breaks on everything.
  static constexpr std::size_t most = 100, most_hung = 3, most_unanswered = 8;

  /// `end_with`: the number of breaks that ends the law.
  explicit Breaks(std::size_t end_with = most) : most_(end_with) {}

  /// Notes a break on case k of a level; the case counts as not judged.  If that is one too many, throws
  /// SubjectBroken with the break of the least case of the level.
  void note(Level level, std::uint64_t k, const dock::CaseBroken& what);

  /// Notes that the subject answered a case.
  void answered() {
    if (!answered_.load(std::memory_order_relaxed)) answered_ = true;
  }

  /// The messages of a level's breaks, in the order of cases; each message once.
  std::vector<std::string> at(Level level) const;

 private:
  std::size_t most_;
  std::atomic<bool> answered_ = false;
  mutable std::mutex lock_;
  std::map<std::pair<Level, std::uint64_t>, std::string> found_;
  std::size_t hung_ = 0;
};

}  // namespace mmverify::proofs
