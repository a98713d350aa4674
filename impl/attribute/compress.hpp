// Packed attribute micromaps: lossless, or with a bound on each value's error.  Any value can be read alone.
//
// Each level is stored as its differences from a prediction by the level below, in blocks of up to 48 numbers with one
// width a channel.  The bytes, and which are canonical: spec/attribute/compress.hpp, docs/ATTRIBUTE_COMPRESSION.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace mmverify::impl::attribute {

/// The places of a map's values: micro-triangles along the curve, or micro-vertices in the Bird order.
enum class MapAt : std::uint32_t { faces, vertices };

inline constexpr std::uint32_t max_packed_level = 12, max_packed_error = 127;

/// The shape of packed maps, which their bytes do not tell.
struct PackedShape {
  MapAt at = MapAt::faces;
  std::uint32_t level = 0;     ///< 0..12
  std::uint32_t channels = 4;  ///< 1..4
  std::uint32_t maps = 1;      ///< all of this shape; maps x values x channels below 2^31
  std::array<std::uint8_t, 4> error =
      {};  ///< greatest error of a code, by channel: 0..127; 0 for absent channels
  friend bool operator==(const PackedShape&, const PackedShape&) = default;
};

/// The number of values of a map: 4^level, or V(level).  Domain: level in 0..12.
std::uint64_t values_of_map(MapAt at, std::uint32_t level) noexcept;

/// Bytes of the maps unpacked: maps x values x channels.  Domain: a shape as above, or std::invalid_argument.
std::uint64_t plain_bytes(const PackedShape& shape);

/// The error for bytes that are no packed maps: "byte 12: width 11; 0 to 9 would do".
class BadPacked : public std::runtime_error {
 public:
  BadPacked(std::uint64_t byte, const std::string& found, const std::string& would_do);
  std::uint64_t byte() const noexcept { return byte_; }
  const std::string& found() const noexcept { return found_; }
  const std::string& would_do() const noexcept { return would_do_; }

 private:
  std::uint64_t byte_;
  std::string found_, would_do_;
};

/// The packed maps of codes, where channel c of value x of map m is codes[(m values + x) channels + c].  Their size:
///   M R C + 4 ceil(B/8) + ceil(B C / 2) + ceil(bits / 8)   for M maps, R roots, C channels, B blocks
/// If all errors are 0 they unpack to the codes, else to codes that are off by `error` at most.  Noise takes 9/8 of the
/// plain bytes, plus the widths: such maps are smaller plain.
/// Time: O(codes).  Errors: std::invalid_argument for another number of codes, a shape out of its domain, or residuals
/// of 2^32 bits and more.
/// Law: attribute.packed_round_trip, attribute.packed_within_error, attribute.packed_size
std::vector<std::uint8_t> pack(const PackedShape& shape, std::span<const std::uint8_t> codes);

namespace detail {
class PackedLayout;
}

/// Packed maps, checked once and read at will.  Many threads may read them at once.
class PackedMaps {
 public:
  /// Accepts what pack() writes and nothing else: pack(shape, codes()) gives back the very bytes.
  /// The bytes must outlive it.  Memory: for one map, a byte for each block and 4 for each vertex; during the check its
  /// residuals, too.
  /// Errors: BadPacked, with the first byte that is wrong; std::invalid_argument as plain_bytes().
  /// Law: attribute.packed_canonical
  PackedMaps(const PackedShape& shape, std::span<const std::uint8_t> bytes);
  ~PackedMaps();
  PackedMaps(PackedMaps&&) noexcept;
  PackedMaps& operator=(PackedMaps&&) noexcept;

  const PackedShape& shape() const noexcept { return shape_; }

  /// The codes of one map.  Domain: map < maps, out.size() = values x channels, or std::invalid_argument.
  /// Law: attribute.packed_round_trip, attribute.packed_within_error
  void map(std::uint32_t map, std::span<std::uint8_t> out) const;
  /// The codes of all maps, in order.
  /// Law: attribute.packed_round_trip, attribute.packed_within_error
  std::vector<std::uint8_t> codes() const;

  /// One value: a code for each channel, 0 for channels that are not there.  It reads one block for each level, and the
  /// widths of up to 7 blocks.  A value of a lower level of faces is within half a code of the mean of its four
  /// children, errors apart.
  /// Domain: map < maps, level <= the shape's level, index < values of that level; else some value.
  /// Law: attribute.packed_random_access
  std::array<std::uint8_t, 4> value(std::uint32_t map, std::uint32_t level,
                                    std::uint32_t index) const noexcept;
  std::array<std::uint8_t, 4> value(std::uint32_t map, std::uint32_t index) const noexcept {
    return value(map, shape_.level, index);
  }

 private:
  PackedShape shape_;
  std::unique_ptr<const detail::PackedLayout> layout_;
  std::span<const std::uint8_t> bytes_;
};

/// The order-0 entropy in bits: the least size for a coder that knows only how often each residual occurs in each
/// channel:
///   sum over channels of -sum over residuals r of count(r) log2(count(r) / all), and the same of the roots
/// The frequencies themselves are not counted.  pack() may take fewer bits, for its widths follow the place.
/// Domain, errors: as pack().
/// Test: impl_attribute_compress_test
double residual_entropy(const PackedShape& shape, std::span<const std::uint8_t> codes);

}  // namespace mmverify::impl::attribute
