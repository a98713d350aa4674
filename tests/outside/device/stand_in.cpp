// A Vulkan driver without a device, for tests of examples/device: memory is this process's, builds run when they are
// submitted, and a dispatch answers as rays.comp does.  No other shader runs.
//
// Validation layers listen to the calls before they arrive here; this driver checks what those cannot see (builds.hpp).
#include <vulkan/vk_icd.h>
#include <vulkan/vulkan.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string_view>

#include "tests/outside/device/builds.hpp"

namespace {

using stand_in::complain;

/// A dispatchable handle, which begins with the loader's own data.
struct Handle {
  VK_LOADER_DATA loader;
  Handle() { set_loader_magic_value(&loader); }
};
struct Commands : Handle {
  std::vector<std::function<void()>> all;
  std::function<void(std::uint32_t)> dispatch;
  std::uint32_t count = 0;
  bool micromaps_visible = false, structures_visible = false;
};
struct Memory {
  std::uint8_t* bytes;
};
struct Buffer {
  VkDeviceSize size;
  VkDeviceAddress address = 0;
};
struct Set {
  const stand_in::Structure* scene = nullptr;
  const Buffer *rays = nullptr, *hits = nullptr;
};

/// Each buffer's address is an odd multiple of this, as those of devices may be.
constexpr VkDeviceSize alignment = 64;
constexpr VkDeviceSize scratch_alignment = 128;
Handle physical, queue_handle;

template <class T, class H>
T* object(H handle) {
  return reinterpret_cast<T*>(handle);
}
template <class T, class H>
VkResult made(T* what, H* to) {
  *to = reinterpret_cast<H>(what);
  return VK_SUCCESS;
}

// ---------------------------------------------------------------------------------------------------------------------
// The device that it says it is
// ---------------------------------------------------------------------------------------------------------------------

constexpr const char* extensions[] = {
    VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME, VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
    VK_KHR_RAY_QUERY_EXTENSION_NAME, VK_KHR_SYNCHRONIZATION_2_EXTENSION_NAME,
    VK_EXT_OPACITY_MICROMAP_EXTENSION_NAME};

VkResult VKAPI_CALL enumerate_extensions(VkPhysicalDevice, const char*, std::uint32_t* count,
                                         VkExtensionProperties* to) {
  const auto most =
      static_cast<std::uint32_t>(std::size(extensions)) - (stand_in::fault("no_extension") ? 1 : 0);
  if (to == nullptr) {
    *count = most;
    return VK_SUCCESS;
  }
  *count = std::min(*count, most);
  for (std::uint32_t k = 0; k < *count; ++k) {
    to[k] = {};
    std::strncpy(to[k].extensionName, extensions[k], sizeof to[k].extensionName - 1);
    to[k].specVersion = 1;
  }
  return *count < most ? VK_INCOMPLETE : VK_SUCCESS;
}

void VKAPI_CALL get_properties(VkPhysicalDevice, VkPhysicalDeviceProperties* to) {
  *to = {};
  to->apiVersion = VK_MAKE_API_VERSION(0, 1, 3, 239);
  to->deviceType = VK_PHYSICAL_DEVICE_TYPE_CPU;
  std::strcpy(to->deviceName, "stand-in");
  VkPhysicalDeviceLimits& most = to->limits;
  most.maxStorageBufferRange = most.maxUniformBufferRange = ~0u;
  most.maxPushConstantsSize = 128;
  most.maxMemoryAllocationCount = 4096;
  most.bufferImageGranularity = most.nonCoherentAtomSize = 1;
  most.minMemoryMapAlignment = 64;
  most.minStorageBufferOffsetAlignment = most.minUniformBufferOffsetAlignment = alignment;
  most.maxBoundDescriptorSets = 4;
  most.maxPerStageDescriptorStorageBuffers = most.maxDescriptorSetStorageBuffers = most.maxPerStageResources =
      64;
  most.maxComputeWorkGroupInvocations = 128;
  for (unsigned k = 0; k < 3; ++k) {
    most.maxComputeWorkGroupCount[k] = 65535;
    most.maxComputeWorkGroupSize[k] = 128;
  }
}

template <class T>
T* as(VkBaseOutStructure* link) {
  return reinterpret_cast<T*>(link);
}

void VKAPI_CALL get_properties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* to) {
  get_properties(device, &to->properties);
  for (auto* link = static_cast<VkBaseOutStructure*>(to->pNext); link != nullptr; link = link->pNext) {
    if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_OPACITY_MICROMAP_PROPERTIES_EXT) {
      auto* levels = as<VkPhysicalDeviceOpacityMicromapPropertiesEXT>(link);
      levels->maxOpacity2StateSubdivisionLevel = 12;
      levels->maxOpacity4StateSubdivisionLevel = 9;
    } else if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR) {
      auto* most = as<VkPhysicalDeviceAccelerationStructurePropertiesKHR>(link);
      most->maxGeometryCount = most->maxInstanceCount = most->maxPrimitiveCount = 1u << 24;
      most->maxPerStageDescriptorAccelerationStructures = most->maxDescriptorSetAccelerationStructures = 16;
      most->maxPerStageDescriptorUpdateAfterBindAccelerationStructures = 16;
      most->maxDescriptorSetUpdateAfterBindAccelerationStructures = 16;
      most->minAccelerationStructureScratchOffsetAlignment = scratch_alignment;
    } else if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES) {
      auto* most = as<VkPhysicalDeviceVulkan12Properties>(link);
      most->maxPerStageDescriptorUpdateAfterBindStorageBuffers = 64;
      most->maxDescriptorSetUpdateAfterBindStorageBuffers = 64;
    } else if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES) {
      std::strcpy(as<VkPhysicalDeviceDriverProperties>(link)->driverName, "no driver");
      std::strcpy(as<VkPhysicalDeviceDriverProperties>(link)->driverInfo, "of a device");
    }
  }
}

