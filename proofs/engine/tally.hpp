// The sums of a sweep, which do not depend on the order of the chunks.
#pragma once

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "proofs/engine/result.hpp"

namespace mmverify::proofs {

class Tally {
 public:
  explicit Tally(std::size_t keep = 1) : keep_(keep) {}

  /// A tally rebuilt from its parts: counts, digest, counterexamples in their order.
  static Tally restored(const CountByKind& by_kind, std::uint64_t digest, std::vector<Counterexample> found) {
    Tally tally(found.size());
    tally.by_kind_ = by_kind;
    tally.digest_ = digest;
    tally.found_ = std::move(found);
    return tally;
  }

  /// Counts one case that the subject does not claim to support; it shows nothing.
  void decline(Kind kind) {
    Count& count = by_kind_[static_cast<std::size_t>(kind)];
    ++count.cases;
    ++count.declined;
  }

  /// Notes that a case broke the subject, so that the cases of this tally are not finished.
  void break_off() { broke_ = true; }

  /// Counts one case that the subject broke on.
  void leave_unjudged(Kind kind) {
    Count& count = by_kind_[static_cast<std::size_t>(kind)];
    ++count.cases;
    ++count.unjudged;
    break_off();
  }

  /// Turns all declined cases into unjudged ones.
  void none_declined() {
    for (Count& count : by_kind_) count.unjudged += std::exchange(count.declined, 0);
    break_off();
  }
  bool broke() const { return broke_; }

  /// Notes that the answer of a counted case passed only by an allowance.
  void allow(Kind kind) { ++by_kind_[static_cast<std::size_t>(kind)].allowed; }

  void count(Kind kind, std::uint64_t cases) { by_kind_[static_cast<std::size_t>(kind)].cases += cases; }

  /// Adds one answer to the digest:  sum over cases of (answer+1) * weight(case)  modulo 2^64.
  /// The weight is odd, so that a changed answer changes the sum.
  static constexpr std::uint64_t digest_of(std::uint64_t case_number, std::uint64_t answer) {
    return (answer + 1) * ((case_number * 0x9E3779B97F4A7C15u) >> 31 | 1);
  }
  void digest(std::uint64_t case_number, std::uint64_t answer) { digest_ += digest_of(case_number, answer); }
  void digest_sum(std::uint64_t sum) { digest_ += sum; }

  /// Counts one failed case; `describe` makes its Counterexample, and is called only if it is among the simplest.
  template <class Describe>
  void mismatch(Kind kind, const Simplicity& simplicity, Describe describe) {
    ++by_kind_[static_cast<std::size_t>(kind)].mismatches;
    if (found_.size() == keep_ && (keep_ == 0 || found_.back().simplicity < simplicity)) return;
    keep(describe());
  }

  void merge(const Tally& other) {
    for (std::size_t k = 0; k < kinds; ++k) {
      by_kind_[k].cases += other.by_kind_[k].cases;
      by_kind_[k].mismatches += other.by_kind_[k].mismatches;
      by_kind_[k].declined += other.by_kind_[k].declined;
      by_kind_[k].allowed += other.by_kind_[k].allowed;
      by_kind_[k].unjudged += other.by_kind_[k].unjudged;
    }
    digest_ += other.digest_;
    broke_ = broke_ || other.broke_;
    for (const Counterexample& c : other.found_) keep(c);
  }

  /// Replaces the counterexamples by another tally's; the counts stay.
  void replace_found(const Tally& other) { found_ = other.found_; }

  const CountByKind& by_kind() const { return by_kind_; }
  std::uint64_t digest() const { return digest_; }
  const std::vector<Counterexample>& found() const { return found_; }
  std::uint64_t mismatches() const {
    return by_kind_[0].mismatches + by_kind_[1].mismatches + by_kind_[2].mismatches;
  }
  std::uint64_t cases() const { return by_kind_[0].cases + by_kind_[1].cases + by_kind_[2].cases; }

 private:
  void keep(Counterexample c) {
    const auto place = std::upper_bound(found_.begin(), found_.end(), c, [](const auto& a, const auto& b) {
      return std::tie(a.simplicity, a.at) < std::tie(b.simplicity, b.at);
    });
    // A sample may contain a case twice.
    if (place != found_.begin() && std::prev(place)->at == c.at &&
        std::prev(place)->simplicity == c.simplicity)
      return;
    found_.insert(place, std::move(c));
    if (found_.size() > keep_) found_.pop_back();
  }

  std::size_t keep_;
  CountByKind by_kind_{};
  std::uint64_t digest_ = 0;
  bool broke_ = false;
  std::vector<Counterexample> found_;
};

}  // namespace mmverify::proofs
