// A storage buffer of a device.
#pragma once

#include <cstddef>

#include "subjects/shaders/device/device.hpp"

namespace mmverify::shaders {

enum class Memory : std::uint8_t {
  host,  ///< mapped by this process
  own,   ///< the device's own, which copies alone reach
};

/// It grows on demand.
class Buffer {
 public:
  explicit Buffer(const Device& device, Memory memory = Memory::host) : device_(device), kind_(memory) {}
  ~Buffer() { free(); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  /// Grows to that many bytes; the content may be lost. Returns whether the Vulkan buffer is a new one.
  bool reserve(std::size_t bytes);
  /// The mapped bytes; null for memory of the device's own.
  void* data() const { return data_; }
  VkBuffer handle() const { return buffer_; }

 private:
  void free();

  const Device& device_;
  const Memory kind_;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace mmverify::shaders
