// The level of each planned triangle.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/plan/plan.hpp"

namespace mmverify::scene {

struct LevelRequest {
  std::optional<unsigned> level;                  ///< of every triangle; none: each its highest useful one
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< bytes that all 4-state maps together may take
};

struct Levels {
  std::vector<unsigned> of;  ///< by Plan::triangles
  std::uint64_t micro_triangles = 0;
  std::uint64_t lowered = 0;  ///< triangles that got a lower level for want of memory
};

/// Where the maps would take more than the budget, the finest of them are made one level coarser, all of one
/// level at a time, until they fit: equal triangles keep equal levels.
/// Errors: std::invalid_argument for a level above finest_level, or where even level 0 does not fit.
Levels levels(const Plan& plan, const LevelRequest& request);

}  // namespace mmverify::scene
