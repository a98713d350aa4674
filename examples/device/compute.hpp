// The compute shader rays.comp as a pipeline with its one descriptor set.
#pragma once

#include "vulkan.hpp"

namespace rays {

class Pipeline {
 public:
  explicit Pipeline(const Device& device);
  ~Pipeline();
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  /// The scene, the rays and the place of the hits.
  void bind(VkAccelerationStructureKHR scene, VkBuffer rays, VkBuffer hits);
  /// Records a thread for each of `count` rays.
  void dispatch(VkCommandBuffer commands, std::uint32_t count) const;

 private:
  void make_set();
  void make_pipeline();

  const Device& device_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace rays
