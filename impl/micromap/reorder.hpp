// A micromap for the same triangle with its vertices in another order.
#pragma once

#include <array>

#include "impl/micromap/micromap.hpp"

namespace mmverify::impl::micromap {

/// An order of vertices: vertex k of one triangle is vertex order[k] of the other.
using VertexOrder = std::array<std::uint8_t, 3>;

/// Turns the map of a triangle into that of the triangle whose vertex k is its vertex order[k]: the same piece of the
/// surface has the same state.  Bits after the last state are zero.  Time: linear.
/// Domain: order a permutation of 0, 1, 2; level in 0..16; both spans packed_bytes(4^level, f) long and apart; else
/// std::invalid_argument.
/// Source: the curve's children and their corners, VK_KHR_opacity_micromap, "Reference Code"; see impl/index/index.hpp.
/// Test: scene_bake_test
void reorder(std::span<const std::uint8_t> map, Level level, Format f, const VertexOrder& order,
             std::span<std::uint8_t> out);

}  // namespace mmverify::impl::micromap
