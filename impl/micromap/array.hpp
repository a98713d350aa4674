// The array of micromaps that a build takes: triangle records, data and usage counts.  array::build() makes it.
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
