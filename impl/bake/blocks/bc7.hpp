// The alpha of BC7's blocks.  Internal to impl and scene.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace mmverify::impl::bake::blocks {

/// The 16 alphas of a BC7 block, row by row, of 255.
///   ((64 - w) e0 + w e1 + 32) / 64, rounded down, by the weight w of the texel's index and the ends e0, e1 of its subset
/// Modes 0 to 3 have no alpha and are opaque; the reserved mode is 0 everywhere.  Domain: 16 bytes, any.
/// Source: Khronos Data Format Specification 1.3, 22 (BPTC); exact there, without tolerance.
/// Test: pictures_test compares random blocks with what another decoder made of them.
std::array<std::uint8_t, 16> alpha_of_bc7(std::span<const unsigned char> block);

}  // namespace mmverify::impl::bake::blocks
