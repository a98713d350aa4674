// The rules of micromap arrays: each rule's words, and the specifications that have it.  docs/MICROMAP.md adds the
// places.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace mmverify::impl::micromap {

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

/// A rule in words, and the specifications that have it.
struct RuleText {
  const char* id;
  Sets sets;
  const char* says;
};

/// The texts of the rules, in the order of Rule.
inline constexpr std::array<RuleText, rule_count> rules{{
    {"align.data_256", EXT, "the data's address is a multiple of 256"},
    {"align.records_256", EXT, "the records' address is a multiple of 256"},
    {"align.data_128", KHR | DXR, "the data's address is a multiple of 128"},
    {"align.records_128", KHR, "the records' address is a multiple of 128"},
    {"align.records_4", DXR, "the records' address is a multiple of 4"},
    {"align.index", DXR | glTF, "the indices' address is a multiple of an index's size"},
    {"stride.least", all_sets, "records lie at least 8 bytes apart"},
    {"stride.multiple", KHR | DXR, "the records' stride is a multiple of 4"},
    {"stride.tight", glTF, "records lie exactly 8 bytes apart"},
    {"records.size", all_sets, "the buffer holds every record"},
    {"records.whole", glTF, "the record buffer's size is a multiple of 8"},
    {"record.format", all_sets, "a record's format is 1 or 2"},
    {"record.level", EXT | KHR, "a record's level is within the device's limit for its format"},
    {"record.level_lossy", KHR, "a 4-state record of a lossy build is within the device's limit for those"},
    {"record.level_12", DXR | glTF, "a record's level is at most 12"},
    {"record.lossy_format", KHR, "a lossy build has 4-state records only"},
    {"record.region", all_sets, "a record's bytes lie within the data"},
    {"record.overlap", glTF, "no two records share a byte of the data"},
    {"counts.format", all_sets, "a usage count's format is 1 or 2"},
    {"counts.level", EXT | KHR, "a usage count's level is within the device's limit for its format"},
    {"counts.level_lossy", KHR,
     "a 4-state usage count of a lossy build is within the device's limit for those"},
    {"counts.level_12", DXR | glTF, "a usage count's level is at most 12"},
    {"counts.lossy_format", KHR, "a lossy build has 4-state usage counts only"},
    {"counts.zero", glTF, "a usage count is at least 1"},
    {"counts.limit", KHR, "the usage counts add up to at most maxMicromapTriangles"},
    {"counts.array", all_sets, "for each level and format, the array's usage counts add up to its records"},
    {"counts.array_is_geometry", all_sets, "the array's usage counts are not the geometry's"},
    {"counts.geometry", EXT,
     "for each level and format, the geometry's usage counts add up to its triangles after indirection, "
     "special indices left out"},
    {"counts.geometry_is_array", EXT, "the geometry's usage counts are not the array's"},
    {"index.encoding", EXT | KHR | DXR, "the index type is one that the API has"},
    {"index.stride", EXT | KHR | DXR, "the indices' stride is a multiple of an index's size"},
    {"index.stride_most", EXT | KHR, "the indices' stride is below 2^32"},
    {"index.tight", glTF, "indices are tightly packed"},
    {"index.size", all_sets, "the buffer holds an index for every triangle"},
    {"index.count", glTF, "there are no more indices than triangles"},
    {"index.special", glTF, "a signed index is at least -4"},
    {"index.range", all_sets, "a plain index plus baseTriangle is less than the number of records"},
}};

constexpr const RuleText& text(Rule rule) noexcept { return rules[static_cast<std::size_t>(rule)]; }

}  // namespace mmverify::impl::micromap
