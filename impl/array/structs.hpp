// Records, counts and index types as Vulkan, Direct3D 12 and OptiX declare them, without their headers.
#pragma once

#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "impl/array/api.hpp"

namespace mmverify::impl::array {

/// Records or counts as an API's structs, whose three members have the same order and sizes.
///   Record      VkMicromapTriangleEXT and KHR, vk::MicromapTriangleEXT, D3D12_RAYTRACING_OPACITY_MICROMAP_DESC,
///               OptixOpacityMicromapDesc
///   UsageCount  VkMicromapUsageEXT and KHR, vk::MicromapUsageEXT, D3D12_RAYTRACING_OPACITY_MICROMAP_HISTOGRAM_ENTRY,
///               OptixOpacityMicromapHistogramEntry, OptixOpacityMicromapUsageCount
/// States and formats need no conversion: their numbers are those of all these APIs.
/// Test: engine_test
template <class Struct, class Ours>
std::vector<Struct> copied_as(const std::vector<Ours>& ours) {
  static_assert(std::is_same_v<Ours, micromap::Record> || std::is_same_v<Ours, UsageCount>);
  static_assert(sizeof(Struct) == sizeof(Ours) && std::is_trivially_copyable_v<Struct> &&
                std::is_standard_layout_v<Struct>);
  std::vector<Struct> theirs(ours.size());
  if (!ours.empty()) std::memcpy(static_cast<void*>(theirs.data()), ours.data(), ours.size() * sizeof(Ours));
  return theirs;
}

/// An enumerator's number in VkIndexType and in DXGI_FORMAT.
struct IndexType {
  std::uint32_t vulkan, dxgi;
};
/// VK_INDEX_TYPE_UINT8, UINT16, UINT32; DXGI_FORMAT_R8_UINT, R16_UINT, R32_UINT.
/// Errors: std::invalid_argument for signed indices, which only glTF has.
/// Test: engine_test
constexpr IndexType index_type(Encoding e) {
  switch (e) {
    case Encoding::u8: return {1000265000, 62};
    case Encoding::u16: return {0, 57};
    case Encoding::u32: return {1, 42};
    case Encoding::i16:
    case Encoding::i32: break;
  }
  throw std::invalid_argument("array::index_type: signed indices are glTF's alone");
}

}  // namespace mmverify::impl::array
