// Commands for a device, which are recorded, run and waited for.
#pragma once

#include "subjects/shaders/device/device.hpp"

namespace mmverify::shaders {

/// One command buffer. Not thread-safe.
class Commands {
 public:
  explicit Commands(const Device& device);
  ~Commands();
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;

  /// Begins to record; what was recorded before is gone.
  VkCommandBuffer begin();
  /// Runs what was recorded, and waits for its end. Throws std::runtime_error if the device is lost.
  void run();

 private:
  const Device& device_;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer buffer_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
};

}  // namespace mmverify::shaders
