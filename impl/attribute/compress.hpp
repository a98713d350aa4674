// Attribute micromaps packed: lossless, or within an error that is kept at every value; one value is read without the
// rest.
//
// Each level is stored as what it differs by from what the level below says of it, in blocks of up to 48 numbers that
// have one width a channel.  The bytes, and which are canonical: spec/attribute/compress.hpp, docs/ATTRIBUTE_COMPRESSION.md.
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

/// What a map has its values at: micro-triangles along the curve, or micro-vertices in the Bird order.
enum class MapAt : std::uint32_t { faces, vertices };

inline constexpr std::uint32_t max_packed_level = 12, max_packed_error = 127;

/// What is known of maps beside their bytes.
struct PackedShape {
  MapAt at = MapAt::faces;
  std::uint32_t level = 0;     ///< 0..12
  std::uint32_t channels = 4;  ///< 1..4
  std::uint32_t maps = 1;      ///< all of this shape; maps x values x channels below 2^31
  std::array<std::uint8_t, 4> error =
      {};  ///< the most that a code of each channel may be off, 0..127; of no channel 0
  friend bool operator==(const PackedShape&, const PackedShape&) = default;
};

/// Values of a map: 4^level, or V(level).  Domain: level in 0..12.
std::uint64_t values_of_map(MapAt at, std::uint32_t level) noexcept;

/// Bytes of the maps unpacked: maps x values x channels.  Domain: a shape as above, or std::invalid_argument.
std::uint64_t plain_bytes(const PackedShape& shape);

/// Bytes that are no packed maps: "byte 12: width 11; 0 to 9 would do".
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

/// The bytes of maps: channel c of value x of map m at codes[(m values + x) channels + c].
///   M R C + 4 ceil(B/8) + ceil(B C / 2) + ceil(bits / 8)   of M maps, R roots, C channels, B blocks
/// With errors all 0 they hold the codes; else codes that are that much off at most.  Noise takes 9/8 of the plain bytes
/// and the widths'; whoever stores may take the plain ones instead.
/// Time: O(codes).  Errors: std::invalid_argument for another number of codes, a shape out of its domain, or residuals of
/// 2^32 bits and more.
std::vector<std::uint8_t> pack(const PackedShape& shape, std::span<const std::uint8_t> codes);

namespace detail {
class PackedLayout;
}

/// Packed maps, checked once and read at will, by many threads at once.
class PackedMaps {
 public:
  /// Accepts what pack() writes and nothing else: pack(shape, codes()) gives back the very bytes.
  /// The bytes must outlive it.  Memory: a byte a block of one map, 4 a vertex of it; a map's residuals while it checks.
  /// Errors: BadPacked, with the first byte that is wrong; std::invalid_argument as plain_bytes().
  PackedMaps(const PackedShape& shape, std::span<const std::uint8_t> bytes);
  ~PackedMaps();
  PackedMaps(PackedMaps&&) noexcept;
  PackedMaps& operator=(PackedMaps&&) noexcept;

  const PackedShape& shape() const noexcept { return shape_; }

  /// The codes of one map.  Domain: map < maps, out.size() = values x channels, or std::invalid_argument.
  void map(std::uint32_t map, std::span<std::uint8_t> out) const;
  /// Those of all.
  std::vector<std::uint8_t> codes() const;

  /// One value, a code a channel and 0 beyond: one block a level is read, and up to 7 blocks' widths.
  /// Of faces also the values of lower levels, each within half a code of the mean of its four, errors apart.
  /// Domain: map < maps, level <= that of the shape, index < values of that level; else some value.
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

/// What a coder of the residuals that knows each channel's frequencies, and nothing else of them, could not go below:
///   sum over channels of -sum over residuals r of count(r) log2(count(r) / all), and the same of the roots
/// Order-0 entropy, in bits; the frequencies themselves are not in it.  pack() may go below, for its widths follow the
/// place.  Domain, errors: as pack().
double residual_entropy(const PackedShape& shape, std::span<const std::uint8_t> codes);

}  // namespace mmverify::impl::attribute
