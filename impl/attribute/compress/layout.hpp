// The places of all parts in packed maps of a shape.  Internal to impl.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "impl/attribute/compress.hpp"

namespace mmverify::impl::attribute::detail {

inline constexpr std::uint32_t triples_of_block = 16, blocks_of_start = 8, widest = 9;

/// The greatest number that a code up to 255 becomes: floor((255 + E) / (2E + 1)).
constexpr std::uint32_t last_number(std::uint32_t error) noexcept { return (255 + error) / (2 * error + 1); }

/// The Bird indices of a triangle's corners w, u, v.  A triple of vertices halves its edges w-v, u-v and w-u.
using TripleCorners = std::array<std::uint32_t, 3>;

class PackedLayout {
 public:
  /// Leaves out `corners`, which cost as much as a map: the bytes are checked before.
  /// Errors: std::invalid_argument for a shape out of its domain.
  explicit PackedLayout(const PackedShape& shape);
  void add_corners(const PackedShape& shape);

  std::uint32_t roots;                ///< roots of a map: 1 or 3
  std::uint32_t values;               ///< values of a map
  std::uint32_t residuals;            ///< values - roots: residuals of a channel
  std::vector<std::uint8_t> lengths;  ///< number of triples in each block of a map
  std::uint64_t blocks;               ///< blocks of all maps
  /// The first byte of starts, widths and bits; the roots begin at 0.
  std::uint64_t starts_at, widths_at, bits_at;
  std::array<std::uint32_t, max_packed_level + 2> first_triple{};  ///< by level; none for level 0
  std::array<std::uint32_t, max_packed_level + 2> first_block{};   ///< by level; 0 for levels 1 and 2
  std::vector<TripleCorners> corners;                              ///< by triple, for vertices

  /// The block of a triple within its map, and its place in the block.  Domain: triple k of those of level m.
  std::uint32_t block_of(std::uint32_t m, std::uint32_t k) const noexcept {
    return m <= 2 ? 0 : first_block[m] + k / triples_of_block;
  }
  std::uint32_t place_of(std::uint32_t m, std::uint32_t k) const noexcept {
    return m == 1 ? 0 : m == 2 ? first_triple[2] + k : k % triples_of_block;
  }
};

/// The corners of each triple of a map of this level, lower levels first.
std::vector<TripleCorners> triple_corners(std::uint32_t level);

}  // namespace mmverify::impl::attribute::detail
