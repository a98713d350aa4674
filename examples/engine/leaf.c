/* From a texture and UVs to the structs of VK_EXT_opacity_micromap and VK_KHR_opacity_micromap, in C. */
#include "leaf.h"

#include <mmverify/mmverify.h>
#include <stdlib.h>

#include "print.h"

static void must(int ok) {
  if (ok) return;
  fprintf(stderr, "%s\n", mmverify_error());
  exit(1);
}

/* Three members of one size each: our structs are Vulkan's. */
_Static_assert(sizeof(VkMicromapTriangleEXT) == sizeof(mmverify_record) &&
                   offsetof(VkMicromapTriangleEXT, format) == offsetof(mmverify_record, format),
               "records");
_Static_assert(sizeof(VkMicromapUsageEXT) == sizeof(mmverify_usage) &&
                   offsetof(VkMicromapUsageEXT, format) == offsetof(mmverify_usage, format),
               "usage counts");

#ifdef VK_KHR_opacity_micromap
static void print_khr(const mmverify_buffers* b) {
  const VkAccelerationStructureGeometryMicromapDataKHR build = {
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_MICROMAP_DATA_KHR,
      .usageCountsCount = (uint32_t)b->array_usage_count,
      .pUsageCounts = (const VkMicromapUsageKHR*)b->array_usage,
      .triangleArrayStride =
          sizeof *b->records}; /* .data and .triangleArray: the device's addresses of the buffers */
  const VkAccelerationStructureTrianglesOpacityMicromapKHR geometry = {
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_TRIANGLES_OPACITY_MICROMAP_KHR,
      .indexType = VK_INDEX_TYPE_UINT16,
      .indexStride = sizeof(uint16_t)};
  for (uint32_t k = 0; k < build.usageCountsCount; ++k)
    printf("KHR usage count %u level %u format %d\n", build.pUsageCounts[k].count,
           build.pUsageCounts[k].subdivisionLevel, build.pUsageCounts[k].format);
  for (size_t k = 0; k < b->record_count; ++k) {
    const VkMicromapTriangleKHR* const r = (const VkMicromapTriangleKHR*)&b->records[k];
    printf("KHR record offset %u level %u format %u\n", r->dataOffset, r->subdivisionLevel, r->format);
  }
  printf("KHR index type %d stride %u\n", geometry.indexType, (unsigned)geometry.indexStride);
}
#else
static void print_khr(const mmverify_buffers* b) {
  (void)b;
  puts("these Vulkan headers have no VK_KHR_opacity_micromap");
}
#endif

int main(void) {
  static uint8_t rgba[LEAF_PITCH * LEAF_HEIGHT];
  mmverify_map maps[LEAF_TRIANGLES];
  leaf_draw(rgba);

  const mmverify_pixels image = {rgba, LEAF_WIDTH, LEAF_HEIGHT, LEAF_PITCH, 4, 3};
  const mmverify_sampling sampling = {.texel = MMVERIFY_TEXEL_UNORM8,
                                      .factor = 1,
                                      .vertex_factor = 1,
                                      .cutoff_numerator = 1,
                                      .cutoff_denominator = 2};
  mmverify_baker* const baker = mmverify_baker_of_pixels(&image, 1, &sampling);
  must(baker != NULL);
  for (int t = 0; t < LEAF_TRIANGLES; ++t) { /* on threads of yours, if you like */
    must(mmverify_useful_level(leaf_uvs[t], LEAF_WIDTH, LEAF_HEIGHT, 12, &maps[t].level));
    uint8_t* const map = malloc(((size_t)1 << 2 * maps[t].level) / 4 + 1);
    must(mmverify_bake(baker, leaf_uvs[t], maps[t].level, map));
    maps[t].format = MMVERIFY_FORMAT_4_STATE;
    maps[t].bytes = map;
  }
  mmverify_array* const array = mmverify_array_new(maps, LEAF_TRIANGLES, 16);
  must(array != NULL);
  mmverify_buffers b;
  mmverify_array_buffers(array, &b);

  const VkMicromapBuildInfoEXT build = {
      .sType = VK_STRUCTURE_TYPE_MICROMAP_BUILD_INFO_EXT,
      .type = VK_MICROMAP_TYPE_OPACITY_MICROMAP_EXT,
      .mode = VK_BUILD_MICROMAP_MODE_BUILD_EXT,
      .usageCountsCount = (uint32_t)b.array_usage_count,
      .pUsageCounts = (const VkMicromapUsageEXT*)b.array_usage,
      .data.hostAddress = b.data, /* on the device: a buffer's address, a multiple of 256 */
      .triangleArray.hostAddress = b.records,
      .triangleArrayStride = sizeof *b.records};
  const VkAccelerationStructureTrianglesOpacityMicromapEXT geometry = {
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_TRIANGLES_OPACITY_MICROMAP_EXT,
      .indexType = VK_INDEX_TYPE_UINT16,
      .indexBuffer.hostAddress = b.indices,
      .indexStride = sizeof(uint16_t),
      .usageCountsCount = (uint32_t)b.geometry_usage_count,
      .pUsageCounts = (const VkMicromapUsageEXT*)b.geometry_usage};

  print_build(&build, (uint32_t)b.record_count, b.data_bytes);
  print_geometry(&geometry, LEAF_TRIANGLES);
  for (int t = 0; t < LEAF_TRIANGLES; ++t) {
    uint8_t state;
    must(mmverify_array_state(array, (size_t)t, 0.3125f, 0.34375f, &state));
    printf("centre state %d\n", state);
  }
  print_khr(&b);
  mmverify_array_free(array);
  mmverify_baker_free(baker);
  for (int t = 0; t < LEAF_TRIANGLES; ++t) free((void*)maps[t].bytes);
  return 0;
}
