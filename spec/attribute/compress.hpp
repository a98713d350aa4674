// Maps as bytes: codes, quantised if an error is allowed, as roots and residuals, these in blocks of one width each.
//
//   roots     maps x roots x channels bytes
//   starts    a word of 32 bits, little-endian, for every 8 blocks: the bit where the first of them begins
//   widths    half a byte a block and channel, low half first
//   bits      block by block, channel by channel, residuals of `width` bits, low bit first
// each of the last two in whole bytes, unused bits 0.  All maps are of one shape; their blocks follow one another.
//
// A block is up to 16 triples of one level: for faces, 64 values of a level that are neighbours on the curve.  Levels 1
// and 2, which have 5 triples or 4, are one block.  So a value needs one block a level.
// Source: ours.  Frame of reference and bit packing: Zukowski et al. 2006, with 0 as the reference.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "spec/attribute/compress_residuals.hpp"

namespace mmverify::spec::attribute {

// ---- Codes

/// The number of a code, for an error bound E: the nearest multiple of 2E+1, which is E off at most; back, 255 at most.
///   number(x) = floor((x+E) / (2E+1)),   code(k) = min(255, (2E+1) k),   |code(number(x)) - x| <= E
/// Predictions are made of these numbers, which a decoder has: the loop is closed, and errors do not add up.  E = 0
/// loses nothing.
/// Domain: codes 0..255, E in 0..127.
constexpr std::int32_t number_of_code(std::int32_t code, std::int32_t error) {
  return (code + error) / (2 * error + 1);
}
constexpr std::int32_t code_of_number(std::int32_t number, std::int32_t error) {
  return std::min(255, (2 * error + 1) * number);
}
/// The greatest number of a code.
constexpr std::int32_t last_number(std::int32_t error) { return number_of_code(255, error); }

/// The shape of packed maps, which their bytes do not tell.
struct PackedShape {
  MapAt at = MapAt::faces;
  Level level = 0;                         ///< 0..12
  std::uint32_t channels = 4;              ///< 1..4
  std::uint32_t maps = 1;                  ///< all of this shape
  std::array<std::uint8_t, 4> error = {};  ///< E of each channel, 0..127; of no channel 0
};

// ---- Blocks

inline constexpr std::uint32_t triples_of_block = 16, blocks_of_start = 8;

/// The number of triples of each block of a map.  Domain: n in 0..12.
inline std::vector<std::uint32_t> block_lengths(MapAt at, Level n) {
  std::vector<std::uint32_t> lengths;
  if (n > 0)
    lengths.push_back(static_cast<std::uint32_t>(triples_of(at, 1) + (n > 1 ? triples_of(at, 2) : 0)));
  for (Level m = 3; m <= n; ++m)
    for (std::uint64_t left = triples_of(at, m); left > 0;) {
      const std::uint64_t taken = std::min<std::uint64_t>(left, triples_of_block);
      lengths.push_back(static_cast<std::uint32_t>(taken));
      left -= taken;
    }
  return lengths;
}

/// A residual as an unsigned number, small if the residual is: 0, -1, 1, -2, ... become 0, 1, 2, 3, ...
constexpr std::uint32_t folded(std::int32_t residual) {
  return static_cast<std::uint32_t>(residual >= 0 ? 2 * residual : -2 * residual - 1);
}
constexpr std::int32_t unfolded(std::uint32_t number) {
  const auto half = static_cast<std::int32_t>(number / 2);
  return number % 2 == 0 ? half : -half - 1;
}

/// The bits of a number: 0 to 9, as a residual lies within -255..255.
constexpr std::uint32_t bits_for(std::uint32_t number) {
  std::uint32_t bits = 0;
  for (; number != 0; number /= 2) ++bits;
  return bits;
}
inline constexpr std::uint32_t widest = 9;

/// The width of each block and channel of each map, in the order of the bytes.
using Widths = std::vector<std::uint32_t>;

/// The bits of all blocks: 3 triples (w_0 + w_1 + ...) each.
inline std::uint64_t bits_of_blocks(const PackedShape& shape, const Widths& widths) {
  const auto lengths = block_lengths(shape.at, shape.level);
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < widths.size(); ++k)
    bits += std::uint64_t{3} * lengths[k / shape.channels % lengths.size()] * widths[k];
  return bits;
}

