// Micromaps and geometries as the stand-in for a device builds them from memory, and what its rays meet there.
//
// It is stricter than a device: histograms must be those of the buffers, and each address must lie in a buffer.  The
// environment variable DEVICE_STAND_IN_FAULT plants one of the faults that answer() names.
#pragma once

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stand_in {

/// Whether the environment asks for this fault.
bool fault(const char* name);

/// Prints a complaint, and remembers that there was one.
void complain(const std::string& text);
/// Whether there was a complaint since the last call.
bool complained();

/// The buffers by their addresses; an address is a pointer of this process.
std::map<VkDeviceAddress, VkDeviceSize>& buffers();
/// The bytes there; null, with a complaint, unless they lie in one buffer.
const std::uint8_t* bytes_at(VkDeviceAddress address, VkDeviceSize size, const char* what);

/// Complains unless the address is a multiple of `alignment`.
void need_multiple(VkDeviceAddress address, VkDeviceSize alignment, const char* what);

using Histogram = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;  ///< level, format: count

struct Record {
  std::uint32_t level = 0, format = 0;
  std::vector<std::uint8_t> states;
};

struct Micromap {
  std::vector<Record> records;
  bool built = false;
};

struct Triangle {
  std::array<std::array<float, 3>, 3> corners{};
  std::int32_t special = 0;        ///< a special index, or 0
  const Record* record = nullptr;  ///< in the micromap, unless special
};

struct Structure {
  std::vector<Triangle> triangles;      ///< of a bottom level
  const Structure* instance = nullptr;  ///< of a top level
};

/// A copy of what VkMicromapBuildInfoEXT points to.
struct MicromapInput {
  VkMicromapBuildInfoEXT info{};
  std::vector<VkMicromapUsageEXT> counts;
};

/// A copy of what a geometry with a micromap points to.
struct GeometryInput {
  VkAccelerationStructureGeometryTrianglesDataKHR triangles{};
  VkAccelerationStructureTrianglesOpacityMicromapEXT opacity{};
  std::vector<VkMicromapUsageEXT> counts;
  std::uint32_t count = 0;
};

void build(const MicromapInput& input, Micromap& to);
void build(const GeometryInput& input, const Micromap& micromap, Structure& to);

/// The words that rays.comp writes for the ray of these words.
std::array<std::uint32_t, 4> answer(const Structure& scene, const std::array<std::uint32_t, 4>& ray);

}  // namespace stand_in
