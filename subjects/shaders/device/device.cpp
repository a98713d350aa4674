#include "subjects/shaders/device/device.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <vector>

namespace mmverify::shaders {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";
/// The driver of SwiftShader, a second device in Debian's chromium-common, where the loader does not look.
constexpr const char* swiftshader = "/usr/lib/chromium/vk_swiftshader_icd.json";

/// Calls a function of Vulkan twice, for the count and the elements, until the count stays the same.
template <class T, class Call>
std::vector<T> all(Call call) {
  std::uint32_t count = 0;
  std::vector<T> found;
  VkResult result = VK_INCOMPLETE;
  while (result == VK_INCOMPLETE) {
    check(call(&count, nullptr), "asking Vulkan how many there are");
    found.resize(count);
    result = call(&count, found.data());
  }
  check(result, "asking Vulkan which there are");
  found.resize(count);
  return found;
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* to) {
  auto& said = *static_cast<std::string*>(to);
  std::fprintf(stderr, "validation layer: %s\n", data->pMessage);
  if (said.empty()) said = data->pMessage;
  return VK_FALSE;
}

bool offers(const std::vector<VkExtensionProperties>& extensions, const char* name) {
  return std::any_of(extensions.begin(), extensions.end(),
                     [&](const VkExtensionProperties& e) { return std::strcmp(e.extensionName, name) == 0; });
}

}  // namespace

void check(VkResult result, const char* what) {
  if (result == VK_SUCCESS) return;
  throw std::runtime_error(std::string(what) + ": VkResult " + std::to_string(result));
}

Device::Device(std::uint32_t number, bool validation) {
  make_instance(validation);
  choose(number);
  read_properties();
  make_device();
  throw_what_validation_said();
}

