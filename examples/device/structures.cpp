#include "structures.hpp"

#include <algorithm>
#include <cstring>

namespace rays {
namespace {

/// The most that Vulkan asks of an address: 256 of a micromap's records and data (VUID-vkCmdBuildMicromapsEXT-pInfos-07515),
/// 16 of instances (VUID-vkCmdBuildAccelerationStructuresKHR-pInfos-03715), the component's size of vertices.
constexpr VkDeviceSize input_alignment = 256;

constexpr VkBufferUsageFlags build_input =
    VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;
constexpr VkBufferUsageFlags micromap_input = VK_BUFFER_USAGE_MICROMAP_BUILD_INPUT_READ_ONLY_BIT_EXT;

std::uint32_t count_of(const auto& elements) { return static_cast<std::uint32_t>(elements.size()); }

VkDeviceAddress rounded_up(VkDeviceAddress at, VkDeviceSize alignment) {
  return (at + alignment - 1) / alignment * alignment;
}

/// Corners (0,0,z), (1,0,z), (0,1,z) of each triangle z: there barycentrics are the coordinates x and y.
std::vector<float> corners(std::uint32_t triangles) {
  std::vector<float> found;
  for (std::uint32_t k = 0; k < triangles; ++k) {
    const float z = static_cast<float>(k);
    found.insert(found.end(), {0, 0, z, 1, 0, z, 0, 1, z});
  }
  return found;
}

}  // namespace

Structures::Structures(const Device& device, const Job& job, VkCommandBuffer commands)
    : device_(device), commands_(commands) {
  build_micromap(job);
  wait(VK_PIPELINE_STAGE_2_MICROMAP_BUILD_BIT_EXT, VK_ACCESS_2_MICROMAP_WRITE_BIT_EXT,
       VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR, VK_ACCESS_2_MICROMAP_READ_BIT_EXT);
  build_geometry(job);
  wait(VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
       VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR,
       VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
       VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR);
  build_scene();
  wait(VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
       VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
       VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR);
}

Structures::~Structures() {
  const Functions& f = device_.functions();
  f.destroy_structure(device_.handle(), scene_, nullptr);
  f.destroy_structure(device_.handle(), geometry_, nullptr);
  f.destroy_micromap(device_.handle(), micromap_, nullptr);
}

void Structures::build_micromap(const Job& job) {
  VkMicromapBuildInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_MICROMAP_BUILD_INFO_EXT;
  info.type = VK_MICROMAP_TYPE_OPACITY_MICROMAP_EXT;
  info.mode = VK_BUILD_MICROMAP_MODE_BUILD_EXT;
  info.usageCountsCount = count_of(job.array_counts);
  info.pUsageCounts = job.array_counts.data();
  info.data.deviceAddress = input(job.data.data(), job.data.size(), micromap_input);
  info.triangleArray.deviceAddress = input(job.records.data(), job.records.size(), micromap_input);
  info.triangleArrayStride = job.record_stride;
  VkMicromapBuildSizesInfoEXT sizes{};
  sizes.sType = VK_STRUCTURE_TYPE_MICROMAP_BUILD_SIZES_INFO_EXT;
  const Functions& f = device_.functions();
  f.micromap_sizes(device_.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info, &sizes);
  VkMicromapCreateInfoEXT create{};
  create.sType = VK_STRUCTURE_TYPE_MICROMAP_CREATE_INFO_EXT;
  create.buffer = own(sizes.micromapSize, VK_BUFFER_USAGE_MICROMAP_STORAGE_BIT_EXT).handle();
  create.size = sizes.micromapSize;
  create.type = VK_MICROMAP_TYPE_OPACITY_MICROMAP_EXT;
  check(f.create_micromap(device_.handle(), &create, nullptr, &micromap_), "vkCreateMicromapEXT");
  info.dstMicromap = micromap_;
  info.scratchData.deviceAddress = scratch(sizes.buildScratchSize);
  f.build_micromaps(commands_, 1, &info);
}

void Structures::build_geometry(const Job& job) {
  const std::vector<float> vertices = corners(job.triangles);
  VkAccelerationStructureTrianglesOpacityMicromapEXT opacity{};
  opacity.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_TRIANGLES_OPACITY_MICROMAP_EXT;
  opacity.indexType = job.index_type;
  opacity.indexBuffer.deviceAddress = input(job.indices.data(), job.indices.size(), build_input);
  opacity.indexStride = job.index_stride;
  opacity.baseTriangle = job.base;
  opacity.usageCountsCount = count_of(job.geometry_counts);
  opacity.pUsageCounts = job.geometry_counts.data();
  opacity.micromap = micromap_;
  VkAccelerationStructureGeometryKHR geometry{};
  geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
  geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
  auto& triangles = geometry.geometry.triangles;
  triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
  triangles.pNext = &opacity;
  triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
  triangles.vertexData.deviceAddress = input(vertices.data(), vertices.size() * sizeof(float), build_input);
  triangles.vertexStride = 3 * sizeof(float);
  triangles.maxVertex = 3 * job.triangles - 1;
  triangles.indexType = VK_INDEX_TYPE_NONE_KHR;
  build_structure(VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, geometry, job.triangles, geometry_);
}

void Structures::build_scene() {
  VkAccelerationStructureDeviceAddressInfoKHR below{};
  below.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR;
  below.accelerationStructure = geometry_;
  VkAccelerationStructureInstanceKHR instance{};
  for (unsigned k = 0; k < 3; ++k) instance.transform.matrix[k][k] = 1;
  instance.mask = 0xff;
  instance.accelerationStructureReference = device_.functions().structure_address(device_.handle(), &below);
  VkAccelerationStructureGeometryKHR geometry{};
  geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
  geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
  auto& instances = geometry.geometry.instances;
  instances.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
  instances.data.deviceAddress = input(&instance, sizeof instance, build_input);
  build_structure(VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, geometry, 1, scene_);
}

void Structures::build_structure(VkAccelerationStructureTypeKHR type,
                                 const VkAccelerationStructureGeometryKHR& geometry, std::uint32_t primitives,
                                 VkAccelerationStructureKHR& to) {
  VkAccelerationStructureBuildGeometryInfoKHR info{};
  info.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR;
  info.type = type;
  info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
  info.geometryCount = 1;
  info.pGeometries = &geometry;
  VkAccelerationStructureBuildSizesInfoKHR sizes{};
  sizes.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR;
  const Functions& f = device_.functions();
  f.structure_sizes(device_.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info, &primitives,
                    &sizes);
  VkAccelerationStructureCreateInfoKHR create{};
  create.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR;
  create.buffer =
      own(sizes.accelerationStructureSize, VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR).handle();
  create.size = sizes.accelerationStructureSize;
  create.type = type;
  check(f.create_structure(device_.handle(), &create, nullptr, &to), "vkCreateAccelerationStructureKHR");
  info.dstAccelerationStructure = to;
  info.scratchData.deviceAddress = scratch(sizes.buildScratchSize);
  const VkAccelerationStructureBuildRangeInfoKHR range{primitives, 0, 0, 0};
  const VkAccelerationStructureBuildRangeInfoKHR* ranges = &range;
  f.build_structures(commands_, 1, &info, &ranges);
}

void Structures::wait(VkPipelineStageFlags2 stage, VkAccessFlags2 written, VkPipelineStageFlags2 next,
                      VkAccessFlags2 read) const {
  VkMemoryBarrier2 barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
  barrier.srcStageMask = stage;
  barrier.srcAccessMask = written;
  barrier.dstStageMask = next;
  barrier.dstAccessMask = read;
  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.memoryBarrierCount = 1;
  info.pMemoryBarriers = &barrier;
  device_.functions().barrier(commands_, &info);
}

VkDeviceAddress Structures::input(const void* bytes, std::size_t size, VkBufferUsageFlags usage) {
  buffers_.push_back(std::make_unique<Buffer>(device_, size + input_alignment - 1, usage, true));
  const Buffer& buffer = *buffers_.back();
  const VkDeviceAddress at = rounded_up(buffer.address(), input_alignment);
  std::memcpy(static_cast<std::uint8_t*>(buffer.mapped()) + (at - buffer.address()), bytes, size);
  return at;
}

const Buffer& Structures::own(VkDeviceSize size, VkBufferUsageFlags usage) {
  buffers_.push_back(std::make_unique<Buffer>(device_, size, usage, false));
  return *buffers_.back();
}

VkDeviceAddress Structures::scratch(VkDeviceSize size) {
  const VkDeviceSize alignment = device_.about().scratch_alignment;
  return rounded_up(own(size + alignment - 1, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT).address(), alignment);
}

}  // namespace rays
