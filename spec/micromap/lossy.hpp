// The states that may replace others in a lossy map: three laws, each within the next.
#pragma once

#include "spec/micromap/micromap.hpp"

namespace mmverify::spec::micromap {

/// KHR's rule for lossy micromaps: any state may become UT or UO, none becomes T or O.  4-state only.
/// Source: the KHR slides, "Lossy Micromaps".
constexpr bool allowed(State was, State is) { return is == was || unknown(is); }

/// T and O may become unknown, and nothing else changes: an unknown state keeps its force-2-state, too.
/// Source: this project's design.
constexpr bool conservative(State was, State is) { return is == was || (!unknown(was) && unknown(is)); }

/// T may become UT and O may become UO, and nothing else changes: force-2-state sees no difference.
/// Source: this project's design.
constexpr bool force2_stable(State was, State is) { return is == was || is == as_unknown(was); }

/// Whether a rule holds for each micro-triangle of two maps of one level.
template <class Rule>
bool everywhere(std::span<const State> was, std::span<const State> is, Rule rule) {
  if (was.size() != is.size()) return false;
  for (std::size_t i = 0; i < was.size(); ++i)
    if (!rule(was[i], is[i])) return false;
  return true;
}

}  // namespace mmverify::spec::micromap
