// The rules of micromap arrays, each with the specifications that have it and the places there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mmverify::spec::micromap {

/// The specifications, as bits of a set.
using Sets = std::uint8_t;
inline constexpr Sets EXT = 1, KHR = 2, DXR = 4, glTF = 8, all_sets = 15;

enum class Rule : std::uint8_t {
  align_data_256,
  align_records_256,
  align_data_128,
  align_records_128,
  align_records_4,
  align_index,
  stride_least,
  stride_multiple,
  stride_tight,
  records_size,
  records_whole,
  record_format,
  record_level,
  record_level_lossy,
  record_level_12,
  record_lossy_format,
  record_region,
  record_overlap,
  counts_format,
  counts_level,
  counts_level_lossy,
  counts_level_12,
  counts_lossy_format,
  counts_zero,
  counts_limit,
  counts_array,
  counts_array_is_geometry,
  counts_geometry,
  counts_geometry_is_array,
  index_encoding,
  index_stride,
  index_stride_most,
  index_tight,
  index_size,
  index_count,
  index_special,
  index_range,
  count_
};
inline constexpr std::size_t rule_count = static_cast<std::size_t>(Rule::count_);

/// A rule in words, the specifications that have it, and the places there.
struct RuleText {
  Rule rule;
  const char* id;
  Sets sets;
  const char* says;
  const char* source;
};

