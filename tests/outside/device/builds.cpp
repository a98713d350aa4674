#include "tests/outside/device/builds.hpp"

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "impl/index/index.hpp"

namespace stand_in {
namespace {

bool any_complaint = false;

Histogram histogram_of(const std::vector<VkMicromapUsageEXT>& counts) {
  Histogram found;
  for (const VkMicromapUsageEXT& usage : counts) found[{usage.subdivisionLevel, usage.format}] += usage.count;
  return found;
}

std::size_t bytes_of(const VkMicromapTriangleEXT& record) {
  const std::size_t bits = std::size_t{record.format} << 2 * record.subdivisionLevel;
  return (bits + 7) / 8;
}

/// The index of a triangle; a special one is negative.  None, with a complaint, where its type is none of EXT's.
std::optional<std::int32_t> index_at(const std::uint8_t* at, VkIndexType type) {
  if (type == VK_INDEX_TYPE_UINT16) {
    std::uint16_t index;
    std::memcpy(&index, at, sizeof index);
    return index >= 0xfffc ? static_cast<std::int16_t>(index) : static_cast<std::int32_t>(index);
  }
  if (type == VK_INDEX_TYPE_UINT32) {
    std::int32_t index;
    std::memcpy(&index, at, sizeof index);
    return index;
  }
  complain("an index type that micromaps do not have");
  return std::nullopt;
}

/// The micro-triangle of a hit, with the planted faults of index functions.
std::uint32_t index_of(float u, float v, std::uint32_t level) {
  namespace index = mmverify::impl::index;
  if (fault("exchanged")) std::swap(u, v);
  if (fault("half_precision")) {  // 11 bits, as binary16 has
    u = std::bit_cast<float>(std::bit_cast<std::uint32_t>(u) & 0xffffe000u);
    v = std::bit_cast<float>(std::bit_cast<std::uint32_t>(v) & 0xffffe000u);
  }
  if (fault("drift")) u = u + 0x1p-12f;
  return fault("rows") ? index::w_minor(u, v, level) : index::from_barycentrics(u, v, level);
}

/// 0 T, 1 O, 2 UT, 3 UO.
std::uint32_t state_at(const Triangle& triangle, float u, float v) {
  if (triangle.special != 0) {
    const auto state = static_cast<std::uint32_t>(-1 - triangle.special);
    return fault("specials") && state >= 2 ? 5 - state : state;
  }
  const Record& record = *triangle.record;
  const std::uint32_t bits = record.format, per_byte = 8 / bits, index = index_of(u, v, record.level);
  std::uint32_t place = index % per_byte;
  if (fault("bit_order")) place = per_byte - 1 - place;
  return record.states[index / per_byte] >> bits * place & ((1u << bits) - 1);
}

struct Crossing {
  const Triangle* triangle;
  float u, v;
};

/// The triangle that a ray along z meets within half a unit of `z`.
std::optional<Crossing> crossing(const Structure& bottom, double x, double y, double z) {
  for (const Triangle& triangle : bottom.triangles) {
    const auto& [a, b, c] = triangle.corners;
    if (std::abs(a[2] - z) > 0.5) continue;
    const double bx = double{b[0]} - a[0], by = double{b[1]} - a[1], cx = double{c[0]} - a[0],
                 cy = double{c[1]} - a[1];
    const double px = x - a[0], py = y - a[1], area = bx * cy - by * cx;
    const double u = (px * cy - py * cx) / area, v = (bx * py - by * px) / area;
    if (u < 0 || v < 0 || u + v > 1) continue;
    return Crossing{&triangle, static_cast<float>(u), static_cast<float>(v)};
  }
  return std::nullopt;
}

}  // namespace

bool fault(const char* name) {
  static const char* const asked = std::getenv("DEVICE_STAND_IN_FAULT");
  return asked != nullptr && std::strcmp(asked, name) == 0;
}

void complain(const std::string& text) {
  any_complaint = true;
  std::fprintf(stderr, "stand-in: %s\n", text.c_str());
}

bool complained() { return std::exchange(any_complaint, false); }

std::map<VkDeviceAddress, VkDeviceSize>& buffers() {
  static std::map<VkDeviceAddress, VkDeviceSize> all;
  return all;
}

const std::uint8_t* bytes_at(VkDeviceAddress address, VkDeviceSize size, const char* what) {
  auto after = buffers().upper_bound(address);
  if (after != buffers().begin()) {
    const auto& [start, length] = *--after;
    if (address - start <= length && size <= length - (address - start))
      return reinterpret_cast<const std::uint8_t*>(address);
  }
  complain(std::string(what) + " are read beyond the end of their buffer");
  return nullptr;
}

void need_multiple(VkDeviceAddress address, VkDeviceSize alignment, const char* what) {
  if (const VkDeviceAddress rest = address % alignment; rest != 0)
    complain("the address of " + std::string(what) + " is " + std::to_string(rest) + " above a multiple of " +
             std::to_string(alignment));
}

void build(const MicromapInput& input, Micromap& to) {
  const VkMicromapBuildInfoEXT& info = input.info;
  // VUID-vkCmdBuildMicromapsEXT-pInfos-07515
  need_multiple(info.triangleArray.deviceAddress, 256, "the records");
  need_multiple(info.data.deviceAddress, 256, "the states");
  std::uint32_t count = 0;
  for (const VkMicromapUsageEXT& usage : input.counts) count += usage.count;
  Histogram found;
  for (std::uint32_t k = 0; k < count; ++k) {
    VkMicromapTriangleEXT record;
    const auto* at =
        bytes_at(info.triangleArray.deviceAddress + k * info.triangleArrayStride, sizeof record, "records");
    if (at == nullptr) return;
    std::memcpy(&record, at, sizeof record);
    if ((record.format != 1 && record.format != 2) || record.subdivisionLevel > 12)
      return complain("record " + std::to_string(k) + " has format " + std::to_string(record.format) +
                      ", level " + std::to_string(record.subdivisionLevel));
    const auto* states = bytes_at(info.data.deviceAddress + record.dataOffset, bytes_of(record), "states");
    if (states == nullptr) return;
    to.records.push_back({record.subdivisionLevel, record.format, {states, states + bytes_of(record)}});
    ++found[{record.subdivisionLevel, record.format}];
  }
  if (found != histogram_of(input.counts))
    return complain("the usage counts of the micromap are not its records'");
  to.built = true;
}

void build(const GeometryInput& input, const Micromap& micromap, Structure& to) {
  const auto& opacity = input.opacity;
  Histogram found;
  for (std::uint32_t k = 0; k < input.count; ++k) {
    Triangle triangle;
    const auto* corners =
        bytes_at(input.triangles.vertexData.deviceAddress + 3 * k * input.triangles.vertexStride,
                 sizeof triangle.corners, "vertices");
    const std::size_t index_size = opacity.indexType == VK_INDEX_TYPE_UINT16 ? 2 : 4;
    const auto* place = bytes_at(
        opacity.indexBuffer.deviceAddress + k * (fault("index_stride") ? index_size : opacity.indexStride),
        index_size, "indices");
    if (corners == nullptr || place == nullptr) return;
    std::memcpy(&triangle.corners, corners, sizeof triangle.corners);
    const auto index = index_at(place, opacity.indexType);
    if (!index) return;
    if (*index < 0) {
      triangle.special = *index;
      if (*index < -4)
        return complain("triangle " + std::to_string(k) + " has index " + std::to_string(*index));
    } else {
      const std::uint64_t record =
          static_cast<std::uint32_t>(*index) + std::uint64_t{fault("base") ? 0 : opacity.baseTriangle};
      if (record >= micromap.records.size())
        return complain("triangle " + std::to_string(k) + " refers to record " + std::to_string(record) +
                        " of " + std::to_string(micromap.records.size()));
      triangle.record = &micromap.records[record];
      ++found[{triangle.record->level, triangle.record->format}];
    }
    to.triangles.push_back(triangle);
  }
  if (!fault("base") && !fault("index_stride") && found != histogram_of(input.counts))
    complain("the usage counts of the geometry are not its triangles'");
}

std::array<std::uint32_t, 4> answer(const Structure& scene, const std::array<std::uint32_t, 4>& ray) {
  enum Outcome : std::uint32_t { missed, met_opaque, asked, both };
  if (scene.instance == nullptr) return {missed, missed, 0, 0};
  const auto met =
      crossing(*scene.instance, std::bit_cast<float>(ray[0]), std::bit_cast<float>(ray[1]), ray[2]);
  if (!met) return {missed, missed, 0, 0};
  constexpr std::array plain = {missed, met_opaque, asked, asked},
                       forced = {missed, met_opaque, missed, met_opaque};
  const float shift = fault("shifted") ? 0x1p-12f : 0;  // in what is looked up and in what is said
  const float u = met->u + shift, v = met->v;
  const std::uint32_t state = state_at(*met->triangle, u, v);
  std::array<std::uint32_t, 4> words = {plain[state], fault("forced") ? plain[state] : forced[state], 0, 0};
  if (plain[state] != met_opaque) return words;
  if (fault("both")) words[0] = both;
  words[2] = std::bit_cast<std::uint32_t>(fault("reported") ? v : u);
  words[3] = fault("nan") && v > u ? ~0u : std::bit_cast<std::uint32_t>(v);
  return words;
}

}  // namespace stand_in
