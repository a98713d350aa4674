// Six APIs: the requirements of each on arrays of micromaps, and the target of a triangle's index.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "impl/micromap/array.hpp"

namespace mmverify::impl::array {

using micromap::Bytes;
using micromap::Encoding;
using micromap::Format;
using micromap::Level;
using micromap::PackedMap;
using micromap::State;
using micromap::UsageCount;

/// The API that builds from the array.
enum class Api : std::uint8_t { EXT, KHR, DXR, OptiX, NVAPI, glTF };
inline constexpr std::size_t api_count = 6;

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

/// The requirements of every API, in the order of Api.  Source: docs/ARRAYS.md, "What each API asks".
inline constexpr std::array<Requirements, api_count> requirements_of_all{{
    {"ext", true, 256, 256, 1, false, false, true},
    {"khr", false, 128, 128, 4, true, false, false},
    {"dxr", false, 128, 4, 4, true, false, true},
    {"optix", true, 128, 8, 8, false, false, true},
    {"nvapi", true, 256, 4, 8, false, false, true},
    {"gltf", false, 1, 1, 8, true, true, false},
}};
constexpr const Requirements& requirements(Api api) noexcept {
  return requirements_of_all[static_cast<std::size_t>(api)];
}

/// Whether an API takes indices of this encoding.
/// Test: impl_array_test
constexpr bool takes(Api api, Encoding e) noexcept {
  if (micromap::is_signed(e)) return requirements(api).signed_indices;
  return e != Encoding::u8 || requirements(api).bits_8;
}

/// The target of a code in a geometry: a special index, no micromap, a record, or a number that no record has.
struct Target {
  enum class Kind : std::uint8_t { special, none, record, outside } kind;
  State state = State::T;    ///< the special index's state
  std::uint64_t record = 0;  ///< the record's number; if outside, the number that no record has
  friend constexpr bool operator==(const Target&, const Target&) = default;
};

/// The target of a code: a special index's state; none for -5 in a cluster; else record code + base, outside unless it
/// is less than `records`.  A negative code below the special ones is outside, with record = code.
/// Domain: code < 2^width.
/// Law: array.codes, array.codes_on_samples
constexpr Target target(std::uint32_t code, Encoding e, bool cluster, std::uint32_t base,
                        std::uint32_t records) noexcept {
  if (const auto state = micromap::special_state(code, e)) return {Target::Kind::special, *state};
  const std::uint32_t from_the_end = (0xffffffffu >> (32 - micromap::width(e))) - code;
  if (cluster && from_the_end == 4) return {Target::Kind::none};
  if (!micromap::is_index(code, e)) return {Target::Kind::outside, State::T, code};
  const std::uint64_t record = std::uint64_t{code} + base;
  return {record < records ? Target::Kind::record : Target::Kind::outside, State::T, record};
}

/// A geometry's references into an array.
struct Part {
  Encoding encoding = Encoding::u32;
  std::uint32_t base = 0;
  Bytes indices;  ///< one code a triangle, tightly packed, little-endian
};

/// An array and the geometries that refer to it.
struct Bundle {
  micromap::Array array;
  std::vector<Part> parts;
};

}  // namespace mmverify::impl::array