/// The rules.  VUID-... names are those of the Vulkan specification of 2026; "DXR" is the DirectX Raytracing functional
/// specification's part on opacity micromaps; "glTF" is the draft of EXT_mesh_opacity_micromap (pull request 2623).
/// "Ours" marks rules for which no text of that specification was found.
inline constexpr std::array<RuleText, rule_count> rules{{
    {Rule::align_data_256, "align.data_256", EXT, "the data's address is a multiple of 256",
     "VUID-vkCmdBuildMicromapsEXT-pInfos-07515"},
    {Rule::align_records_256, "align.records_256", EXT, "the records' address is a multiple of 256",
     "VUID-vkCmdBuildMicromapsEXT-pInfos-07515"},
    {Rule::align_data_128, "align.data_128", KHR | DXR, "the data's address is a multiple of 128",
     "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11552; DXR, InputBuffer"},
    {Rule::align_records_128, "align.records_128", KHR, "the records' address is a multiple of 128",
     "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11552"},
    {Rule::align_records_4, "align.records_4", DXR, "the records' address is a multiple of 4",
     "DXR, PerOmmDescs"},
    {Rule::align_index, "align.index", DXR | glTF, "the indices' address is a multiple of an index's size",
     "DXR, OpacityMicromapIndexBuffer; glTF 2.0, accessor alignment"},
    {Rule::stride_least, "stride.least", all_sets, "records lie at least 8 bytes apart",
     "VUID-VkAccelerationStructureGeometryMicromapDataKHR-triangleArrayStride-11646; glTF, tightly packed; "
     "EXT and DXR: ours, as a record has 8 bytes"},
    {Rule::stride_multiple, "stride.multiple", KHR | DXR, "the records' stride is a multiple of 4",
     "VUID-VkAccelerationStructureGeometryMicromapDataKHR-triangleArrayStride-11647; DXR, PerOmmDescs"},
    {Rule::stride_tight, "stride.tight", glTF, "records lie exactly 8 bytes apart",
     "glTF, Micromap Triangle Records"},
    {Rule::records_size, "records.size", all_sets, "the buffer holds every record",
     "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11554; glTF; EXT and DXR: ours, nothing may be read "
     "beyond a buffer"},
    {Rule::records_whole, "records.whole", glTF, "the record buffer's size is a multiple of 8",
     "glTF, Micromap Triangle Records"},
    {Rule::record_format, "record.format", all_sets, "a record's format is 1 or 2",
     "VUID-VkMicromapBuildInfoEXT-type-07518; VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11555; DXR, "
     "OPACITY_MICROMAP_FORMAT; glTF"},
    {Rule::record_level, "record.level", EXT | KHR,
     "a record's level is within the device's limit for its format",
     "EXT: by its usage counts, VUID-VkMicromapUsageEXT-format-07520, -07521; "
     "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11556, "
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-subdivisionLevel-11564"},
    {Rule::record_level_lossy, "record.level_lossy", KHR,
     "a 4-state record of a lossy build is within the device's limit for those",
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-subdivisionLevel-11565"},
    {Rule::record_level_12, "record.level_12", DXR | glTF, "a record's level is at most 12",
     "DXR, OPACITY_MICROMAP_OC1_MAX_SUBDIVISION_LEVEL; glTF"},
    {Rule::record_lossy_format, "record.lossy_format", KHR, "a lossy build has 4-state records only",
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-format-11712"},
    {Rule::record_region, "record.region", all_sets, "a record's bytes lie within the data",
     "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11553; glTF, Microtriangle Data; EXT and DXR: ours, "
     "nothing may be read beyond a buffer"},
    {Rule::record_overlap, "record.overlap", glTF, "no two records share a byte of the data",
     "glTF, Microtriangle Data"},
    {Rule::counts_format, "counts.format", all_sets, "a usage count's format is 1 or 2",
     "VUID-VkMicromapUsageEXT-format-07519; KHR: by its records, micromap-11555; DXR, "
     "OPACITY_MICROMAP_FORMAT; glTF"},
    {Rule::counts_level, "counts.level", EXT | KHR,
     "a usage count's level is within the device's limit for its format",
     "VUID-VkMicromapUsageEXT-format-07520, -07521; "
     "VUID-VkAccelerationStructureGeometryMicromapDataKHR-subdivisionLevel-11645, "
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-subdivisionLevel-11564"},
    {Rule::counts_level_lossy, "counts.level_lossy", KHR,
     "a 4-state usage count of a lossy build is within the device's limit for those",
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-subdivisionLevel-11565"},
    {Rule::counts_level_12, "counts.level_12", DXR | glTF, "a usage count's level is at most 12",
     "DXR, OPACITY_MICROMAP_HISTOGRAM_ENTRY; glTF"},
    {Rule::counts_lossy_format, "counts.lossy_format", KHR, "a lossy build has 4-state usage counts only",
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-format-11712"},
    {Rule::counts_zero, "counts.zero", glTF, "a usage count is at least 1", "glTF, usageCounts"},
    {Rule::counts_limit, "counts.limit", KHR, "the usage counts add up to at most maxMicromapTriangles",
     "VUID-VkAccelerationStructureGeometryMicromapDataKHR-count-11643"},
    {Rule::counts_array, "counts.array", all_sets,
     "for each level and format, the array's usage counts add up to its records",
     "VkMicromapBuildInfoEXT; VkAccelerationStructureGeometryMicromapDataKHR; DXR, HISTOGRAM_ENTRY; glTF"},
    {Rule::counts_array_is_geometry, "counts.array_is_geometry", all_sets,
     "the array's usage counts are not the geometry's", "diagnosis of counts.array"},
    {Rule::counts_geometry, "counts.geometry", EXT,
     "for each level and format, the geometry's usage counts add up to its triangles after indirection, "
     "special indices left out",
     "VkAccelerationStructureTrianglesOpacityMicromapEXT"},
    {Rule::counts_geometry_is_array, "counts.geometry_is_array", EXT,
     "the geometry's usage counts are not the array's", "diagnosis of counts.geometry"},
    {Rule::index_encoding, "index.encoding", EXT | KHR | DXR, "the index type is one that the API has",
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-indexType-10719 (u16, u32); "
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-indexType-11570 and DXR, "
     "OpacityMicromapIndexFormat (u8, u16, u32)"},
    {Rule::index_stride, "index.stride", EXT | KHR | DXR,
     "the indices' stride is a multiple of an index's size",
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-indexType-10722; "
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-indexStride-11573; DXR, "
     "OpacityMicromapIndexBuffer"},
    {Rule::index_stride_most, "index.stride_most", EXT | KHR, "the indices' stride is below 2^32",
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-indexType-10723; "
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-indexStride-11574"},
    {Rule::index_tight, "index.tight", glTF, "indices are tightly packed", "glTF, Accessor Requirements"},
    {Rule::index_size, "index.size", all_sets, "the buffer holds an index for every triangle",
     "VUID-vkCmdBuildAccelerationStructuresKHR-indexBuffer-11577; glTF; EXT and DXR: ours, nothing may be "
     "read beyond a buffer"},
    {Rule::index_count, "index.count", glTF, "there are no more indices than triangles",
     "glTF, Accessor Requirements"},
    {Rule::index_special, "index.special", glTF, "a signed index is at least -4",
     "glTF, Accessor Requirements"},
    {Rule::index_range, "index.range", all_sets,
     "a plain index plus baseTriangle is less than the number of records",
     "glTF, Lookup; DXR, OpacityMicromapIndexBuffer; EXT and KHR: the record must exist "
     "(VUID-vkCmdBuildAccelerationStructuresKHR-indexBuffer-11575 and "
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-geometry-11576 say \"less than or equal\", one "
     "too many)"},
}};

constexpr const RuleText& text(Rule rule) { return rules[static_cast<std::size_t>(rule)]; }

}  // namespace mmverify::spec::micromap
