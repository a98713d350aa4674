// A compute shader on a device, ready for calls.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "subjects/shaders/device/device.hpp"
#include "subjects/shaders/device/manifest.hpp"

namespace mmverify::shaders {

/// A storage buffer in memory that this process maps; it grows on demand.
class Buffer {
 public:
  explicit Buffer(const Device& device) : device_(device) {}
  ~Buffer() { free(); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  /// Grows to that many bytes; the content may be lost. Returns whether the Vulkan buffer is a new one.
  bool reserve(std::size_t bytes);
  void* data() const { return data_; }
  VkBuffer handle() const { return buffer_; }

 private:
  void free();

  const Device& device_;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

/// The inputs of one call to a shader.
struct ShaderInputs {
  std::uint32_t level = 0, first = 0, second = 0;
  std::vector<const void*> arrays = {};  ///< each of `count` 32-bit numbers
  const void* bytes = nullptr;           ///< the code, block or map
  std::size_t byte_count = 0;
  std::size_t count = 0;
  std::size_t values = 1;        ///< words in an answer
  const void* before = nullptr;  ///< the answers' initial content; null if it does not matter
};

/// One compute shader and its buffers. Not thread-safe.
class Program {
 public:
  /// Throws NoDevice if the device lacks a feature of the module, std::runtime_error if the driver refuses
  /// the module.
  Program(const Device& device, const Module& module);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// The words of the answers, valid until the next call. Throws std::runtime_error if the device is lost or
  /// the validation layer reports something.
  const std::uint32_t* run(const ShaderInputs& asked);

 private:
  void make_layout();
  void make_pipeline(const std::vector<std::uint32_t>& words);
  void bind();
  void dispatch(const ShaderInputs& asked);

  const Device& device_;
  const Module module_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkCommandPool commands_ = VK_NULL_HANDLE;
  VkCommandBuffer command_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  std::array<std::unique_ptr<Buffer>, bindings> buffers_;
};

}  // namespace mmverify::shaders
