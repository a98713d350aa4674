// A Vulkan device that computes, and no more of Vulkan than that takes.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace mmverify::shaders {

/// No device, or not one that can run this; what() says why.
struct NoDevice : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws std::runtime_error `what: VK_ERROR_...` unless it is VK_SUCCESS.
void check(VkResult result, const char* what);

/// What the device says of itself.
struct Properties {
  std::string name, driver, driver_info;
  std::uint32_t number = 0, of = 0;  ///< among the devices that were found
  std::uint32_t api_version = 0, driver_version = 0;
  bool float_controls_known = false;
  VkPhysicalDeviceFloatControlsProperties float_controls{};
  VkPhysicalDeviceLimits limits{};
  VkPhysicalDeviceFeatures features{};
  bool float16 = false, int8 = false;
};

class Device {
 public:
  /// The one of this number: those that the Vulkan loader finds, then SwiftShader where Chromium has brought it along.
  /// Throws NoDevice.
  Device(std::uint32_t number, bool validation);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const Properties& properties() const { return properties_; }
  VkDevice handle() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return family_; }
  /// Memory that this process sees, of one of the kinds in the set; cached where there is such.
  std::uint32_t host_memory(std::uint32_t kinds) const;

  /// Throws the first message of the validation layer, if there is one.
  void throw_what_validation_said() const;

 private:
  void make_instance(bool validation);
  void choose(std::uint32_t number);
  void read_properties();
  void make_device();

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice chosen_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t family_ = 0;
  Properties properties_;
  std::string validation_said_;
};

/// Where it runs, as mmverify_subject_t's runs_on has it.
std::string runs_on(const Properties& properties, bool validation);

}  // namespace mmverify::shaders
