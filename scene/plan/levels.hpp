// The level of each planned triangle.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/plan/plan.hpp"

namespace mmverify::scene {

struct LevelRequest {
  std::optional<unsigned> level;                  ///< of every triangle; none: each its highest useful level
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< bytes that all 4-state maps together may take
};

struct Levels {
  std::vector<unsigned> of;  ///< by Plan::triangles
  std::uint64_t micro_triangles = 0;
  std::uint64_t lowered = 0;  ///< triangles that got a lower level for want of memory
};

/// Chooses the levels.  If the maps would take more than the memory, all maps of the finest level are made
/// one level coarser, again and again, until they fit: equal triangles keep equal levels.
/// Errors: std::invalid_argument for a level above finest_level, or if even level 0 does not fit.
Levels levels(const Plan& plan, const LevelRequest& request);

}  // namespace mmverify::scene
