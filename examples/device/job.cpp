#include "job.hpp"

#include <cstring>

namespace rays {
namespace {

/// The four special indices by state.
constexpr std::array<std::int32_t, 4> special = {
    VK_OPACITY_MICROMAP_SPECIAL_INDEX_FULLY_TRANSPARENT_EXT,
    VK_OPACITY_MICROMAP_SPECIAL_INDEX_FULLY_OPAQUE_EXT,
    VK_OPACITY_MICROMAP_SPECIAL_INDEX_FULLY_UNKNOWN_TRANSPARENT_EXT,
    VK_OPACITY_MICROMAP_SPECIAL_INDEX_FULLY_UNKNOWN_OPAQUE_EXT};

// A record's place among the maps is a number of 32 bits.
static_assert(std::uint64_t{most_level} << 2 * most_level < std::uint64_t{4} << 32);

std::uint32_t bits_of(std::uint32_t format) { return states_of(format) / 2; }

/// Bits after the last state are 1, which a device must ignore.
std::vector<std::uint8_t> packed(const Job& job, std::uint32_t map) {
  const std::uint32_t bits = bits_of(job.format), per_byte = 8 / bits;
  const std::uint64_t count = std::uint64_t{1} << 2 * job.level;
  std::vector<std::uint8_t> bytes((count + per_byte - 1) / per_byte);
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (std::uint32_t k = 0; k < per_byte; ++k) {
      const std::uint64_t i = at * per_byte + k;
      const std::uint32_t value = i < count ? state_of(job, map, static_cast<std::uint32_t>(i)) : 3u;
      bytes[at] = static_cast<std::uint8_t>(bytes[at] | (value & ((1u << bits) - 1)) << bits * k);
    }
  return bytes;
}

void add_record(Job& job, std::uint32_t level, const std::vector<std::uint8_t>& states) {
  const VkMicromapTriangleEXT record{static_cast<std::uint32_t>(job.data.size()),
                                     static_cast<std::uint16_t>(level),
                                     static_cast<std::uint16_t>(job.format)};
  job.records.resize(job.records.size() + job.record_stride, 0xff);
  std::memcpy(&job.records[std::size_t{job.record_stride} * job.record_count++], &record, sizeof record);
  job.data.insert(job.data.end(), states.begin(), states.end());
}

std::uint32_t index_size(const Job& job) { return job.index_type == VK_INDEX_TYPE_UINT16 ? 2 : 4; }

/// Domain of 16-bit indices: the few records of a job, and the special indices, whose low half is kept.
void add_index(Job& job, std::int32_t index) {
  const auto bits = static_cast<std::uint32_t>(index);
  const std::size_t at = job.indices.size();
  job.indices.resize(at + job.index_stride);
  for (std::uint32_t k = 0; k < index_size(job); ++k)
    job.indices[at + k] = static_cast<std::uint8_t>(bits >> 8 * k);
}

}  // namespace

std::uint32_t states_of(std::uint32_t format) {
  return format == VK_OPACITY_MICROMAP_FORMAT_2_STATE_EXT ? 2 : 4;
}

State state_of(const Job& job, std::uint32_t map, std::uint32_t index) {
  if (job.level == 0) return State(map);
  const std::uint32_t bits = bits_of(job.format);
  return State(index >> bits * map & (states_of(job.format) - 1));
}

State expected(const Job& job, std::uint32_t triangle, std::uint32_t index) {
  return triangle < job.maps ? state_of(job, triangle, index) : State(triangle - job.maps);
}

Job make_job(std::uint32_t level, std::uint32_t format) {
  Job job;
  job.level = level;
  job.format = format;
  job.maps = level == 0 ? states_of(format) : 2 * level / bits_of(format);
  job.triangles = job.maps + static_cast<std::uint32_t>(special.size());
  // Both index types, each with two strides, and two strides of records occur in each format.
  const bool odd = (level + format) % 2 != 0;
  job.record_stride = odd ? 16 : 8;
  job.index_type = odd ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32;
  job.index_stride = index_size(job) * (level / 2 % 2 == 0 ? 1 : 2);
  job.base = 1;

  // No triangle uses record 0, which makes the two histograms differ; the last map comes first.
  add_record(job, 0, {0});
  for (std::uint32_t map = job.maps; map-- > 0;) add_record(job, level, packed(job, map));
  for (std::uint32_t map = 0; map < job.maps; ++map)
    add_index(job, static_cast<std::int32_t>(job.maps - 1 - map));
  for (const std::int32_t index : special) add_index(job, index);

  job.geometry_counts = {{job.maps, level, format}};
  job.array_counts = job.geometry_counts;
  if (level == 0)
    ++job.array_counts[0].count;
  else
    job.array_counts.push_back({1, 0, format});
  return job;
}

}  // namespace rays
