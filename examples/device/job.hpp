// A micromap of one level and format, and the rays that ask it.
//
// A ray sees a state, and no index.  So each digit of the index has a map of its own: in map k the state of micro-triangle
// i is digit k of i, in base 2 for 2-state maps and in base 4 for 4-state maps.  The states of one point, read from all the
// maps, spell its index.  Each map lies on a triangle of its own, (0,0,z) (1,0,z) (0,1,z), where z is the triangle's
// number; four more triangles have special indices.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <vector>

#include "vector_file.hpp"

namespace rays {

/// The highest level of a job: 24 maps of 2 MiB each.
constexpr std::uint32_t most_level = 12;

enum State : std::uint32_t { transparent, opaque, unknown_transparent, unknown_opaque };

struct Job {
  std::uint32_t level = 0, format = 0;                ///< VkOpacityMicromapFormatEXT
  std::vector<std::uint8_t> data;                     ///< the maps
  std::vector<std::uint8_t> records;                  ///< VkMicromapTriangleEXT, `record_stride` bytes each
  std::uint32_t record_stride = 0, record_count = 0;  ///< the first record is used by no triangle
  std::vector<std::uint8_t> indices;                  ///< one a triangle; negative: a special index
  VkIndexType index_type = VK_INDEX_TYPE_UINT32;
  std::uint32_t index_stride = 0;
  std::uint32_t base = 0;                        ///< added to each index that is not special
  std::vector<VkMicromapUsageEXT> array_counts;  ///< the records by level and format
  std::vector<VkMicromapUsageEXT>
      geometry_counts;          ///< the triangles by the level and format of their records
  std::uint32_t maps = 0;       ///< triangles with a map; they come first
  std::uint32_t triangles = 0;  ///< `maps` and 4 with special indices: T, O, UT, UO
};

/// The number of states of a format: 2 or 4.
std::uint32_t states_of(std::uint32_t format);

/// The state of micro-triangle `index` in map `map`.  Level 0 has a map for each state.
State state_of(const Job& job, std::uint32_t map, std::uint32_t index);

/// The state that triangle `triangle` has at micro-triangle `index`.
State expected(const Job& job, std::uint32_t triangle, std::uint32_t index);

/// Domain: levels 0 to `most_level`.  The maps take level * 4^level / 4 bytes of host memory in either format.
Job make_job(std::uint32_t level, std::uint32_t format);

}  // namespace rays
