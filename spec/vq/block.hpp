// VQ2 and VQ4: blocks of 256 and 512 bits, and their maps of 16x16 and 32x32 regions.
//
// The bits of a block, from bit 0 of byte 0 up.  The order is ours: the figures show the fields alone.
//              VQ2               VQ4
//   indices    64 of 3 bits      64 of 4       of the vector (X, Y) of the map, X + 8 Y
//   transforms  3 of 3            3 of 3       of TR, BL and BR, by their number in table 1
//   codebook   11 of 5           247 bits      VQ2: the entries 3, 4, 5, then 6 and 7 of TL, TR, BL, BR
//   in all     256               512           VQ4: the entries 3..15 as table 2 has them
// An index of 0, 1, 2 is the uniform vector of T, C, O.  Quadrants: L has X < 4, B has Y < 4; TL is never
// transformed.
// Source: Compressed Opacity Maps, 4, 4.1, 5.1, table 2, figure 11.
#pragma once

#include <array>
#include <cstdint>

#include "spec/vq/vq.hpp"

namespace mmverify::spec::vq {

enum class Quadrant : std::uint8_t { TL, TR, BL, BR };

/// The quadrant of the vector (X, Y), each below 8.
constexpr Quadrant quadrant_of(std::uint32_t x, std::uint32_t y) {
  return static_cast<Quadrant>((x < 4 ? 0 : 1) + (y < 4 ? 2 : 0));
}

/// The fields of a block of VQ2.  An entry of the codebook is its code.
struct Vq2 {
  static constexpr std::size_t side = 2;  ///< regions a side of a vector
  static constexpr std::uint32_t bits = 256, index_bits = 3;

  std::array<std::uint8_t, 64> indices{};
  std::array<Transform, 4> transforms{};  ///< by quadrant; that of TL is not stored
  std::array<std::uint8_t, 3> shared{};
  std::array<std::array<std::uint8_t, 2>, 4> own{};  ///< by quadrant

  constexpr bool operator==(const Vq2&) const = default;

  /// The vector of an index in a quadrant, before the quadrant's transform.  Domain: index < 8.
  constexpr Vector<2> entry(Quadrant q, std::uint32_t index) const {
    if (index < 3) return uniform<2>(static_cast<State>(index));
    if (index < 6) return decode_mini(shared[index - 3]);
    return decode_mini(own[static_cast<std::size_t>(q)][index - 6]);
  }
};

/// The fields of a block of VQ4: 64 vectors of 4x4 regions, and a codebook of 13 beside the three uniform ones
/// (sections 4 and 5).
struct Vq4 {
  static constexpr std::size_t side = 4;
  static constexpr std::uint32_t bits = 512, index_bits = 4;

  std::array<std::uint8_t, 64> indices{};
  std::array<Transform, 4> transforms{};
  std::array<std::uint32_t, 13> codebook{};  ///< for the indices 3..15

  constexpr bool operator==(const Vq4&) const = default;

  /// The form of the code of an index (table 2).  Domain: index in 3..15.
  static constexpr Code4 code_of(std::uint32_t index) {
    return index < 6    ? Code4::simple
           : index == 6 ? Code4::vertical
           : index == 7 ? Code4::horizontal
                        : Code4::generic;
  }
  constexpr Vector<4> entry(Quadrant, std::uint32_t index) const {
    if (index < 3) return uniform<4>(static_cast<State>(index));
    return decode_vector(code_of(index), codebook[index - 3]);
  }
};

/// A map of 8 side x 8 side regions, (x, y) at x + 8 side y.
template <class Block>
using Map = std::array<State, 64 * Block::side * Block::side>;

template <class Block>
using BlockBytes = std::array<std::uint8_t, Block::bits / 8>;

// ---- Bits

/// Calls field(number of bits, a reference) for each field in the order of the bits.
template <class Fields, class Each>
constexpr void for_each_field(Fields& block, Each each) {
  for (auto& index : block.indices) each(std::remove_cvref_t<Fields>::index_bits, index);
  for (std::size_t q = 1; q < 4; ++q) each(3u, block.transforms[q]);
  if constexpr (requires { block.shared; }) {
    for (auto& code : block.shared) each(5u, code);
    for (auto& pair : block.own)
      for (auto& code : pair) each(5u, code);
  } else {
    for (std::uint32_t index = 3; index < 16; ++index)
      each(bits_of(std::remove_cvref_t<Fields>::code_of(index)), block.codebook[index - 3]);
  }
}

/// The bytes of a block.  Domain: every field fits its bits.
template <class Block>
constexpr BlockBytes<Block> bytes(const Block& block) {
  BlockBytes<Block> out{};
  std::uint32_t at = 0;
  for_each_field(block, [&](std::uint32_t bits, const auto& field) {
    std::uint32_t value = 0;
    if constexpr (requires { field.number(); })
      value = field.number();
    else
      value = field;
    for (std::uint32_t k = 0; k < bits; ++k, ++at)
      out[at / 8] = static_cast<std::uint8_t>(out[at / 8] | (value >> k & 1) << (at % 8));
  });
  return out;
}

/// The block of any bytes: each bit has a meaning.
template <class Block>
constexpr Block from_bytes(const BlockBytes<Block>& in) {
  Block block{};
  std::uint32_t at = 0;
  for_each_field(block, [&](std::uint32_t bits, auto& field) {
    std::uint32_t value = 0;
    for (std::uint32_t k = 0; k < bits; ++k, ++at) value |= (in[at / 8] >> (at % 8) & 1u) << k;
    if constexpr (requires { field.number(); })
      field = Transform::of(value);
    else
      field = static_cast<std::remove_reference_t<decltype(field)>>(value);
  });
  return block;
}

// ---- Decoding (figure 11)

/// The whole map: each vector is looked up, transformed and written.
template <class Block>
constexpr Map<Block> decode(const Block& block) {
  constexpr std::uint32_t side = Block::side;
  Map<Block> map{};
  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const std::uint32_t vx = vector % 8, vy = vector / 8;
    const Quadrant q = quadrant_of(vx, vy);
    const auto v =
        applied<side>(block.transforms[static_cast<std::size_t>(q)], block.entry(q, block.indices[vector]));
    for (std::uint32_t k = 0; k < side * side; ++k)
      map[vx * side + k % side + 8 * side * (vy * side + k / side)] = v[k];
  }
  return map;
}

/// One region: the high bits of its coordinates find the vector, and the low bits are transformed instead.
/// Domain: x and y below 8 side.
template <class Block>
constexpr State decode_region(const Block& block, Region r) {
  constexpr std::uint32_t side = Block::side;
  const Region vector{r.x / side, r.y / side};
  const Quadrant q = quadrant_of(vector.x, vector.y);
  const Region in =
      filled_from<side>(block.transforms[static_cast<std::size_t>(q)], {r.x % side, r.y % side});
  return block.entry(q, block.indices[vector.x + 8 * vector.y])[in.x + side * in.y];
}

}  // namespace mmverify::spec::vq
