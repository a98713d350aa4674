// Maps of a box of a texture (impl/bake/bake.hpp): the exact state of each of side x side regions, or of their
// halves.
//
// A region, or half, is O if alpha >= cutoff on all of it, edges included, T if alpha < cutoff on all of it, else C.
// So regions that share a point are never O and T.
//
// Axes: the map's y counts from the BOTTOM (impl/vq/vq.hpp), the texture's rows from the top. Region (0, 0) is
// the box's lower left; the region of column i and, from the top, row j is [x + width i/side, x + width
// (i+1)/side] and [y + height j/side, y + height (j+1)/side].
//
// Source: Compressed Opacity Maps, 3; the exact state of any polygon is in spec/bake/bake.hpp.
#pragma once

#include <cstdint>
#include <span>

#include "impl/bake/bake.hpp"
#include "impl/vq/vq.hpp"

namespace mmverify::impl::bake {

/// The largest number of regions along a side, for which all integers below stay in 64 bits.
inline constexpr std::uint32_t max_side = 256;

/// Writes the state of region (x, y) to states[x + side y].  Exact, in integers.
/// Domain: the box lies in the texture and is not empty; side in 1..max_side; states.size() = side^2.
/// Errors: std::invalid_argument outside the domain.
/// Test: impl_bake_test
void square_map(const AlphaView& texture, const Box& box, Cutoff cutoff, std::uint32_t side,
                std::span<vq::State> states);

/// Writes the states of the halves of regions, cut by the diagonal from upper left to lower right, as subdivision cuts
/// the triangles (0,0) (1,0) (0,1) and (1,1) (0,1) (1,0) of the map's unit square: for side = 2^n the 2 4^n
/// micro-triangles of both at level n.
///   states[2 (x + side y)] is the lower left half of region (x, y), and [... + 1] the upper right
/// Domain, errors: as square_map(), but states.size() = 2 side^2.
/// Test: impl_bake_test
void triangle_map(const AlphaView& texture, const Box& box, Cutoff cutoff, std::uint32_t side,
                  std::span<vq::State> states);

}  // namespace mmverify::impl::bake
