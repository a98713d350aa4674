// From a texture and UVs to the structs of VK_EXT_opacity_micromap and VK_KHR_opacity_micromap, in C++.
#include "leaf.h"

#include <atomic>
#include <mmverify/mmverify.hpp>
#include <thread>

#include "print.h"

using namespace mmverify::impl;

/// The engine's job system stands here; jobs come in any order.
static void on_my_threads(std::size_t count, const std::function<void(std::size_t)>& job) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k; (k = next++) < count;) job(k);
  };
  std::thread other(work);
  work();
  other.join();
}

/// The geometry's struct names the micromap as an acceleration structure, and the build has its own geometry type.
#ifdef VK_KHR_opacity_micromap
static void print_khr(const array::Built& built) {
  const auto records = array::copied_as<VkMicromapTriangleKHR>(built.array.records);
  const auto usage = array::copied_as<VkMicromapUsageKHR>(built.array_counts);
  VkAccelerationStructureGeometryMicromapDataKHR build{};
  build.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_MICROMAP_DATA_KHR;
  build.usageCountsCount = static_cast<std::uint32_t>(usage.size());
  build.pUsageCounts = usage.data();
  build.triangleArrayStride =
      sizeof records[0];  // build.data and triangleArray: the device's addresses of the buffers
  VkAccelerationStructureTrianglesOpacityMicromapKHR geometry{};
  geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_TRIANGLES_OPACITY_MICROMAP_KHR;
  geometry.indexType = static_cast<VkIndexType>(array::index_type(built.part.encoding).vulkan);
  geometry.indexStride = micromap::width(built.part.encoding) / 8;
  geometry.baseTriangle = built.part.base;
  for (std::uint32_t k = 0; k < build.usageCountsCount; ++k)
    std::printf("KHR usage count %u level %u format %d\n", build.pUsageCounts[k].count,
                build.pUsageCounts[k].subdivisionLevel, build.pUsageCounts[k].format);
  for (const VkMicromapTriangleKHR& r : records)
    std::printf("KHR record offset %u level %u format %u\n", r.dataOffset, r.subdivisionLevel, r.format);
  std::printf("KHR index type %d stride %u\n", geometry.indexType,
              static_cast<unsigned>(geometry.indexStride));
}
#else
static void print_khr(const array::Built&) {
  std::puts("these Vulkan headers have no VK_KHR_opacity_micromap");
}
#endif

int main() {
  std::vector<std::uint8_t> rgba(LEAF_PITCH * LEAF_HEIGHT);
  leaf_draw(rgba.data());

  const bake::PixelView image{rgba.data(), LEAF_WIDTH, LEAF_HEIGHT, LEAF_PITCH};  // the alpha of RGBA8
  const bake::TriangleBaker baker({&image, 1}, bake::Cutoff{1, 2});
  std::vector<bake::BaseTriangle> triangles;
  std::vector<std::uint32_t> levels;
  for (const auto& uv : leaf_uvs) {
    triangles.push_back({{{uv[0], uv[1]}, {uv[2], uv[3]}, {uv[4], uv[5]}}});
    levels.push_back(bake::useful_level(triangles.back(), LEAF_WIDTH, LEAF_HEIGHT).level);
  }
  const bake::MeshMaps baked = bake::bake_mesh(baker, triangles, levels, on_my_threads);
  const array::Built built =
      array::build({}, baked.maps, {.api = array::Api::EXT, .encoding = array::Encoding::u16});

  const auto records = array::copied_as<VkMicromapTriangleEXT>(built.array.records);
  const auto array_usage = array::copied_as<VkMicromapUsageEXT>(built.array_counts);
  const auto geometry_usage = array::copied_as<VkMicromapUsageEXT>(*built.geometry_counts);
  VkMicromapBuildInfoEXT build{};
  build.sType = VK_STRUCTURE_TYPE_MICROMAP_BUILD_INFO_EXT;
  build.type = VK_MICROMAP_TYPE_OPACITY_MICROMAP_EXT;
  build.mode = VK_BUILD_MICROMAP_MODE_BUILD_EXT;
  build.usageCountsCount = static_cast<std::uint32_t>(array_usage.size());
  build.pUsageCounts = array_usage.data();
  build.data.hostAddress = built.array.data.data();  // on the device: a buffer's address, a multiple of 256
  build.triangleArray.hostAddress = records.data();
  build.triangleArrayStride = sizeof records[0];
  VkAccelerationStructureTrianglesOpacityMicromapEXT geometry{};
  geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_TRIANGLES_OPACITY_MICROMAP_EXT;
  geometry.indexType = static_cast<VkIndexType>(array::index_type(built.part.encoding).vulkan);
  geometry.indexBuffer.hostAddress = built.part.indices.data();
  geometry.indexStride = sizeof(std::uint16_t);
  geometry.baseTriangle = built.part.base;
  geometry.usageCountsCount = static_cast<std::uint32_t>(geometry_usage.size());
  geometry.pUsageCounts = geometry_usage.data();

  print_build(&build, static_cast<std::uint32_t>(records.size()), built.array.data.size());
  print_geometry(&geometry, LEAF_TRIANGLES);
  // The state that a ray meets in each triangle.
  for (std::uint32_t t = 0; t < LEAF_TRIANGLES; ++t)
    std::printf("centre state %d\n",
                static_cast<int>(*array::state_at(built.array, built.part, t, 0.3125f, 0.34375f)));
  print_khr(built);
}