/// The size of packed maps in bytes: M maps of C channels, R roots and K blocks, B = M K:
///   M R C + 4 ceil(B/8) + ceil(B C / 2) + ceil(bits / 8)
inline std::uint64_t packed_size(const PackedShape& shape, const Widths& widths) {
  const std::uint64_t blocks = shape.maps * std::uint64_t{block_lengths(shape.at, shape.level).size()};
  const auto up = [](std::uint64_t x, std::uint64_t by) { return (x + by - 1) / by; };
  return shape.maps * roots_of(shape.at) * shape.channels + 4 * up(blocks, blocks_of_start) +
         up(blocks * shape.channels, 2) + up(bits_of_blocks(shape, widths), 8);
}

// ---- Bytes

namespace detail {

/// A string of numbers of given widths, one after the other, low bit first.
class BitString {
 public:
  explicit BitString(std::vector<bool> bits = {}) : bits_(std::move(bits)) {}
  static BitString of_bytes(std::span<const std::uint8_t> bytes) {
    std::vector<bool> bits;
    for (const std::uint8_t byte : bytes)
      for (unsigned k = 0; k < 8; ++k) bits.push_back((byte >> k & 1) != 0);
    return BitString(std::move(bits));
  }
  void put(std::uint32_t number, std::uint32_t width) {
    for (std::uint32_t k = 0; k < width; ++k) bits_.push_back((number >> k & 1) != 0);
  }
  std::uint32_t take(std::uint32_t width) {
    std::uint32_t number = 0;
    for (std::uint32_t k = 0; k < width; ++k) number |= (bits_[taken_++] ? 1u : 0u) << k;
    return number;
  }
  std::uint64_t size() const { return bits_.size(); }
  std::vector<std::uint8_t> bytes() const {
    std::vector<std::uint8_t> bytes((bits_.size() + 7) / 8);
    for (std::size_t k = 0; k < bits_.size(); ++k)
      if (bits_[k]) bytes[k / 8] = static_cast<std::uint8_t>(bytes[k / 8] | 1u << k % 8);
    return bytes;
  }

 private:
  std::vector<bool> bits_;
  std::size_t taken_ = 0;
};

}  // namespace detail

/// The widths of the maps' blocks.  Domain: as pack().
inline Widths widths_of(const PackedShape& shape, const std::vector<Residuals>& channels_of_maps) {
  const auto lengths = block_lengths(shape.at, shape.level);
  Widths widths;
  for (std::uint32_t map = 0; map < shape.maps; ++map) {
    std::size_t first = 0;
    for (const std::uint32_t length : lengths) {
      for (std::uint32_t c = 0; c < shape.channels; ++c) {
        std::uint32_t width = 0;
        for (std::size_t k = first; k < first + 3 * std::size_t{length}; ++k)
          width = std::max(width, bits_for(folded(channels_of_maps[map * shape.channels + c].levels[k])));
        widths.push_back(width);
      }
      first += 3 * std::size_t{length};
    }
  }
  return widths;
}

/// The residuals of all channels of all maps, in this order.  Domain: as pack().
inline std::vector<Residuals> all_residuals(const PackedShape& shape, std::span<const std::uint8_t> codes) {
  const auto values = static_cast<std::size_t>(values_of(shape.at, shape.level));
  std::vector<Residuals> all;
  for (std::uint32_t map = 0; map < shape.maps; ++map)
    for (std::uint32_t c = 0; c < shape.channels; ++c) {
      std::vector<std::int32_t> numbers;
      for (std::size_t x = 0; x < values; ++x)
        numbers.push_back(number_of_code(codes[(map * values + x) * shape.channels + c], shape.error[c]));
      all.push_back(residuals_of(shape.at, shape.level, numbers));
    }
  return all;
}

