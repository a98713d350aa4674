// A compute shader as a pipeline of a device, and the set of its buffers.
#pragma once

#include <array>
#include <vector>

#include "subjects/shaders/device/device.hpp"
#include "subjects/shaders/device/manifest.hpp"

namespace mmverify::shaders {

class Pipeline {
 public:
  /// Throws NoDevice if the device lacks a feature of the module, std::runtime_error if the driver refuses
  /// the module.
  Pipeline(const Device& device, const Module& module);
  ~Pipeline();
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  void bind(const std::array<VkBuffer, bindings>& buffers);
  /// Records a dispatch of constants.count invocations, rounded up to whole workgroups. Throws
  /// std::runtime_error if the device does not take so many.
  void record(VkCommandBuffer command, const PushConstants& constants) const;

 private:
  void make_layout();
  void make_set();
  void make_pipeline(const std::vector<std::uint32_t>& words);

  const Device& device_;
  const Module module_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

}  // namespace mmverify::shaders
