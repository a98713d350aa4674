#include "vulkan.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace rays {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";
constexpr std::array extensions = {VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME,
                                   VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
                                   VK_KHR_RAY_QUERY_EXTENSION_NAME, VK_KHR_SYNCHRONIZATION_2_EXTENSION_NAME,
                                   VK_EXT_OPACITY_MICROMAP_EXTENSION_NAME};

/// The features that rays need, as a chain for asking and for enabling.
struct Features {
  VkPhysicalDeviceOpacityMicromapFeaturesEXT micromap{};
  VkPhysicalDeviceSynchronization2Features barriers{};
  VkPhysicalDeviceRayQueryFeaturesKHR query{};
  VkPhysicalDeviceAccelerationStructureFeaturesKHR structure{};
  VkPhysicalDeviceBufferDeviceAddressFeatures address{};
  VkPhysicalDeviceFeatures2 all{};

  Features() {
    micromap.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_OPACITY_MICROMAP_FEATURES_EXT;
    barriers = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES, &micromap, VK_FALSE};
    query = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR, &barriers, VK_FALSE};
    structure.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR;
    structure.pNext = &query;
    address.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES;
    address.pNext = &structure;
    all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    all.pNext = &address;
  }
  Features(const Features&) = delete;
  Features& operator=(const Features&) = delete;

  void enable() {
    micromap.micromap = barriers.synchronization2 = query.rayQuery = VK_TRUE;
    structure.accelerationStructure = address.bufferDeviceAddress = VK_TRUE;
  }
};

/// The elements that a function of Vulkan counts first and then writes.
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
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* count) {
  ++*static_cast<std::uint32_t*>(count);
  std::fprintf(stderr, "validation layer: %s\n", data->pMessage);
  return VK_FALSE;
}

std::optional<std::uint32_t> compute_family(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  for (std::uint32_t k = 0; k < count; ++k)
    if ((families[k].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) return k;
  return std::nullopt;
}

/// The extensions and features that a device lacks, with commas between; empty where it has them all.
std::string lacks(VkPhysicalDevice device, const VkPhysicalDeviceProperties& properties) {
  std::string found;
  const auto add = [&](const std::string& name) { found += (found.empty() ? "" : ", ") + name; };
  if (properties.apiVersion < VK_API_VERSION_1_2) add("Vulkan 1.2");
  const auto offered = all<VkExtensionProperties>([&](std::uint32_t* n, VkExtensionProperties* to) {
    return vkEnumerateDeviceExtensionProperties(device, nullptr, n, to);
  });
  for (const char* name : extensions)
    if (std::none_of(offered.begin(), offered.end(),
                     [&](const VkExtensionProperties& e) { return std::strcmp(e.extensionName, name) == 0; }))
      add(name);
  if (!compute_family(device)) add("a queue that computes");
  if (!found.empty()) return found;
  Features has;
  vkGetPhysicalDeviceFeatures2(device, &has.all);
  if (has.micromap.micromap == VK_FALSE) add("feature micromap");
  if (has.query.rayQuery == VK_FALSE) add("feature rayQuery");
  if (has.structure.accelerationStructure == VK_FALSE) add("feature accelerationStructure");
  if (has.address.bufferDeviceAddress == VK_FALSE) add("feature bufferDeviceAddress");
  if (has.barriers.synchronization2 == VK_FALSE) add("feature synchronization2");
  return found;
}

}  // namespace

void check(VkResult result, const char* what) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(std::string(what) + ": VkResult " + std::to_string(result));
}

Device::Device(std::optional<std::uint32_t> number, bool validate) {
  make_instance(validate);
  choose(number);
  read_limits();
  make_device();
  load_functions();
}

