// Six APIs and their requirements on arrays of micromaps: counts, strides, alignments, widths.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "spec/micromap/micromap.hpp"

namespace mmverify::spec::array {

using micromap::Encoding;

/// The API that builds from the array.
enum class Api : std::uint8_t { EXT, KHR, DXR, OptiX, NVAPI, glTF };
inline constexpr std::size_t api_count = 6;
inline constexpr Api apis[api_count] = {Api::EXT, Api::KHR, Api::DXR, Api::OptiX, Api::NVAPI, Api::glTF};

/// The requirements of an API on arrays: docs/ARRAYS.md, "What each API asks".
struct Requirements {
  const char* name;
  bool counts_geometry;  ///< the build of a geometry takes the histogram of its references, too
  std::uint32_t data_alignment, records_alignment;
  std::uint32_t stride_multiple;  ///< divides the records' stride, which is 8 at least
  bool bits_8;                    ///< 8-bit indices are allowed, beside 16 and 32 bits
  bool signed_indices;
  bool clusters;  ///< the API has clusters, in which -5 means no micromap for the triangle
};

/// The requirements of every API, in the order of Api.
/// Source: VK_EXT_opacity_micromap; VK_KHR_opacity_micromap; the DirectX Raytracing specification, 1.28 and later;
/// OptiX 9 programming guide, Opacity micromaps; nvapi.h; EXT_mesh_opacity_micromap.
inline constexpr std::array<Requirements, api_count> requirements_of_all{{
    {"ext", true, 256, 256, 1, false, false, true},
    {"khr", false, 128, 128, 4, true, false, false},
    {"dxr", false, 128, 4, 4, true, false, true},
    {"optix", true, 128, 8, 8, false, false, true},
    {"nvapi", true, 256, 4, 8, false, false, true},
    {"gltf", false, 1, 1, 8, true, true, false},
}};
constexpr const Requirements& requirements(Api api) {
  return requirements_of_all[static_cast<std::size_t>(api)];
}

/// Whether an API takes indices of this encoding.
constexpr bool takes(Api api, Encoding e) {
  if (micromap::is_signed(e)) return requirements(api).signed_indices;
  return e != Encoding::u8 || requirements(api).bits_8;
}

}  // namespace mmverify::spec::array
