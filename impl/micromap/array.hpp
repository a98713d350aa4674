// The array of micromaps that a build takes: triangle records, data, usage counts, and a geometry's index
// buffer into it.
#pragma once

#include <vector>

#include "impl/micromap/micromap.hpp"

namespace mmverify::impl::micromap {

using Bytes = std::vector<std::uint8_t>;

/// Where a map's bytes are and how to read them.  Source: VkMicromapTriangleKHR.
struct Record {
  std::uint32_t offset;  ///< of its first byte in the data
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

/// What a micromap build takes.
struct Array {
  std::vector<Record> records;
  Bytes data;
};

/// What the build of a geometry takes beside the array.
struct Geometry {
  Bytes indices;                   ///< one code a triangle, tightly packed, little-endian
  std::vector<UsageCount> counts;  ///< after indirection, special indices left out
};

/// How maps become an array.
struct Options {
  Encoding encoding = Encoding::u32;
  std::uint32_t base_triangle = 0;
  bool deduplicate = true;  ///< equal level, format and states share one record
  bool special = true;      ///< a uniform map becomes a special index and needs no record
};

/// Adds a geometry's maps, in their order, to an array; linear in all bytes.
/// A map is a special index if it is uniform and that is wanted, else the first equal record from
/// base_triangle on if sharing is wanted, else a new record at the end, its bytes at the end of the data.  A
/// triangle's index is its record less base_triangle.
/// Domain: base_triangle at most the number of records, maps as PackedMap has them, else
/// std::invalid_argument. An index that the encoding cannot hold, or data beyond 2^32 bytes:
/// std::length_error, naming the triangle. After an error the array is as it was.
Geometry append(Array& array, std::span<const PackedMap> maps, const Options& options);

/// The array's usage counts, of its records: ordered by level, then format, none of them zero.
std::vector<UsageCount> usage_counts(std::span<const Record> records);

/// Records as bytes: 8 each, little-endian, tightly packed.
Bytes record_buffer(std::span<const Record> records);

/// The record at a byte.  Domain: at + 8 <= bytes.
Record record_at(std::span<const std::uint8_t> bytes, std::uint64_t at) noexcept;

}  // namespace mmverify::impl::micromap
