// VQ2 and VQ4: maps of 16x16 regions in 256 bits and of 32x32 in 512.  A block is decoded whole, or region by region.
// Each format has the paper's encoders.  VQ2 also has one with the fewest substitutions that the format allows; VQ4 has
// one with few, and one that proves a lower bound.  Axes, codes and the order of the bits are those of
// spec/vq/block.hpp: x from the left, y from the bottom.
//
// Source: Compressed Opacity Maps, 4, 4.1 and 5.1, tables 1 and 2, figures 4 and 11.
#pragma once

#include <array>
#include <cstdint>

namespace mmverify::impl::vq {

/// The state of one region: transparent, check the texture, opaque.
enum class State : std::uint8_t { T = 0, C = 1, O = 2 };

using Map2 = std::array<State, 256>;   ///< region (x, y) at x + 16 y
using Map4 = std::array<State, 1024>;  ///< region (x, y) at x + 32 y
using Block2 = std::array<std::uint8_t, 32>;
using Block4 = std::array<std::uint8_t, 64>;

/// The state of region (x, y) of a block.  Domain: every block; x and y below 16, or 32 for VQ4 (low bits count).
/// Law: vq2.region_is_map, vq4.region_is_map, vq2.no_other_bit, vq4.no_other_bit
State region(const Block2& block, std::uint32_t x, std::uint32_t y) noexcept;
State region(const Block4& block, std::uint32_t x, std::uint32_t y) noexcept;

/// The triangle of the pair: the lower has the corners (0,0), (1,0), (0,1) of the map's unit square, the upper (1,1),
/// (0,1), (1,0), each in the order of the barycentrics w, u, v.
enum class Half : std::uint8_t { lower, upper };

/// The state of a hit with these barycentrics: that of region (floor(s u), floor(s v)) with s regions along a side; in
/// the upper triangle 1-u and 1-v take the place of u and v.  Exact; the far edges belong to the last region.
/// Domain: u, v >= 0 and u + v <= 1; beyond them, and for NaN, some region's.
/// Test: impl_vq_hit_test
State state_at(const Block2& block, Half half, float u, float v) noexcept;
State state_at(const Block4& block, Half half, float u, float v) noexcept;

/// The map of a block.
/// Law: vq2.region_is_map, vq4.region_is_map, vq2.on_random_blocks, vq4.on_random_blocks
Map2 decode(const Block2& block) noexcept;
Map4 decode(const Block4& block) noexcept;

// The encoders.  All substitute C for some O and T, and nothing else: every other region stays the same.  If O and T
// meet in an aligned 2x2 of regions, a code can keep only one of them.
// Domain: every map of T, C and O.

/// A block of VQ2, and its loss.
struct Encoded2 {
  Block2 block;
  std::uint32_t substitutions;  ///< regions of O or T that became C
};

/// A block of VQ4, and its loss.
struct Encoded4 {
  Block4 block;
  std::uint32_t substitutions;
};

/// Algorithms 1 and 2 as they are printed, over all 512 transforms.  impl/vq/two/paper.cpp and impl/vq/four/paper.cpp
/// list the points that the print leaves open.
/// Law: vq2.conservative, vq4.conservative
Encoded2 encode_paper(const Map2& map);
Encoded4 encode_paper(const Map4& map);

/// Algorithm 1 as its authors probably meant it.  The print sorts vectors by their sums of C, the highest first, and
/// then takes the lowest; this encoder takes the highest, the frequent ones (among equal scores still the last).
/// Law: vq2.conservative
Encoded2 encode_paper_highest_first(const Map2& map);

/// Algorithm 2 as its authors probably meant it: the partition that stays all C takes none of the 13 entries, since
/// index 1 is all C.
/// Law: vq4.conservative
Encoded4 encode_paper_free_c(const Map4& map);

/// The block with the fewest substitutions over all transforms and codebooks.  Exact: every choice of the three shared
/// vectors is tried, or cannot be better by a bound on the gain of two more.
/// Law: vq2.optimum, vq2.conservative
Encoded2 encode_optimal(const Map2& map);

/// The effort of an encoder of VQ4; more is never worse.
enum class Effort : std::uint8_t { fast, balanced, thorough };

/// A block without substitutions if the format can hold the map, at any effort.  Else a block with few substitutions,
/// and never more than with less effort.
/// Law: vq4.conservative, vq4.lossless_when_it_fits, vq4.effort
Encoded4 encode(const Map4& map, Effort effort = Effort::balanced);

/// A block, and a bound on the best one.
struct Proved4 {
  Encoded4 encoded;
  std::uint32_t least;  ///< no block has fewer substitutions
};

/// A block of more than thorough effort, with a bound over every choice of transforms.  On continuous maps the loss and
/// the bound are mostly equal, which proves the block optimal.  Time: a tenth of a second a map; a minute for noise.
/// Law: vq4.bound
Proved4 encode_proved(const Map4& map);

/// The number of vectors with O and T in one 2x2 window, overlapping ones included: continuous alpha has none.
std::uint32_t discontinuous_vectors(const Map2& map);
std::uint32_t discontinuous_vectors(const Map4& map);

}  // namespace mmverify::impl::vq
