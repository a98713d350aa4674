#include "shoot.hpp"

#include <bit>
#include <cstring>

#include "structures.hpp"

namespace rays {

std::optional<State> state_of(const Hit& hit) {
  if (hit.plain == missed && hit.forced == missed) return transparent;
  if (hit.plain == met_opaque && hit.forced == met_opaque) return opaque;
  if (hit.plain == asked && hit.forced == missed) return unknown_transparent;
  if (hit.plain == asked && hit.forced == met_opaque) return unknown_opaque;
  return std::nullopt;
}

Shooter::Shooter(const Device& device) : device_(device), pipeline_(device) {
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool.queueFamilyIndex = device.family();
  check(vkCreateCommandPool(device.handle(), &pool, nullptr, &pool_), "vkCreateCommandPool");
  VkCommandBufferAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  info.commandPool = pool_;
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device.handle(), &info, &commands_), "vkAllocateCommandBuffers");
  VkFenceCreateInfo fence{};
  fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  check(vkCreateFence(device.handle(), &fence, nullptr, &fence_), "vkCreateFence");
}

Shooter::~Shooter() {
  vkDestroyFence(device_.handle(), fence_, nullptr);
  vkDestroyCommandPool(device_.handle(), pool_, nullptr);
}

std::vector<Hit> Shooter::shoot(const Job& job, const std::vector<Point>& points) {
  std::vector<std::uint32_t> rays;
  for (const Point& point : points)
    for (std::uint32_t triangle = 0; triangle < job.triangles; ++triangle)
      rays.insert(rays.end(), {std::bit_cast<std::uint32_t>(point.u), std::bit_cast<std::uint32_t>(point.v),
                               triangle, 0});
  const auto count = static_cast<std::uint32_t>(rays.size() / 4);
  std::vector<Hit> found(count);
  if (count == 0) return found;
  const Buffer to(device_, rays.size() * sizeof(std::uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true);
  const Buffer from(device_, count * sizeof(Hit), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, true);
  std::memcpy(to.mapped(), rays.data(), rays.size() * sizeof(std::uint32_t));
  std::memset(from.mapped(), 0xff, count * sizeof(Hit));  // a hit that stays unwritten means no state
  run(job, to, from, count);
  std::memcpy(found.data(), from.mapped(), count * sizeof(Hit));
  return found;
}

void Shooter::run(const Job& job, const Buffer& rays, const Buffer& hits, std::uint32_t count) {
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
  const Structures structures(device_, job, commands_);
  pipeline_.bind(structures.scene(), rays.handle(), hits.handle());
  pipeline_.dispatch(commands_, count);
  VkMemoryBarrier seen{};
  seen.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
  seen.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  seen.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(commands_, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                       &seen, 0, nullptr, 0, nullptr);
  check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands_;
  check(vkQueueSubmit(device_.queue(), 1, &submit, fence_), "vkQueueSubmit");
  check(vkWaitForFences(device_.handle(), 1, &fence_, VK_TRUE, UINT64_MAX), "vkWaitForFences");
  check(vkResetFences(device_.handle(), 1, &fence_), "vkResetFences");
}

}  // namespace rays