void VKAPI_CALL get_features(VkPhysicalDevice, VkPhysicalDeviceFeatures* to) { *to = {}; }

void VKAPI_CALL get_features2(VkPhysicalDevice, VkPhysicalDeviceFeatures2* to) {
  to->features = {};
  for (auto* link = static_cast<VkBaseOutStructure*>(to->pNext); link != nullptr; link = link->pNext) {
    if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_OPACITY_MICROMAP_FEATURES_EXT)
      as<VkPhysicalDeviceOpacityMicromapFeaturesEXT>(link)->micromap = !stand_in::fault("no_feature");
    if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR)
      as<VkPhysicalDeviceRayQueryFeaturesKHR>(link)->rayQuery = VK_TRUE;
    if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR)
      as<VkPhysicalDeviceAccelerationStructureFeaturesKHR>(link)->accelerationStructure = VK_TRUE;
    if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_BUFFER_DEVICE_ADDRESS_FEATURES)
      as<VkPhysicalDeviceBufferDeviceAddressFeatures>(link)->bufferDeviceAddress = VK_TRUE;
    if (link->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES)
      as<VkPhysicalDeviceSynchronization2Features>(link)->synchronization2 = VK_TRUE;
  }
}

void VKAPI_CALL get_memory_properties(VkPhysicalDevice, VkPhysicalDeviceMemoryProperties* to) {
  *to = {};
  to->memoryTypeCount = to->memoryHeapCount = 1;
  to->memoryTypes[0].propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT |
                                     VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                     VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  to->memoryHeaps[0] = {VkDeviceSize{1} << 32, VK_MEMORY_HEAP_DEVICE_LOCAL_BIT};
}
void VKAPI_CALL get_memory_properties2(VkPhysicalDevice device, VkPhysicalDeviceMemoryProperties2* to) {
  get_memory_properties(device, &to->memoryProperties);
}

void VKAPI_CALL get_families(VkPhysicalDevice, std::uint32_t* count, VkQueueFamilyProperties* to) {
  if (to != nullptr && *count != 0) *to = {VK_QUEUE_COMPUTE_BIT | VK_QUEUE_TRANSFER_BIT, 1, 0, {1, 1, 1}};
  *count = 1;
}
void VKAPI_CALL get_families2(VkPhysicalDevice device, std::uint32_t* count, VkQueueFamilyProperties2* to) {
  get_families(device, count, to == nullptr ? nullptr : &to->queueFamilyProperties);
}

