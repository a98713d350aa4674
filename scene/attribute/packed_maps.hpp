// What all maps of a set take when they are packed (impl/attribute/compress.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// Bytes that another coder makes of some.
using PeerCoder = std::function<std::uint64_t(std::span<const std::uint8_t>)>;

struct PackedBytes {
  std::uint64_t plain = 0;    ///< a byte a channel in use
  std::uint64_t packed = 0;   ///< with the error allowed
  std::uint64_t entropy = 0;  ///< order 0 of its roots and residuals, in whole bytes (residual_entropy)
  std::optional<std::uint64_t> peer;  ///< what the peer makes of the plain bytes
  // Of what is decoded again, over all codes of the maps, each different map once; in codes of 8 bits.
  std::uint8_t worst_error = 0;  ///< the most that a code is off
  double rms_error = 0;          ///< root of the mean square
};

/// Packs maps as they are added, each different one once.
class MapPacker {
 public:
  /// `channels`: bit c for channel c, the ones in use.
  MapPacker(MapKind kind, unsigned level, std::uint8_t channels, std::uint8_t error);

  /// A map as MapBaker makes it: vertices in rows; they are packed in the Bird order.  Returns its number: the one of the
  /// first that is equal.
  std::uint32_t add(std::span<const MapValue> map);

  std::uint32_t maps() const { return maps_; }
  /// Channel by channel in use, value by value, map by map.
  const std::vector<std::uint8_t>& codes() const { return codes_; }

  /// Nothing where all of them are more than impl::attribute::pack takes at once.
  std::optional<PackedBytes> packed(const PeerCoder& peer) const;

 private:
  /// Fills in the errors.
  void measure_decoded(std::span<const std::uint8_t> decoded, PackedBytes& bytes) const;

  MapKind kind_;
  unsigned level_;
  std::vector<std::size_t> channels_;
  std::uint8_t error_;
  std::vector<std::uint32_t> rows_;                                ///< of vertices, by Bird index
  std::vector<std::uint8_t> codes_;                                ///< of the maps, one after the other
  std::unordered_multimap<std::uint64_t, std::uint32_t> numbers_;  ///< of maps, by their hashes
  std::uint32_t maps_ = 0;
};

}  // namespace mmverify::scene
