// Levels of a mesh's triangles.
// Source: Color and Attribute Micromaps, 3.2; docs/ATTRIBUTE_BAKE.md, "What needs no micromap".
#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/foreign/attribute/faults.hpp"

namespace mmverify::tests::foreign::attribute {

using proofs::attribute::PlanCase;
using proofs::attribute::PlannedTriangle;

namespace {

/// Raises triangles beside one that is two levels above, until there is none.
void grade(std::vector<Level>& levels, const PlanCase& one, Fault wrong) {
  const auto bounds = [&](std::int32_t s) {
    return s >= 0 && (wrong == plan_special_bounds || !one.special[static_cast<std::size_t>(s)]);
  };
  for (bool again = true; again;) {
    again = false;
    for (std::size_t t = 0; t < levels.size(); ++t) {
      if (one.special[t] && wrong != plan_special_bounds) continue;
      for (std::size_t edge = 0; edge < 3; ++edge) {
        if (wrong == plan_two_edges_alone && edge == 2) continue;
        const std::int32_t s = one.neighbours[t][edge];
        if (!bounds(s)) continue;
        const Level there = levels[static_cast<std::size_t>(s)],
                    step = wrong == plan_steps_of_two_at_3 && there > 3 ? 2 : 1;
        if (there > levels[t] + step) levels[t] = there - step, again = true;
      }
    }
    if (wrong == plan_grades_once) again = false;
  }
}

}  // namespace

std::vector<PlannedTriangle> planned(const PlanCase& one, Fault wrong) {
  const std::size_t count = one.neighbours.size();
  std::vector<Level> wanted(count, 0);
  for (std::size_t t = 0; t < count; ++t)
    while (!one.special[t] && wanted[t] < one.highest && !one.keeps(t, wanted[t], 0)) ++wanted[t];
  if (wrong == plan_all_alike)
    std::fill(wanted.begin(), wanted.end(), *std::max_element(wanted.begin(), wanted.end()));
  for (;;) {
    std::vector<Level> levels = wanted;
    grade(levels, one, wrong);
    std::vector<PlannedTriangle> plan(count);
    bool raised = false;
    for (std::size_t t = 0; t < count; ++t) {
      if (one.special[t]) continue;
      std::uint8_t flags = 0;
      for (std::size_t edge = 0; edge < 3; ++edge) {
        const std::int32_t s = one.neighbours[t][edge];
        if (s < 0 || one.special[static_cast<std::size_t>(s)]) continue;
        const Level there = levels[static_cast<std::size_t>(s)];
        if (there + 1 == levels[t]) flags = static_cast<std::uint8_t>(flags | 1u << edge);
      }
      plan[t] = {levels[t], flags, one.keeps(t, levels[t], flags)};
      if (wrong == plan_says_kept) plan[t].kept = true;
      if (plan[t].kept || raised) continue;
      if (flags != 0 && one.keeps(t, levels[t], 0) && wrong != plan_leaves_decimated_edges) {
        for (std::size_t edge = 0; edge < 3; ++edge)
          if ((flags >> edge & 1) != 0) wanted[static_cast<std::size_t>(one.neighbours[t][edge])] = levels[t];
        raised = true;
      } else if (levels[t] < one.highest && wrong != plan_leaves_decimated_edges) {
        wanted[t] = levels[t] + 1;
        raised = true;
      }
    }
    if (raised && wrong != plan_tries_once) continue;
    for (std::size_t t = 0; t < count; ++t) {
      const auto edges = static_cast<unsigned>(plan[t].decimated);
      if (wrong == plan_flags_from_the_next)
        plan[t].decimated = static_cast<std::uint8_t>((edges << 1 | edges >> 2) & 7);
      if (wrong != plan_flags_on_the_coarser) continue;
      plan[t].decimated = 0;
      for (std::size_t edge = 0; edge < 3 && !one.special[t]; ++edge) {
        const std::int32_t s = one.neighbours[t][edge];
        if (s >= 0 && levels[static_cast<std::size_t>(s)] == levels[t] + 1)
          plan[t].decimated = static_cast<std::uint8_t>(plan[t].decimated | 1u << edge);
      }
    }
    return plan;
  }
}

}  // namespace mmverify::tests::foreign::attribute