VkResult VKAPI_CALL enumerate_devices(VkInstance, std::uint32_t* count, VkPhysicalDevice* to) {
  if (stand_in::fault("enumeration")) return VK_ERROR_OUT_OF_HOST_MEMORY;
  if (to != nullptr && *count != 0) *to = reinterpret_cast<VkPhysicalDevice>(&physical);
  *count = stand_in::fault("no_device") ? 0 : 1;
  return VK_SUCCESS;
}

// ---------------------------------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------------------------------

VkResult VKAPI_CALL allocate(VkDevice, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks*,
                             VkDeviceMemory* to) {
  const VkDeviceSize whole = 4 * alignment,
                     size = (alignment + info->allocationSize + whole - 1) / whole * whole;
  auto* const bytes = static_cast<std::uint8_t*>(std::aligned_alloc(whole, size));
  std::memset(bytes, 0xff, size);  // what nobody wrote is the same in each run
  return made(new Memory{bytes + alignment}, to);
}
void VKAPI_CALL free_memory(VkDevice, VkDeviceMemory memory, const VkAllocationCallbacks*) {
  if (memory == VK_NULL_HANDLE) return;
  std::free(object<Memory>(memory)->bytes - alignment);
  delete object<Memory>(memory);
}
VkResult VKAPI_CALL map(VkDevice, VkDeviceMemory memory, VkDeviceSize offset, VkDeviceSize, VkMemoryMapFlags,
                        void** to) {
  *to = object<Memory>(memory)->bytes + offset;
  return VK_SUCCESS;
}
VkResult VKAPI_CALL create_buffer(VkDevice, const VkBufferCreateInfo* info, const VkAllocationCallbacks*,
                                  VkBuffer* to) {
  return made(new Buffer{info->size}, to);
}
void VKAPI_CALL destroy_buffer(VkDevice, VkBuffer buffer, const VkAllocationCallbacks*) {
  if (buffer != VK_NULL_HANDLE) stand_in::buffers().erase(object<Buffer>(buffer)->address);
  delete object<Buffer>(buffer);
}
void VKAPI_CALL buffer_needs(VkDevice, VkBuffer buffer, VkMemoryRequirements* to) {
  *to = {object<Buffer>(buffer)->size, alignment, 1};
}
VkResult VKAPI_CALL bind(VkDevice, VkBuffer buffer, VkDeviceMemory memory, VkDeviceSize offset) {
  auto& bound = *object<Buffer>(buffer);
  bound.address = reinterpret_cast<VkDeviceAddress>(object<Memory>(memory)->bytes + offset);
  stand_in::buffers()[bound.address] = bound.size;
  return VK_SUCCESS;
}
VkDeviceAddress VKAPI_CALL buffer_address(VkDevice, const VkBufferDeviceAddressInfo* info) {
  return object<Buffer>(info->buffer)->address;
}

// ---------------------------------------------------------------------------------------------------------------------
// Shaders and what they are bound to
// ---------------------------------------------------------------------------------------------------------------------

/// Objects of which nothing is kept.
template <class Info, class H>
VkResult VKAPI_CALL create(VkDevice, const Info*, const VkAllocationCallbacks*, H* to) {
  return made(new char, to);
}
template <class H>
void VKAPI_CALL destroy(VkDevice, H handle, const VkAllocationCallbacks*) {
  delete object<char>(handle);
}

