// The bytes of all maps of a set once packed (impl/attribute/compress.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// A coder to compare with: the bytes that it makes of some bytes.
using PeerCoder = std::function<std::uint64_t(std::span<const std::uint8_t>)>;

struct PackedBytes {
  std::uint64_t plain = 0;    ///< a byte a channel in use
  std::uint64_t packed = 0;   ///< with the error allowed
  std::uint64_t entropy = 0;  ///< order 0 of its roots and residuals, in whole bytes (residual_entropy)
  std::optional<std::uint64_t> peer;  ///< the peer's result for the plain bytes
  // The errors after decoding, over all codes of the maps, each different map once; in codes of 8 bits.
  std::uint8_t worst_error = 0;  ///< the greatest error of a code
  double rms_error = 0;          ///< root of the mean square
};

/// Packs maps as they are added, each different one once.
class MapPacker {
 public:
  /// `channels`: bit c is set if channel c is in use.
  MapPacker(MapKind kind, unsigned level, std::uint8_t channels, std::uint8_t error);

  /// Adds a map of MapBaker, and returns its number, which is that of the first equal map.  Vertices are
  /// given in rows, and are packed in the Bird order.
  std::uint32_t add(std::span<const MapValue> map);

  std::uint32_t maps() const { return maps_; }
  /// The codes map by map, value by value, channel by channel in use.
  const std::vector<std::uint8_t>& codes() const { return codes_; }

  /// The packed sizes; none if there are more codes than impl::attribute::pack takes at once.
  std::optional<PackedBytes> packed(const PeerCoder& peer) const;

 private:
  /// Fills in the errors.
  void measure_decoded(std::span<const std::uint8_t> decoded, PackedBytes& bytes) const;

  MapKind kind_;
  unsigned level_;
  std::vector<std::size_t> channels_;
  std::uint8_t error_;
  std::vector<std::uint32_t> rows_;                                ///< row index of a vertex, by Bird index
  std::vector<std::uint8_t> codes_;                                ///< of the maps, one after the other
  std::unordered_multimap<std::uint64_t, std::uint32_t> numbers_;  ///< numbers of maps, by the maps' hashes
  std::uint32_t maps_ = 0;
};

}  // namespace mmverify::scene
