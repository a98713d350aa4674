/* The buffers and both histograms as lines, from the very structs that Vulkan is given. */
#ifndef PRINT_H
#define PRINT_H

#include <stdio.h>
#include <vulkan/vulkan.h>

static inline void print_build(const VkMicromapBuildInfoEXT* build, uint32_t records, size_t data_bytes) {
  const char* at = (const char*)build->triangleArray.hostAddress;
  printf("data %zu bytes\n", data_bytes);
  for (uint32_t k = 0; k < records; ++k, at += build->triangleArrayStride) {
    const VkMicromapTriangleEXT* const r = (const VkMicromapTriangleEXT*)at;
    printf("record offset %u level %u format %u\n", r->dataOffset, r->subdivisionLevel, r->format);
  }
  for (uint32_t k = 0; k < build->usageCountsCount; ++k) {
    const VkMicromapUsageEXT* const u = &build->pUsageCounts[k];
    printf("array usage count %u level %u format %u\n", u->count, u->subdivisionLevel, u->format);
  }
}

/* Indices of 16 and 32 bits, as the numbers that Vulkan's special indices are. */
static inline void print_geometry(const VkAccelerationStructureTrianglesOpacityMicromapEXT* geometry,
                                  uint32_t triangles) {
  const char* at = (const char*)geometry->indexBuffer.hostAddress;
  for (uint32_t t = 0; t < triangles; ++t, at += geometry->indexStride) {
    if (geometry->indexType == VK_INDEX_TYPE_UINT16) {
      const uint16_t code = *(const uint16_t*)at;
      printf("index %d\n", code >= 0xfffc ? code - 0x10000 : code);
    } else {
      printf("index %d\n", *(const int32_t*)at);
    }
  }
  printf("base %u\n", geometry->baseTriangle);
  for (uint32_t k = 0; k < geometry->usageCountsCount; ++k) {
    const VkMicromapUsageEXT* const u = &geometry->pUsageCounts[k];
    printf("geometry usage count %u level %u format %u\n", u->count, u->subdivisionLevel, u->format);
  }
}

#endif
