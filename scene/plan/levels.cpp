#include "scene/plan/levels.hpp"

#include <array>
#include <stdexcept>

namespace mmverify::scene {
namespace {

/// The bytes of a 4-state map.
std::uint64_t bytes(unsigned level) { return ((std::uint64_t{1} << (2 * level)) + 3) / 4; }

}  // namespace

Levels levels(const Plan& plan, const LevelRequest& request) {
  if (request.level && *request.level > finest_level)
    throw std::invalid_argument("levels: a level above " + std::to_string(finest_level));
  Levels chosen;
  std::array<std::uint64_t, finest_level + 1> count{};
  std::uint64_t size = 0;
  for (const PlannedTriangle& triangle : plan.triangles) {
    const unsigned level = request.level ? *request.level : triangle.level.level;
    chosen.of.push_back(level);
    ++count[level];
    size += bytes(level);
  }
  unsigned finest = finest_level;
  while (size > request.memory) {
    if (finest == 0)
      throw std::invalid_argument("less than a byte for each of the " +
                                  std::to_string(plan.triangles.size()) + " distinct triangles");
    size -= count[finest] * (bytes(finest) - bytes(finest - 1));
    count[finest - 1] += count[finest];
    --finest;
  }
  for (unsigned& level : chosen.of) {
    if (level > finest) {
      level = finest;
      ++chosen.lowered;
    }
    chosen.micro_triangles += std::uint64_t{1} << (2 * level);
  }
  return chosen;
}

}  // namespace mmverify::scene
