#include "scene/attribute/packed_maps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace mmverify::scene {

using impl::attribute::AttributeMaps;

namespace {

AttributeMaps without_codes(const SetTriangles& triangles, MapKind kind, unsigned level, std::uint8_t error) {
  using namespace impl::attribute;
  AttributeMaps maps;
  maps.at = kind == MapKind::faces ? MapAt::faces : MapAt::vertices;
  maps.tie = kind == MapKind::faces ? TieRule::vulkan : TieRule::none;
  maps.level = level;
  maps.components = triangles.channels();
  maps.meaning = is_srgb(triangles.set())                  ? Meaning::srgb
                 : has(triangles.set(), Attribute::normal) ? Meaning::normal
                                                           : Meaning::linear;
  maps.payload = Payload::packed;
  std::fill_n(maps.error.begin(), impl::attribute::channels_of(maps), error);
  return maps;
}

/// The places of a map's values in MapBaker's order, by their places in the file's.
std::vector<std::uint32_t> baked_places(MapKind kind, unsigned level) {
  using impl::attribute::VertexOrder;
  std::vector<std::uint32_t> places(static_cast<std::size_t>(values_of_map(kind, level)));
  std::iota(places.begin(), places.end(), 0u);
  if (kind == MapKind::vertices)
    impl::attribute::convert(VertexOrder::bird, VertexOrder::w_minor, places, level, places);
  return places;
}

}  // namespace

AttributeMaps coded(const SetMaps& maps, std::uint8_t error) {
  AttributeMaps result = without_codes(maps.triangles, maps.kind, maps.level, error);
  const std::vector<std::uint32_t> places = baked_places(maps.kind, maps.level);
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> stored(maps.maps.count(), none);  // numbers in the file
  std::vector<MapValue> space;
  for (const std::uint32_t number : maps.number) {
    if (stored[number] == none) {
      stored[number] = result.maps++;
      const std::span<const MapValue> map = maps.maps.map(number, space);
      for (const std::uint32_t place : places)
        for (std::size_t c = 0; c < 4; ++c)
          if ((result.components >> c & 1) != 0) result.codes.push_back(map[place][c]);
    }
    result.triangles.push_back({stored[number], 0});
  }
  return result;
}

PackedBytes packed_bytes(const AttributeMaps& maps, std::span<const std::uint8_t> packed,
                         const PeerCoder& peer) {
  const impl::attribute::PackedShape shape = impl::attribute::shape_of(maps);
  PackedBytes bytes;
  bytes.plain = maps.codes.size();
  bytes.packed = packed.size();
  const std::vector<std::uint8_t> decoded = impl::attribute::PackedMaps(shape, packed).codes();
  std::uint64_t squares = 0;
  for (std::size_t k = 0; k < decoded.size(); ++k) {
    const int off = std::abs(decoded[k] - maps.codes[k]);
    bytes.worst_error = std::max(bytes.worst_error, static_cast<std::uint8_t>(off));
    squares += static_cast<std::uint64_t>(off) * static_cast<std::uint64_t>(off);
  }
  if (!decoded.empty())
    bytes.rms_error = std::sqrt(static_cast<double>(squares) / static_cast<double>(decoded.size()));
  bytes.entropy =
      static_cast<std::uint64_t>(std::ceil(impl::attribute::residual_entropy(shape, maps.codes) / 8));
  if (peer) bytes.peer = peer(maps.codes);
  return bytes;
}

}  // namespace mmverify::scene
