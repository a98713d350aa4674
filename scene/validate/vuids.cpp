#include "scene/validate/vuids.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;
using micromap::EXT;
using micromap::KHR;
using micromap::Place;

constexpr bool missing = true;

// The prefix of the texts that belong to a command stands for its indirect form, too.
constexpr Vuid all_vuids[] = {
    {"align.data_256", EXT, cases::always, "VUID-vkCmdBuildMicromapsEXT-pInfos-07515"},
    {"align.records_256", EXT, cases::always, "VUID-vkCmdBuildMicromapsEXT-pInfos-07515"},
    {"align.data_128", KHR, cases::always, "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11552"},
    {"align.records_128", KHR, cases::always, "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11552"},
    {"stride.least", KHR, cases::always,
     "VUID-VkAccelerationStructureGeometryMicromapDataKHR-triangleArrayStride-11646"},
    {"stride.multiple", KHR, cases::always,
     "VUID-VkAccelerationStructureGeometryMicromapDataKHR-triangleArrayStride-11647"},
    {"records.size", KHR, cases::always, "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11554"},
    {"record.format", EXT, cases::always, "VUID-VkMicromapBuildInfoEXT-format-11657", missing},
    {"record.format", KHR, cases::always, "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11555", missing},
    {"record.level", EXT, cases::two_state, "VUID-VkMicromapBuildInfoEXT-subdivisionLevel-11659", missing},
    {"record.level", EXT, cases::four_state, "VUID-VkMicromapBuildInfoEXT-subdivisionLevel-11660", missing},
    {"record.level", KHR, cases::two_state, "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11556",
     missing},
    {"record.level", KHR, cases::four_state,
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-subdivisionLevel-11566", missing},
    {"record.level_lossy", KHR, cases::always,
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-subdivisionLevel-11567", missing},
    {"record.lossy_format", KHR, cases::always,
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-format-11713", missing},
    {"record.region", KHR, cases::always, "VUID-vkCmdBuildAccelerationStructuresKHR-micromap-11553", missing},
    {"counts.format", EXT, cases::array, "VUID-VkMicromapBuildInfoEXT-format-11652"},
    {"counts.format", EXT, cases::geometry,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-format-11679"},
    {"counts.format", KHR, cases::array, "VUID-VkMicromapUsageKHR-format-parameter"},
    {"counts.level", EXT, cases::array | cases::two_state,
     "VUID-VkMicromapBuildInfoEXT-subdivisionLevel-11654"},
    {"counts.level", EXT, cases::array | cases::four_state,
     "VUID-VkMicromapBuildInfoEXT-subdivisionLevel-11655"},
    {"counts.level", EXT, cases::geometry | cases::two_state,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-subdivisionLevel-11680"},
    {"counts.level", EXT, cases::geometry | cases::four_state,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-subdivisionLevel-11681"},
    {"counts.level", KHR, cases::array | cases::two_state,
     "VUID-VkAccelerationStructureGeometryMicromapDataKHR-subdivisionLevel-11645"},
    {"counts.level", KHR, cases::array | cases::four_state,
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-subdivisionLevel-11564"},
    {"counts.level_lossy", KHR, cases::array,
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-subdivisionLevel-11565"},
    {"counts.lossy_format", KHR, cases::array,
     "VUID-VkAccelerationStructureBuildGeometryInfoKHR-format-11712"},
    {"counts.limit", KHR, cases::always, "VUID-VkAccelerationStructureGeometryMicromapDataKHR-count-11643"},
    {"index.encoding", EXT, cases::always,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-indexType-10719"},
    {"index.encoding", KHR, cases::always,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-indexType-11570"},
    {"index.uint8", KHR, cases::always,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-indexType-11570"},
    {"index.none", EXT, cases::always, "VUID-vkCmdBuildAccelerationStructuresKHR-pInfos-10904"},
    {"index.none", KHR, cases::always,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-indexBuffer-11571"},
    {"index.stride", EXT, cases::always,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-indexType-10722"},
    {"index.stride", KHR, cases::always,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-indexStride-11573"},
    {"index.stride_most", EXT, cases::always,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapEXT-indexType-10723"},
    {"index.stride_most", KHR, cases::always,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-indexStride-11574"},
    {"index.size", KHR, cases::always, "VUID-vkCmdBuildAccelerationStructuresKHR-indexBuffer-11577"},
    {"index.range", KHR, cases::with_indices | cases::has_records,
     "VUID-vkCmdBuildAccelerationStructuresKHR-indexBuffer-11575", missing},
    {"index.range", KHR, cases::without_indices | cases::has_records,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-geometry-11576"},
    {"index.range", KHR, cases::with_indices | cases::null_micromap,
     "VUID-vkCmdBuildAccelerationStructuresKHR-indexBuffer-11578", missing},
    {"index.range", KHR, cases::without_indices | cases::null_micromap,
     "VUID-VkAccelerationStructureTrianglesOpacityMicromapKHR-micromap-11579"},
    {"index.mixed", KHR, cases::always, "VUID-vkCmdTraceRaysKHR-micromap-11638", missing},
    {"index.mixed", KHR, cases::always, "VUID-vkCmdTraceRaysKHR-micromap-11639", missing},
    {"index.mixed_khr", KHR, cases::always, "VUID-vkCmdTraceRaysKHR-micromap-11638", missing},
    {"index.mixed_khr", KHR, cases::always, "VUID-vkCmdTraceRaysKHR-micromap-11639", missing},
};

Cases of_format(std::uint32_t format) {
  if (format == 1) return cases::two_state;
  return format == 2 ? cases::four_state : cases::always;
}

Cases of_count(const std::optional<std::span<const micromap::UsageCount>>& counts, std::uint64_t where) {
  return counts && where < counts->size() ? of_format((*counts)[static_cast<std::size_t>(where)].format)
                                          : cases::always;
}

}  // namespace

std::span<const Vuid> vuids() { return all_vuids; }

std::vector<std::string_view> vuids_of(std::string_view code, micromap::Sets sets, Cases cases) {
  const bool of_no_api = (sets & ~micromap::glTF) == 0;
  std::vector<std::string_view> names;
  for (const Vuid& one : all_vuids)
    if (one.code == code && (of_no_api || (one.api & sets) != 0) && (one.when & ~cases) == 0)
      names.push_back(one.name);
  return names;
}

Cases cases_of(const micromap::Violation& violation, const micromap::Input& in) {
  const Cases geometry = (in.indexed ? cases::with_indices : cases::without_indices) |
                         (in.record_count == 0 ? cases::null_micromap : cases::has_records);
  switch (violation.place) {
    case Place::record: {
      const std::uint64_t at = violation.where * in.record_stride;
      const bool whole = at <= in.records.size() && in.records.size() - at >= micromap::record_bytes;
      return whole ? of_format(micromap::record_at(in.records, at).format) : cases::always;
    }
    case Place::array_count: return cases::array | of_count(in.array_counts, violation.where);
    case Place::geometry_count: return cases::geometry | of_count(in.geometry_counts, violation.where);
    default: return geometry;
  }
}

}  // namespace mmverify::scene