Device::~Device() {
  if (device_ != VK_NULL_HANDLE) vkDestroyDevice(device_, nullptr);
  if (messenger_ != VK_NULL_HANDLE)
    if (const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT")))
      destroy(instance_, messenger_, nullptr);
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

void Device::make_instance(bool validate) {
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "device_rays";
  application.apiVersion = VK_API_VERSION_1_2;
  VkDebugUtilsMessengerCreateInfoEXT messages{};
  messages.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  messages.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messages.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messages.pfnUserCallback = on_message;
  messages.pUserData = &messages_;
  const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  if (validate) {
    info.pNext = &messages;
    info.enabledLayerCount = info.enabledExtensionCount = 1;
    info.ppEnabledLayerNames = &validation_layer;
    info.ppEnabledExtensionNames = &extension;
  }
  const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
  if (result == VK_ERROR_LAYER_NOT_PRESENT)
    throw std::runtime_error(
        "the Khronos validation layer is not installed (Debian: vulkan-validationlayers)");
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) throw NoDevice("no Vulkan driver is installed");
  check(result, "vkCreateInstance");
  if (!validate) return;
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  if (create != nullptr)
    check(create(instance_, &messages, nullptr, &messenger_), "vkCreateDebugUtilsMessengerEXT");
}

void Device::choose(std::optional<std::uint32_t> number) {
  std::vector<VkPhysicalDevice> devices;
  std::uint32_t count = 0;
  const VkResult result = vkEnumeratePhysicalDevices(instance_, &count, nullptr);
  if (result != VK_ERROR_INITIALIZATION_FAILED)  // so the loader calls the lack of any device
    check(result, "vkEnumeratePhysicalDevices");
  if (count != 0)
    devices = all<VkPhysicalDevice>(
        [&](std::uint32_t* n, VkPhysicalDevice* to) { return vkEnumeratePhysicalDevices(instance_, n, to); });
  std::string seen;
  for (std::uint32_t k = 0; k < devices.size() && chosen_ == VK_NULL_HANDLE; ++k) {
    if (number && *number != k) continue;
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(devices[k], &properties);
    const std::string missing = lacks(devices[k], properties);
    if (missing.empty()) chosen_ = devices[k];
    const std::string name = properties.deviceName;
    if (number)
      seen = "device " + std::to_string(k) + ", " + name + ", lacks " + missing;
    else
      seen += "\n  " + std::to_string(k) + "  " + name + ": lacks " + missing;
  }
  if (chosen_ != VK_NULL_HANDLE) return;
  if (devices.empty()) throw NoDevice("Vulkan has no device here");
  if (number && *number >= devices.size())
    throw NoDevice("no device " + std::to_string(*number) + ": Vulkan has " + std::to_string(devices.size()) +
                   ", counted from 0");
  if (number) throw NoDevice(seen);
  throw NoDevice("no device here can shoot rays at opacity micromaps:" + seen);
}

void Device::read_limits() {
  VkPhysicalDeviceOpacityMicromapPropertiesEXT levels{};
  levels.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_OPACITY_MICROMAP_PROPERTIES_EXT;
  VkPhysicalDeviceAccelerationStructurePropertiesKHR structure{};
  structure.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR;
  structure.pNext = &levels;
  VkPhysicalDeviceDriverProperties driver{};
  driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
  driver.pNext = &structure;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &driver;
  vkGetPhysicalDeviceProperties2(chosen_, &properties);
  about_.name =
      std::string(properties.properties.deviceName) + ", " + driver.driverName + " " + driver.driverInfo;
  about_.most_2_state = levels.maxOpacity2StateSubdivisionLevel;
  about_.most_4_state = levels.maxOpacity4StateSubdivisionLevel;
  about_.scratch_alignment = std::max(structure.minAccelerationStructureScratchOffsetAlignment, 1u);
}

void Device::make_device() {
  family_ = *compute_family(chosen_);
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  Features wanted;
  wanted.enable();
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &wanted.all;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  check(vkCreateDevice(chosen_, &info, nullptr, &device_), "vkCreateDevice");
  vkGetDeviceQueue(device_, family_, 0, &queue_);
}

void Device::load_functions() {
  const auto load = [&](auto& to, const char* name) {
    to = reinterpret_cast<std::remove_reference_t<decltype(to)>>(vkGetDeviceProcAddr(device_, name));
    if (to == nullptr) throw std::runtime_error(std::string("the driver has no ") + name);
  };
  load(functions_.create_micromap, "vkCreateMicromapEXT");
  load(functions_.destroy_micromap, "vkDestroyMicromapEXT");
  load(functions_.micromap_sizes, "vkGetMicromapBuildSizesEXT");
  load(functions_.build_micromaps, "vkCmdBuildMicromapsEXT");
  load(functions_.create_structure, "vkCreateAccelerationStructureKHR");
  load(functions_.destroy_structure, "vkDestroyAccelerationStructureKHR");
  load(functions_.structure_sizes, "vkGetAccelerationStructureBuildSizesKHR");
  load(functions_.structure_address, "vkGetAccelerationStructureDeviceAddressKHR");
  load(functions_.build_structures, "vkCmdBuildAccelerationStructuresKHR");
  load(functions_.barrier, "vkCmdPipelineBarrier2KHR");
}

std::uint32_t Device::memory(std::uint32_t kinds, VkMemoryPropertyFlags properties) const {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(chosen_, &memory);
  for (std::uint32_t k = 0; k < memory.memoryTypeCount; ++k)
    if ((kinds >> k & 1u) != 0 && (memory.memoryTypes[k].propertyFlags & properties) == properties) return k;
  throw std::runtime_error(about_.name + " has no memory of the kind that a buffer needs");
}

Buffer::Buffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage, bool host_visible)
    : device_(device) {
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = std::max<VkDeviceSize>(size, 1);
  info.usage = usage | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
  check(vkCreateBuffer(device.handle(), &info, nullptr, &buffer_), "vkCreateBuffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device.handle(), buffer_, &needs);
  VkMemoryAllocateFlagsInfo flags{};
  flags.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO;
  flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
  VkMemoryAllocateInfo memory{};
  memory.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  memory.pNext = &flags;
  memory.allocationSize = needs.size;
  memory.memoryTypeIndex =
      device.memory(needs.memoryTypeBits,
                    host_visible ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                                 : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkAllocateMemory(device.handle(), &memory, nullptr, &memory_), "vkAllocateMemory");
  check(vkBindBufferMemory(device.handle(), buffer_, memory_, 0), "vkBindBufferMemory");
  if (host_visible)
    check(vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped_), "vkMapMemory");
  VkBufferDeviceAddressInfo address{};
  address.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO;
  address.buffer = buffer_;
  address_ = vkGetBufferDeviceAddress(device.handle(), &address);
}

Buffer::~Buffer() {
  vkDestroyBuffer(device_.handle(), buffer_, nullptr);
  vkFreeMemory(device_.handle(), memory_, nullptr);
}

}  // namespace rays