/// The bytes of maps.  codes: channel c of value x of map m is at ((m values + x) channels + c), values in the order of
/// their kind.  Domain: a shape in its domain; codes of that size; bits below 2^32.
inline std::vector<std::uint8_t> pack(const PackedShape& shape, std::span<const std::uint8_t> codes) {
  const std::vector<Residuals> all = all_residuals(shape, codes);
  const Widths widths = widths_of(shape, all);
  const auto lengths = block_lengths(shape.at, shape.level);
  detail::BitString starts, halves, bits;
  std::vector<std::uint8_t> bytes;
  std::size_t block = 0;
  for (std::uint32_t map = 0; map < shape.maps; ++map) {
    const Residuals* const channels = &all[std::size_t{map} * shape.channels];
    for (std::size_t root = 0; root < roots_of(shape.at); ++root)
      for (std::uint32_t c = 0; c < shape.channels; ++c)
        bytes.push_back(static_cast<std::uint8_t>(channels[c].roots[root]));
    std::size_t first = 0;
    for (const std::uint32_t length : lengths) {
      if (block % blocks_of_start == 0) starts.put(static_cast<std::uint32_t>(bits.size()), 32);
      for (std::uint32_t c = 0; c < shape.channels; ++c) {
        const std::uint32_t width = widths[block * shape.channels + c];
        halves.put(width, 4);
        for (std::size_t k = first; k < first + 3 * std::size_t{length}; ++k)
          bits.put(folded(channels[c].levels[k]), width);
      }
      first += 3 * std::size_t{length};
      ++block;
    }
  }
  for (const detail::BitString* part : {&starts, &halves, &bits}) {
    const auto more = part->bytes();
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  return bytes;
}

/// The codes of bytes; nothing if pack() has no codes that give these very bytes, which is checked at the end.
/// Domain: any bytes, a shape in its domain.
inline std::optional<std::vector<std::uint8_t>> unpack(const PackedShape& shape,
                                                       std::span<const std::uint8_t> bytes) {
  const auto lengths = block_lengths(shape.at, shape.level);
  const std::uint64_t C = shape.channels, blocks = shape.maps * std::uint64_t{lengths.size()};
  const std::uint64_t roots = shape.maps * roots_of(shape.at) * C, starts = (blocks + 7) / 8 * 4;
  const std::uint64_t halves = (blocks * C + 1) / 2;
  if (bytes.size() < roots + starts + halves) return std::nullopt;
  const auto part = [&](std::uint64_t from, std::uint64_t size) {
    return bytes.subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(size));
  };
  auto half = detail::BitString::of_bytes(part(roots + starts, halves));
  Widths widths;
  for (std::uint64_t k = 0; k < blocks * C; ++k) widths.push_back(half.take(4));
  if (std::any_of(widths.begin(), widths.end(), [](std::uint32_t w) { return w > widest; }))
    return std::nullopt;
  if (bytes.size() != packed_size(shape, widths)) return std::nullopt;
  auto bits =
      detail::BitString::of_bytes(part(roots + starts + halves, bytes.size() - roots - starts - halves));
  const auto values = static_cast<std::size_t>(values_of(shape.at, shape.level));
  std::vector<std::uint8_t> codes(shape.maps * values * C);
  std::size_t root = 0, block = 0;
  for (std::uint32_t map = 0; map < shape.maps; ++map) {
    std::vector<Residuals> channels(C);
    for (std::uint64_t r = 0; r < roots_of(shape.at); ++r)
      for (std::size_t c = 0; c < C; ++c) channels[c].roots.push_back(bytes[root++]);
    for (const std::uint32_t length : lengths) {
      for (std::size_t c = 0; c < C; ++c)
        for (std::uint32_t k = 0; k < 3 * length; ++k)
          channels[c].levels.push_back(unfolded(bits.take(widths[block * C + c])));
      ++block;
    }
    for (std::size_t c = 0; c < C; ++c) {
      const auto numbers = values_from(shape.at, shape.level, channels[c]);
      for (std::size_t x = 0; x < values; ++x) {
        if (numbers[x] < 0 || numbers[x] > last_number(shape.error[c])) return std::nullopt;
        codes[(map * values + x) * C + c] =
            static_cast<std::uint8_t>(code_of_number(numbers[x], shape.error[c]));
      }
    }
  }
  const auto again = pack(shape, codes);
  if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end())) return std::nullopt;
  return codes;
}

}  // namespace mmverify::spec::attribute
