// What each API asks of an array of micromaps, and what a triangle's index means.
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

/// Who builds from the array.
enum class Api : std::uint8_t { EXT, KHR, DXR, OptiX, NVAPI, glTF };
inline constexpr std::size_t api_count = 6;

/// What an API asks of arrays: docs/ARRAYS.md, "What each API asks".
struct Requirements {
  const char* name;
  bool counts_geometry;  ///< a build of a geometry takes the histogram of its references, too
  std::uint32_t data_alignment, records_alignment;
  std::uint32_t stride_multiple;  ///< of the records' stride, which is 8 at least
  bool bits_8;                    ///< indices of 8 bits, beside those of 16 and 32
  bool signed_indices;
  bool clusters;  ///< it has clusters, in which -5 is no micromap for the triangle
};

/// In the order of Api.  Source: docs/ARRAYS.md, "What each API asks".
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

/// Whether an API's indices may be stored so.
constexpr bool takes(Api api, Encoding e) noexcept {
  if (micromap::is_signed(e)) return requirements(api).signed_indices;
  return e != Encoding::u8 || requirements(api).bits_8;
}

/// What a code means to a geometry.
struct Target {
  enum class Kind : std::uint8_t { special, none, record, outside } kind;
  State state = State::T;    ///< of a special one
  std::uint64_t record = 0;  ///< of a record, or of the one outside
  friend constexpr bool operator==(const Target&, const Target&) = default;
};

/// A special index; in a cluster -5, which is none; else the record index + base, outside unless it is less than
/// `records`.  A signed code below those is outside at its own number.  Domain: code < 2^width.
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
