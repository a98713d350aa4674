// The micromap of a job, the geometry that refers to it, and an instance of that: three builds, one after another.
#pragma once

#include <memory>

#include "job.hpp"
#include "vulkan.hpp"

namespace rays {

class Structures {
 public:
  /// Uploads the job's buffers and records the builds, a barrier behind each.  It must outlive the commands' end.
  Structures(const Device& device, const Job& job, VkCommandBuffer commands);
  ~Structures();
  Structures(const Structures&) = delete;
  Structures& operator=(const Structures&) = delete;

  VkAccelerationStructureKHR scene() const { return scene_; }

 private:
  void build_micromap(const Job& job);
  void build_geometry(const Job& job);
  void build_scene();
  /// Creates a structure and records its build.
  void build_structure(VkAccelerationStructureTypeKHR type,
                       const VkAccelerationStructureGeometryKHR& geometry, std::uint32_t primitives,
                       VkAccelerationStructureKHR& to);
  void wait(VkPipelineStageFlags2 stage, VkAccessFlags2 written, VkPipelineStageFlags2 next,
            VkAccessFlags2 read) const;
  /// The address of a copy of these bytes on the device, a multiple of what each build's input needs.
  VkDeviceAddress input(const void* bytes, std::size_t size, VkBufferUsageFlags usage);
  const Buffer& own(VkDeviceSize size, VkBufferUsageFlags usage);
  /// An address in a new buffer of scratch memory.
  VkDeviceAddress scratch(VkDeviceSize size);

  const Device& device_;
  VkCommandBuffer commands_;
  std::vector<std::unique_ptr<Buffer>> buffers_;
  VkMicromapEXT micromap_ = VK_NULL_HANDLE;
  VkAccelerationStructureKHR geometry_ = VK_NULL_HANDLE, scene_ = VK_NULL_HANDLE;
};

}  // namespace rays
