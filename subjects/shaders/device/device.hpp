// A Vulkan device for compute, and no more of Vulkan than that needs.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace mmverify::shaders {

/// There is no device, or none that can run this; what() gives the reason.
struct NoDevice : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws std::runtime_error `what: VK_ERROR_...` unless the result is VK_SUCCESS.
void check(VkResult result, const char* what);

/// The properties that a device reports.
struct Properties {
  std::string name, driver, driver_info;
  std::uint32_t number = 0, of = 0;  ///< its number, and the number of devices found
  std::uint32_t api_version = 0, driver_version = 0;
  bool float_controls_known = false;
  VkPhysicalDeviceFloatControlsProperties float_controls{};
  VkPhysicalDeviceLimits limits{};
  VkPhysicalDeviceFeatures features{};
  bool float16 = false, int8 = false;
  bool is_processor = false;         ///< no graphics card: a driver that computes on the processor
  std::uint32_t timestamp_bits = 0;  ///< of the queue's timestamps; 0 if it has none
  std::uint64_t memory_bytes = 0;    ///< of the largest heap of the device's own memory
};

class Device {
 public:
  /// Opens the device of that number: first the devices of the Vulkan loader, then Chromium's SwiftShader.
  /// Throws NoDevice.
  Device(std::uint32_t number, bool validation);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const Properties& properties() const { return properties_; }
  VkDevice handle() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return family_; }
  /// A memory type among `kinds` that this process can map; cached memory if there is any.
  std::uint32_t host_memory(std::uint32_t kinds) const;
  /// A memory type among `kinds` of the device's own memory.
  std::uint32_t own_memory(std::uint32_t kinds) const;

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

/// The device as mmverify_subject_t's runs_on reports it.
std::string runs_on(const Properties& properties, bool validation);

}  // namespace mmverify::shaders
