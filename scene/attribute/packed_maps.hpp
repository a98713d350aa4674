// Maps of a set as a file stores them, and their bytes once packed (impl/attribute/compress.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "impl/attribute/container.hpp"
#include "scene/attribute/set_maps.hpp"

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

/// The maps as codes of the channels in use, numbered in the order of their triangles; vertices in the Bird order.
/// `error`: the most that a code may be off once packed.
impl::attribute::AttributeMaps coded(const SetMaps& maps, std::uint8_t error);

/// The sizes of coded maps beside `packed`, their pack().
PackedBytes packed_bytes(const impl::attribute::AttributeMaps& maps, std::span<const std::uint8_t> packed,
                         const PeerCoder& peer);

}  // namespace mmverify::scene
