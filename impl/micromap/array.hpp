// The array of micromaps that a build takes: triangle records, data, usage counts, and a geometry's index
// buffer into it.
#pragma once

#include <vector>

#include "impl/micromap/micromap.hpp"

namespace mmverify::impl::micromap {

using Bytes = std::vector<std::uint8_t>;

/// The place, level and format of a map's bytes.  Source: VkMicromapTriangleKHR.
struct Record {
  std::uint32_t offset;  ///< first byte in the data
  std::uint16_t level;
  std::uint16_t format;
  friend constexpr bool operator==(const Record&, const Record&) = default;
};
inline constexpr std::uint64_t record_bytes = 8;

/// Source: VkMicromapUsageKHR.
struct UsageCount {
  std::uint32_t count, level, format;
  friend constexpr bool operator==(const UsageCount&, const UsageCount&) = default;
};

/// One triangle's packed micromap.  Domain: level in 0..16; packed_bytes(4^level, format) bytes or more.
struct PackedMap {
  Level level = 0;
  Format format = Format::four_state;
  std::span<const std::uint8_t> bytes;
};

/// The input of a micromap build.
struct Array {
  std::vector<Record> records;
  Bytes data;
};

/// The input of a geometry's build beside the array.
struct Geometry {
  Bytes indices;                   ///< one code a triangle, tightly packed, little-endian
  std::vector<UsageCount> counts;  ///< after indirection, special indices left out
};

/// The options of append().
struct Options {
  Encoding encoding = Encoding::u32;
  std::uint32_t base_triangle = 0;
  bool deduplicate = true;  ///< equal level, format and states share one record
  bool special = true;      ///< a uniform map becomes a special index and needs no record
};

/// Adds a geometry's maps, in their order, to an array; linear in all bytes.
/// With `special`, a uniform map becomes a special index.  With `deduplicate`, another map takes the first equal record
/// from base_triangle on.  Else it gets a new record at the end, its bytes at the end of the data.  A triangle's index
/// is its record less base_triangle.
/// Domain: base_triangle at most the number of records, maps as PackedMap has them, else std::invalid_argument.  An
/// index that the encoding cannot hold, or data beyond 2^32 bytes: std::length_error, naming the triangle.  After an
/// error the array is as before.
/// Law: micromap.build, micromap.build_on_samples
Geometry append(Array& array, std::span<const PackedMap> maps, const Options& options);

/// The usage counts of an array's records: ordered by level, then format, none of them zero.
/// Law: micromap.build, micromap.build_on_samples
std::vector<UsageCount> usage_counts(std::span<const Record> records);

/// Records as bytes: 8 each, little-endian, tightly packed.
/// Law: micromap.build, micromap.build_on_samples
Bytes record_buffer(std::span<const Record> records);

/// The record at a byte.  Domain: at + 8 <= bytes.
/// Law: micromap.validate
Record record_at(std::span<const std::uint8_t> bytes, std::uint64_t at) noexcept;

}  // namespace mmverify::impl::micromap
