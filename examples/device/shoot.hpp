// Rays through points of a job's triangles, and what they meet.
#pragma once

#include <optional>

#include "compute.hpp"
#include "job.hpp"

namespace rays {

/// A ray query meets nothing, or a hit, or a candidate that the shader has to decide; both is a device's fault.
enum Outcome : std::uint32_t { missed, met_opaque, asked, both };

/// A ray's two outcomes: as the maps are, and with unknown states forced to two.
struct Hit {
  std::uint32_t plain = missed, forced = missed;
  float u = 0, v = 0;  ///< the device's barycentrics, where `plain` is met_opaque
};

/// The state that two outcomes mean; none where no state has both.
std::optional<State> state_of(const Hit& hit);

class Shooter {
 public:
  explicit Shooter(const Device& device);
  ~Shooter();
  Shooter(const Shooter&) = delete;
  Shooter& operator=(const Shooter&) = delete;

  /// Builds the job and shoots at each point of each triangle; hit p * job.triangles + t is point p's of triangle t.
  std::vector<Hit> shoot(const Job& job, const std::vector<Point>& points);

 private:
  void run(const Job& job, const Buffer& rays, const Buffer& hits, std::uint32_t count);

  const Device& device_;
  Pipeline pipeline_;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
};

}  // namespace rays
