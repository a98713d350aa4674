// One run against another.
#pragma once

#include <string>
#include <vector>

#include "gate/baseline.hpp"
#include "gate/figures.hpp"

namespace mmverify::gate {

enum class Change { worse, better, changed, gone, added, faster };

struct Difference {
  Change change;
  std::string group, figure;  ///< no figure where the whole group is gone or new
  std::string before, after;  ///< empty for what is not there
};

struct Comparison {
  std::size_t figures = 0, speeds = 0;  ///< compared; of these, ratios of times
  std::string other_processor;          ///< the baseline's, where speeds were compared with another's
  std::vector<Difference> differences;  ///< by name within each kind; the worse first

  /// A baseline is exact: whatever differs is red, also for the better, until it is blessed.  Only a speed
  /// that is better by more than the tolerance is merely said.
  bool red() const;
  std::size_t count(Change change) const;
};

/// Exact figures by their values; a speed is worse where it is more than `tolerance` times the baseline's (or
/// less than the baseline's over it), faster where it is better by as much.
/// Domain: tolerance > 1.  Throws NoResult where schemas or settings differ, which makes figures no
/// comparison.
Comparison compare(const Baseline& baseline, const Figures& result, double tolerance);

/// Of each speed that both have, `result` gets the better: other work on the machine slows a run down, none makes it
/// faster.  Exact figures stay.  Throws NoResult where schemas or settings differ.
void take_better_speeds(Figures& result, const Figures& other);

}  // namespace mmverify::gate
