// Compares one run with another.
#pragma once

#include <string>
#include <vector>

#include "delivery/gate/baseline.hpp"
#include "delivery/gate/figures.hpp"

namespace mmverify::gate {

enum class Change { worse, better, changed, gone, added, faster };

struct Difference {
  Change change;
  std::string group, figure;  ///< `figure` is empty if the whole group is gone or new
  std::string before, after;  ///< empty if there is none
};

struct Comparison {
  std::size_t figures = 0, speeds = 0;  ///< figures compared, and the ratios of times among them
  std::string other_processor;  ///< the baseline's processor, if speeds of two processors were compared
  std::vector<Difference> differences;  ///< by kind, the worst first, then by name

  /// Whether any difference is red. All are, improvements too, until the baseline is updated; only a speed
  /// that gains more than the tolerance is not.
  bool red() const;
  /// Whether a law that held is refuted or broken: a baseline is no remedy.
  bool has_fallen() const;
  std::size_t count(Change change) const;
};

/// Compares exact figures by their values. A speed is worse if it loses more than the factor `tolerance`, and
/// faster if it gains as much.
/// Domain: tolerance > 1. Throws NoResult if schemas or settings differ: such figures cannot be compared.
Comparison compare(const Baseline& baseline, const Figures& result, double tolerance);

/// Gives `result` the better of each speed that both runs have: other work on the machine slows a run down
/// and never speeds it up. Exact figures stay. Throws NoResult if schemas or settings differ.
void take_better_speeds(Figures& result, const Figures& other);

}  // namespace mmverify::gate
