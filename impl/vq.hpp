// VQ2: 16x16 regions in 256 bits, decoded at random or whole, and encoded with the fewest substitutions that
// the format allows.  Axes, codes and the order of the bits are those of spec/vq_block.hpp: x from the left,
// y from the bottom.
//
// Source: Compressed Opacity Maps, 4, 4.1 and 5.1, tables 1 and 2, figures 4 and 11.
#pragma once

#include <array>
#include <cstdint>

namespace mmverify::impl::vq {

/// Of one region: transparent, check the texture, opaque.
enum class State : std::uint8_t { T = 0, C = 1, O = 2 };

using Map2 = std::array<State, 256>;   ///< region (x, y) at x + 16 y
using Map4 = std::array<State, 1024>;  ///< region (x, y) at x + 32 y
using Block2 = std::array<std::uint8_t, 32>;
using Block4 = std::array<std::uint8_t, 64>;

/// The state of region (x, y) of a block; every block is one.  Domain: x and y below 16, or 32 of VQ4; their
/// low four, or five, bits count.
State region(const Block2& block, std::uint32_t x, std::uint32_t y) noexcept;
State region(const Block4& block, std::uint32_t x, std::uint32_t y) noexcept;

/// The map of a block.
Map2 decode(const Block2& block) noexcept;
Map4 decode(const Block4& block) noexcept;

struct Encoded2 {
  Block2 block;
  std::uint32_t substitutions;  ///< regions of O or T that became C
};

/// The block with the fewest substitutions of O or T by C over all transforms and codebooks; nothing else is
/// ever substituted.  Exact: every choice of the three shared vectors is tried or cannot be better, by a
/// bound on what two more can add.  Where O lies beside T within a vector, the vector keeps the one or the
/// other or neither. Domain: every map of T, C and O.
Encoded2 encode_optimal(const Map2& map);

}  // namespace mmverify::impl::vq