Device::~Device() {
  if (device_ != VK_NULL_HANDLE) vkDestroyDevice(device_, nullptr);
  if (messenger_ != VK_NULL_HANDLE)
    if (const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT")))
      destroy(instance_, messenger_, nullptr);
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

void Device::throw_what_validation_said() const {
  if (!validation_said_.empty()) throw std::runtime_error("validation layer: " + validation_said_);
}

void Device::make_instance(bool validation) {
  const bool chosen = std::getenv("VK_ICD_FILENAMES") != nullptr ||
                      std::getenv("VK_DRIVER_FILES") != nullptr ||
                      std::getenv("VK_ADD_DRIVER_FILES") != nullptr;
  if (std::error_code error; !chosen && std::filesystem::exists(swiftshader, error))
    setenv("VK_ADD_DRIVER_FILES", swiftshader, 1);
  // A worker leaves no files behind.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);

  std::uint32_t version = VK_API_VERSION_1_0;
  if (vkEnumerateInstanceVersion(&version) != VK_SUCCESS || version < VK_API_VERSION_1_1)
    throw NoDevice("the Vulkan loader is older than 1.1");
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "mmverify";
  application.apiVersion = std::min<std::uint32_t>(version, VK_API_VERSION_1_3);

  VkDebugUtilsMessengerCreateInfoEXT messages{};
  messages.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  messages.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messages.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messages.pfnUserCallback = on_message;
  messages.pUserData = &validation_said_;
  const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;

  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  if (validation) {
    info.pNext = &messages;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &validation_layer;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
  }
  switch (const VkResult result = vkCreateInstance(&info, nullptr, &instance_)) {
    case VK_SUCCESS: break;
    case VK_ERROR_LAYER_NOT_PRESENT:
      throw NoDevice("the Vulkan validation layer was asked for and is not there");
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      throw NoDevice("no Vulkan driver is installed (Debian: mesa-vulkan-drivers)");
    default: throw NoDevice("no Vulkan instance: VkResult " + std::to_string(result));
  }
  if (!validation) return;
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  if (create != nullptr) check(create(instance_, &messages, nullptr, &messenger_), "listening to validation");
}

void Device::choose(std::uint32_t number) {
  std::vector<VkPhysicalDevice> devices;
  std::uint32_t count = 0;
  // A loader without any driver returns an error.
  if (vkEnumeratePhysicalDevices(instance_, &count, nullptr) == VK_SUCCESS && count != 0)
    devices = all<VkPhysicalDevice>(
        [&](std::uint32_t* n, VkPhysicalDevice* to) { return vkEnumeratePhysicalDevices(instance_, n, to); });
  // SwiftShader goes last: the loader's order may begin with the driver that was added first.
  std::stable_partition(devices.begin(), devices.end(), [](VkPhysicalDevice d) {
    VkPhysicalDeviceProperties p;
    vkGetPhysicalDeviceProperties(d, &p);
    return std::strstr(p.deviceName, "SwiftShader") == nullptr;
  });
  if (devices.empty()) throw NoDevice("no Vulkan device (Debian: mesa-vulkan-drivers brings one)");
  if (number >= devices.size())
    throw NoDevice("no Vulkan device " + std::to_string(number) + ": there are " +
                   std::to_string(devices.size()) + ", counted from 0");
  chosen_ = devices[number];
  properties_.number = number;
  properties_.of = static_cast<std::uint32_t>(devices.size());
}

void Device::read_properties() {
  VkPhysicalDeviceProperties plain;
  vkGetPhysicalDeviceProperties(chosen_, &plain);
  const auto extensions = all<VkExtensionProperties>([&](std::uint32_t* n, VkExtensionProperties* to) {
    return vkEnumerateDeviceExtensionProperties(chosen_, nullptr, n, to);
  });
  VkPhysicalDeviceFloatControlsProperties floats{};
  floats.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FLOAT_CONTROLS_PROPERTIES;
  VkPhysicalDeviceDriverProperties driver{};
  driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
  VkPhysicalDeviceProperties2 asked{};
  asked.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  const bool newer = plain.apiVersion >= VK_API_VERSION_1_2;
  if (newer || offers(extensions, VK_KHR_DRIVER_PROPERTIES_EXTENSION_NAME)) {
    driver.pNext = asked.pNext;
    asked.pNext = &driver;
  }
  if (newer || offers(extensions, VK_KHR_SHADER_FLOAT_CONTROLS_EXTENSION_NAME)) {
    floats.pNext = asked.pNext;
    asked.pNext = &floats;
    properties_.float_controls_known = true;
  }
  vkGetPhysicalDeviceProperties2(chosen_, &asked);
  floats.pNext = nullptr;
  properties_.name = plain.deviceName;
  properties_.driver = driver.driverName;
  properties_.driver_info = driver.driverInfo;
  properties_.api_version = plain.apiVersion;
  properties_.driver_version = plain.driverVersion;
  properties_.float_controls = floats;
  properties_.limits = plain.limits;
  properties_.is_processor = plain.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(chosen_, &memory);
  for (std::uint32_t k = 0; k < memory.memoryHeapCount; ++k)
    if ((memory.memoryHeaps[k].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0)
      properties_.memory_bytes =
          std::max<std::uint64_t>(properties_.memory_bytes, memory.memoryHeaps[k].size);
  if (plain.apiVersion < VK_API_VERSION_1_1)
    throw NoDevice(properties_.name + " has Vulkan 1.0; 1.1 is what shaders are run with");
}

void Device::make_device() {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(chosen_, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(chosen_, &count, families.data());
  for (family_ = 0; family_ < count; ++family_)
    if ((families[family_].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) break;
  if (family_ == count) throw NoDevice(properties_.name + " does not compute");
  properties_.timestamp_bits = families[family_].timestampValidBits;

  // Enables every number type that the device has.
  VkPhysicalDeviceShaderFloat16Int8Features small{};
  small.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SHADER_FLOAT16_INT8_FEATURES;
  VkPhysicalDeviceFeatures2 has{};
  has.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  const bool newer = properties_.api_version >= VK_API_VERSION_1_2;
  if (newer) has.pNext = &small;
  vkGetPhysicalDeviceFeatures2(chosen_, &has);
  properties_.features = has.features;
  properties_.float16 = small.shaderFloat16 == VK_TRUE;
  properties_.int8 = small.shaderInt8 == VK_TRUE;
  VkPhysicalDeviceFeatures2 wanted{};
  wanted.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  if (newer) wanted.pNext = &small;
  wanted.features.shaderFloat64 = has.features.shaderFloat64;
  wanted.features.shaderInt64 = has.features.shaderInt64;
  wanted.features.shaderInt16 = has.features.shaderInt16;

  const float priority = 1;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &wanted;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  if (const VkResult result = vkCreateDevice(chosen_, &info, nullptr, &device_); result != VK_SUCCESS)
    throw NoDevice(properties_.name + " cannot be opened: VkResult " + std::to_string(result));
  vkGetDeviceQueue(device_, family_, 0, &queue_);
}

namespace {

/// The first memory type among `kinds` with one of these sets of flags, the first set first.
std::optional<std::uint32_t> memory_with(VkPhysicalDevice device, std::uint32_t kinds,
                                         std::initializer_list<VkMemoryPropertyFlags> sets) {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(device, &memory);
  for (const VkMemoryPropertyFlags wanted : sets)
    for (std::uint32_t k = 0; k < memory.memoryTypeCount; ++k)
      if ((kinds >> k & 1u) != 0 && (memory.memoryTypes[k].propertyFlags & wanted) == wanted) return k;
  return std::nullopt;
}

}  // namespace

std::uint32_t Device::host_memory(std::uint32_t kinds) const {
  constexpr VkMemoryPropertyFlags needed =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  if (const auto type = memory_with(chosen_, kinds, {needed | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, needed}))
    return *type;
  throw NoDevice(properties_.name + " has no memory that this process sees");
}

std::uint32_t Device::own_memory(std::uint32_t kinds) const {
  if (const auto type = memory_with(chosen_, kinds, {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT})) return *type;
  throw NoDevice(properties_.name + " has no memory of its own");
}

}  // namespace mmverify::shaders