VkResult VKAPI_CALL create_shader(VkDevice, const VkShaderModuleCreateInfo* info,
                                  const VkAllocationCallbacks*, VkShaderModule* to) {
  constexpr std::uint32_t capability = 2u << 16 | 17,
                          micromaps = 5381;  // OpCapability RayTracingOpacityMicromapEXT
  bool found = false;
  for (std::size_t k = 5; k + 1 < info->codeSize / 4 && info->pCode[k] >> 16 != 0; k += info->pCode[k] >> 16)
    found |= info->pCode[k] == capability && info->pCode[k + 1] == micromaps;
  if (!found) complain("the shader forces micromaps to two states without the capability");
  return made(new char, to);
}
VkResult VKAPI_CALL create_pipelines(VkDevice, VkPipelineCache, std::uint32_t count,
                                     const VkComputePipelineCreateInfo*, const VkAllocationCallbacks*,
                                     VkPipeline* to) {
  for (std::uint32_t k = 0; k < count; ++k) made(new char, to + k);
  return VK_SUCCESS;
}
VkResult VKAPI_CALL allocate_sets(VkDevice, const VkDescriptorSetAllocateInfo*, VkDescriptorSet* to) {
  static Set only;
  return made(&only, to);
}
void VKAPI_CALL update_sets(VkDevice, std::uint32_t count, const VkWriteDescriptorSet* writes, std::uint32_t,
                            const VkCopyDescriptorSet*) {
  for (const auto* w = writes; w != writes + count; ++w) {
    Set& set = *object<Set>(w->dstSet);
    if (w->dstBinding == 0)
      set.scene = object<stand_in::Structure>(
          static_cast<const VkWriteDescriptorSetAccelerationStructureKHR*>(w->pNext)
              ->pAccelerationStructures[0]);
    else
      (w->dstBinding == 1 ? set.rays : set.hits) = object<Buffer>(w->pBufferInfo->buffer);
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// Commands
// ---------------------------------------------------------------------------------------------------------------------

VkResult VKAPI_CALL allocate_commands(VkDevice, const VkCommandBufferAllocateInfo*, VkCommandBuffer* to) {
  static Commands only;
  return made(&only, to);
}
VkResult VKAPI_CALL begin(VkCommandBuffer commands, const VkCommandBufferBeginInfo*) {
  auto& c = *object<Commands>(commands);
  c.all.clear();
  c.micromaps_visible = c.structures_visible = false;
  return VK_SUCCESS;
}
VkResult VKAPI_CALL end(VkCommandBuffer) { return VK_SUCCESS; }
void VKAPI_CALL bind_pipeline(VkCommandBuffer, VkPipelineBindPoint, VkPipeline) {}
void VKAPI_CALL bind_sets(VkCommandBuffer commands, VkPipelineBindPoint, VkPipelineLayout, std::uint32_t,
                          std::uint32_t, const VkDescriptorSet* sets, std::uint32_t, const std::uint32_t*) {
  object<Commands>(commands)->dispatch = [set = object<Set>(*sets)](std::uint32_t count) {
    if (stand_in::fault("unwritten")) return;
    for (std::uint32_t k = 0; k < count; ++k) {
      std::array<std::uint32_t, 4> ray;
      const auto* from = stand_in::bytes_at(set->rays->address + k * sizeof ray, sizeof ray, "rays");
      const auto* to = stand_in::bytes_at(set->hits->address + k * sizeof ray, sizeof ray, "hits");
      if (from == nullptr || to == nullptr) return;
      std::memcpy(&ray, from, sizeof ray);
      ray = stand_in::answer(*set->scene, ray);
      std::memcpy(const_cast<std::uint8_t*>(to), &ray, sizeof ray);
    }
  };
}
void VKAPI_CALL push(VkCommandBuffer commands, VkPipelineLayout, VkShaderStageFlags, std::uint32_t,
                     std::uint32_t, const void* from) {
  std::memcpy(&object<Commands>(commands)->count, from, sizeof(std::uint32_t));
}
void VKAPI_CALL dispatch(VkCommandBuffer commands, std::uint32_t groups, std::uint32_t, std::uint32_t) {
  auto& c = *object<Commands>(commands);
  c.all.push_back([&c, groups] {
    if (!c.structures_visible) complain("rays are shot before the scene's build is visible");
    c.dispatch(std::min(c.count, 64 * groups));
  });
}
void VKAPI_CALL barrier(VkCommandBuffer, VkPipelineStageFlags, VkPipelineStageFlags, VkDependencyFlags,
                        std::uint32_t, const VkMemoryBarrier*, std::uint32_t, const VkBufferMemoryBarrier*,
                        std::uint32_t, const VkImageMemoryBarrier*) {}
void VKAPI_CALL barrier2(VkCommandBuffer commands, const VkDependencyInfo* info) {
  auto& c = *object<Commands>(commands);
  for (std::uint32_t k = 0; k < info->memoryBarrierCount; ++k)
    c.all.push_back([&c, barrier = info->pMemoryBarriers[k]] {
      c.micromaps_visible |= (barrier.srcAccessMask & VK_ACCESS_2_MICROMAP_WRITE_BIT_EXT) != 0 &&
                             (barrier.dstAccessMask & VK_ACCESS_2_MICROMAP_READ_BIT_EXT) != 0;
      c.structures_visible |=
          (barrier.srcAccessMask & VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR) != 0 &&
          (barrier.dstAccessMask & VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR) != 0;
    });
}
VkResult VKAPI_CALL submit(VkQueue, std::uint32_t count, const VkSubmitInfo* infos, VkFence) {
  for (std::uint32_t k = 0; k < count; ++k)
    for (std::uint32_t b = 0; b < infos[k].commandBufferCount; ++b)
      for (const auto& command : object<Commands>(infos[k].pCommandBuffers[b])->all) {
        command();
        if (stand_in::complained()) return VK_ERROR_DEVICE_LOST;
      }
  return VK_SUCCESS;
}
VkResult VKAPI_CALL wait(VkDevice, std::uint32_t, const VkFence*, VkBool32, std::uint64_t) {
  return VK_SUCCESS;
}
VkResult VKAPI_CALL reset(VkDevice, std::uint32_t, const VkFence*) { return VK_SUCCESS; }

// ---------------------------------------------------------------------------------------------------------------------
// Micromaps and acceleration structures
// ---------------------------------------------------------------------------------------------------------------------

VkResult VKAPI_CALL create_micromap(VkDevice, const VkMicromapCreateInfoEXT*, const VkAllocationCallbacks*,
                                    VkMicromapEXT* to) {
  return made(new stand_in::Micromap, to);
}
void VKAPI_CALL destroy_micromap(VkDevice, VkMicromapEXT micromap, const VkAllocationCallbacks*) {
  delete object<stand_in::Micromap>(micromap);
}
void VKAPI_CALL micromap_sizes(VkDevice, VkAccelerationStructureBuildTypeKHR, const VkMicromapBuildInfoEXT*,
                               VkMicromapBuildSizesInfoEXT* to) {
  to->micromapSize = to->buildScratchSize = 4096;
  to->discardable = VK_FALSE;
}
void VKAPI_CALL build_micromaps(VkCommandBuffer commands, std::uint32_t count,
                                const VkMicromapBuildInfoEXT* infos) {
  for (std::uint32_t k = 0; k < count; ++k)
    object<Commands>(commands)->all.push_back(
        [input = stand_in::MicromapInput{
             infos[k], {infos[k].pUsageCounts, infos[k].pUsageCounts + infos[k].usageCountsCount}}] {
          stand_in::need_multiple(input.info.scratchData.deviceAddress, scratch_alignment, "scratch memory");
          stand_in::build(input, *object<stand_in::Micromap>(input.info.dstMicromap));
        });
}

VkResult VKAPI_CALL create_structure(VkDevice, const VkAccelerationStructureCreateInfoKHR*,
                                     const VkAllocationCallbacks*, VkAccelerationStructureKHR* to) {
  return made(new stand_in::Structure, to);
}
void VKAPI_CALL destroy_structure(VkDevice, VkAccelerationStructureKHR structure,
                                  const VkAllocationCallbacks*) {
  delete object<stand_in::Structure>(structure);
}
void VKAPI_CALL structure_sizes(VkDevice, VkAccelerationStructureBuildTypeKHR,
                                const VkAccelerationStructureBuildGeometryInfoKHR*, const std::uint32_t*,
                                VkAccelerationStructureBuildSizesInfoKHR* to) {
  to->accelerationStructureSize = to->buildScratchSize = to->updateScratchSize = 4096;
}
VkDeviceAddress VKAPI_CALL structure_address(VkDevice,
                                             const VkAccelerationStructureDeviceAddressInfoKHR* info) {
  return reinterpret_cast<VkDeviceAddress>(object<stand_in::Structure>(info->accelerationStructure));
}

void build_instances(VkDeviceAddress at, stand_in::Structure& to) {
  VkAccelerationStructureInstanceKHR instance;
  stand_in::need_multiple(at, 16, "instances");  // VUID-vkCmdBuildAccelerationStructuresKHR-pInfos-03715
  if (const auto* from = stand_in::bytes_at(at, sizeof instance, "instances")) {
    std::memcpy(&instance, from, sizeof instance);
    to.instance = reinterpret_cast<const stand_in::Structure*>(instance.accelerationStructureReference);
  }
}
void build_triangles(const Commands& c, const stand_in::GeometryInput& input, stand_in::Structure& to) {
  const auto& micromap = *object<stand_in::Micromap>(input.opacity.micromap);
  if (!micromap.built || !c.micromaps_visible)
    return complain("the geometry is built before its micromap is visible");
  stand_in::build(input, micromap, to);
}
void VKAPI_CALL build_structures(VkCommandBuffer commands, std::uint32_t count,
                                 const VkAccelerationStructureBuildGeometryInfoKHR* infos,
                                 const VkAccelerationStructureBuildRangeInfoKHR* const* ranges) {
  auto& c = *object<Commands>(commands);
  for (std::uint32_t k = 0; k < count; ++k) {
    auto& to = *object<stand_in::Structure>(infos[k].dstAccelerationStructure);
    const auto& geometry = infos[k].pGeometries[0].geometry;
    c.all.push_back([at = infos[k].scratchData.deviceAddress] {
      stand_in::need_multiple(at, scratch_alignment, "scratch memory");
    });
    if (infos[k].type == VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR) {
      c.all.push_back([at = geometry.instances.data.deviceAddress, &to] { build_instances(at, to); });
      continue;
    }
    stand_in::GeometryInput input{geometry.triangles, {}, {}, ranges[k][0].primitiveCount};
    input.opacity =
        *static_cast<const VkAccelerationStructureTrianglesOpacityMicromapEXT*>(geometry.triangles.pNext);
    input.counts.assign(input.opacity.pUsageCounts,
                        input.opacity.pUsageCounts + input.opacity.usageCountsCount);
    c.all.push_back([&c, input, &to] { build_triangles(c, input, to); });
  }
}

// ---------------------------------------------------------------------------------------------------------------------
// The loader's side
// ---------------------------------------------------------------------------------------------------------------------

VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo*, const VkAllocationCallbacks*,
                                    VkInstance* to) {
  return made(new Handle, to);
}
void VKAPI_CALL destroy_instance(VkInstance instance, const VkAllocationCallbacks*) {
  delete object<Handle>(instance);
}
VkResult VKAPI_CALL no_instance_extensions(const char*, std::uint32_t* count, VkExtensionProperties*) {
  *count = 0;
  return VK_SUCCESS;
}
VkResult VKAPI_CALL instance_version(std::uint32_t* version) {
  *version = VK_MAKE_API_VERSION(0, 1, 3, 239);
  return VK_SUCCESS;
}
VkResult VKAPI_CALL create_device(VkPhysicalDevice, const VkDeviceCreateInfo*, const VkAllocationCallbacks*,
                                  VkDevice* to) {
  return made(new Handle, to);
}
void VKAPI_CALL destroy_device(VkDevice device, const VkAllocationCallbacks*) {
  delete object<Handle>(device);
}
void VKAPI_CALL get_queue(VkDevice, std::uint32_t, std::uint32_t, VkQueue* to) { made(&queue_handle, to); }
/// Stands for what the loader asks for and no test calls: images, formats, sparse memory.
void VKAPI_CALL never() { std::abort(); }

PFN_vkVoidFunction VKAPI_CALL find(const char* name);
PFN_vkVoidFunction VKAPI_CALL find_in_instance(VkInstance, const char* name) { return find(name); }
PFN_vkVoidFunction VKAPI_CALL find_in_device(VkDevice, const char* name) { return find(name); }

struct Row {
  std::string_view name;
  PFN_vkVoidFunction function;
};

template <class F>
Row row(std::string_view name, F* function) {
  return {name, reinterpret_cast<PFN_vkVoidFunction>(function)};
}

const Row of_instances[] = {
    row("vkGetInstanceProcAddr", find_in_instance),
    row("vkGetDeviceProcAddr", find_in_device),
    row("vkCreateInstance", create_instance),
    row("vkDestroyInstance", destroy_instance),
    row("vkEnumerateInstanceExtensionProperties", no_instance_extensions),
    row("vkEnumerateInstanceVersion", instance_version),
    row("vkEnumeratePhysicalDevices", enumerate_devices),
    row("vkEnumerateDeviceExtensionProperties", enumerate_extensions),
    row("vkGetPhysicalDeviceProperties", get_properties),
    row("vkGetPhysicalDeviceProperties2", get_properties2),
    row("vkGetPhysicalDeviceFeatures", get_features),
    row("vkGetPhysicalDeviceFeatures2", get_features2),
    row("vkGetPhysicalDeviceMemoryProperties", get_memory_properties),
    row("vkGetPhysicalDeviceMemoryProperties2", get_memory_properties2),
    row("vkGetPhysicalDeviceQueueFamilyProperties", get_families),
    row("vkGetPhysicalDeviceQueueFamilyProperties2", get_families2),
    row("vkGetPhysicalDeviceFormatProperties", never),
    row("vkGetPhysicalDeviceImageFormatProperties", never),
    row("vkGetPhysicalDeviceSparseImageFormatProperties", never),
};

const Row of_devices[] = {
    row("vkCreateDevice", create_device),
    row("vkDestroyDevice", destroy_device),
    row("vkGetDeviceQueue", get_queue),
    row("vkAllocateMemory", allocate),
    row("vkFreeMemory", free_memory),
    row("vkMapMemory", map),
    row("vkCreateBuffer", create_buffer),
    row("vkDestroyBuffer", destroy_buffer),
    row("vkGetBufferMemoryRequirements", buffer_needs),
    row("vkBindBufferMemory", bind),
    row("vkGetBufferDeviceAddress", buffer_address),
    row("vkCreateDescriptorSetLayout", create<VkDescriptorSetLayoutCreateInfo, VkDescriptorSetLayout>),
    row("vkDestroyDescriptorSetLayout", destroy<VkDescriptorSetLayout>),
    row("vkCreateDescriptorPool", create<VkDescriptorPoolCreateInfo, VkDescriptorPool>),
    row("vkDestroyDescriptorPool", destroy<VkDescriptorPool>),
    row("vkAllocateDescriptorSets", allocate_sets),
    row("vkUpdateDescriptorSets", update_sets),
    row("vkCreatePipelineLayout", create<VkPipelineLayoutCreateInfo, VkPipelineLayout>),
    row("vkDestroyPipelineLayout", destroy<VkPipelineLayout>),
    row("vkCreateShaderModule", create_shader),
    row("vkDestroyShaderModule", destroy<VkShaderModule>),
    row("vkCreateComputePipelines", create_pipelines),
    row("vkDestroyPipeline", destroy<VkPipeline>),
    row("vkCreateCommandPool", create<VkCommandPoolCreateInfo, VkCommandPool>),
    row("vkDestroyCommandPool", destroy<VkCommandPool>),
    row("vkAllocateCommandBuffers", allocate_commands),
    row("vkBeginCommandBuffer", begin),
    row("vkEndCommandBuffer", end),
    row("vkCmdBindPipeline", bind_pipeline),
    row("vkCmdBindDescriptorSets", bind_sets),
    row("vkCmdPushConstants", push),
    row("vkCmdDispatch", dispatch),
    row("vkCmdPipelineBarrier", barrier),
    row("vkCmdPipelineBarrier2KHR", barrier2),
    row("vkCreateFence", create<VkFenceCreateInfo, VkFence>),
    row("vkDestroyFence", destroy<VkFence>),
    row("vkWaitForFences", wait),
    row("vkResetFences", reset),
    row("vkQueueSubmit", submit),
    row("vkCreateMicromapEXT", create_micromap),
    row("vkDestroyMicromapEXT", destroy_micromap),
    row("vkGetMicromapBuildSizesEXT", micromap_sizes),
    row("vkCmdBuildMicromapsEXT", build_micromaps),
    row("vkCreateAccelerationStructureKHR", create_structure),
    row("vkDestroyAccelerationStructureKHR", destroy_structure),
    row("vkGetAccelerationStructureBuildSizesKHR", structure_sizes),
    row("vkGetAccelerationStructureDeviceAddressKHR", structure_address),
    row("vkCmdBuildAccelerationStructuresKHR", build_structures),
};

PFN_vkVoidFunction VKAPI_CALL find(const char* name) {
  for (const Row& r : of_instances)
    if (r.name == name) return r.function;
  for (const Row& r : of_devices)
    if (r.name == name) return r.function;
  return nullptr;
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) PFN_vkVoidFunction VKAPI_CALL
vk_icdGetInstanceProcAddr(VkInstance, const char* name) {
  return find(name);
}

__attribute__((visibility("default"))) VkResult VKAPI_CALL
vk_icdNegotiateLoaderICDInterfaceVersion(std::uint32_t* version) {
  *version = std::min<std::uint32_t>(*version, 3);
  return VK_SUCCESS;
}
}
