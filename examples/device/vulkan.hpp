// A Vulkan device that builds opacity micromaps and answers ray queries in compute shaders.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rays {

/// No device has all that rays need; what() names each device and what it lacks.
struct NoDevice : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws std::runtime_error `what: VkResult N` unless the result is VK_SUCCESS.
void check(VkResult result, const char* what);

/// The functions of the extensions, which the loader does not export.
struct Functions {
  PFN_vkCreateMicromapEXT create_micromap = nullptr;
  PFN_vkDestroyMicromapEXT destroy_micromap = nullptr;
  PFN_vkGetMicromapBuildSizesEXT micromap_sizes = nullptr;
  PFN_vkCmdBuildMicromapsEXT build_micromaps = nullptr;
  PFN_vkCreateAccelerationStructureKHR create_structure = nullptr;
  PFN_vkDestroyAccelerationStructureKHR destroy_structure = nullptr;
  PFN_vkGetAccelerationStructureBuildSizesKHR structure_sizes = nullptr;
  PFN_vkGetAccelerationStructureDeviceAddressKHR structure_address = nullptr;
  PFN_vkCmdBuildAccelerationStructuresKHR build_structures = nullptr;
  PFN_vkCmdPipelineBarrier2KHR barrier = nullptr;
};

/// A device's name, driver and limits.
struct About {
  std::string name;
  std::uint32_t most_2_state = 0, most_4_state = 0;  ///< levels
  std::uint32_t scratch_alignment = 1;
};

class Device {
 public:
  /// Opens the device of that number among the loader's, or the first that has all extensions.  `validate` loads the
  /// Khronos validation layer.  Throws NoDevice, or std::runtime_error where Vulkan cannot be used.
  Device(std::optional<std::uint32_t> number, bool validate);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const About& about() const { return about_; }
  const Functions& functions() const { return functions_; }
  VkDevice handle() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t family() const { return family_; }
  /// A memory type among `kinds` with these properties.
  std::uint32_t memory(std::uint32_t kinds, VkMemoryPropertyFlags properties) const;
  /// Number of the validation layer's warnings and errors so far; each went to stderr.
  std::uint32_t messages() const { return messages_; }

 private:
  void make_instance(bool validate);
  void choose(std::optional<std::uint32_t> number);
  void read_limits();
  void make_device();
  void load_functions();

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice chosen_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0, messages_ = 0;
  About about_;
  Functions functions_;
};

/// A buffer with an address on the device; host_visible buffers are mapped.
class Buffer {
 public:
  Buffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, bool host_visible);
  ~Buffer();
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  VkBuffer handle() const { return buffer_; }
  VkDeviceAddress address() const { return address_; }
  void* mapped() const { return mapped_; }

 private:
  const Device& device_;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  VkDeviceAddress address_ = 0;
  void* mapped_ = nullptr;
};

}  // namespace rays
