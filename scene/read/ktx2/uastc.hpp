// Blocks of UASTC LDR 4x4.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace mmverify::scene {

using RgbaTexels = std::array<std::array<std::uint8_t, 4>, 16>;

/// The 16 texels of a UASTC block, row by row: red, green, blue, alpha of 255.
///   C = (((64 - w) CL + w CH + 32) / 64) / 256, each division rounded down,
/// with the weight w of the texel, 0 to 64, and the ends CL, CH of its subset, 8 bits e as 16:
///   e * 256 + 128 if the picture is sRGB, alpha included; else e * 257
/// Invalid blocks are (255, 0, 255, 255): those of the reserved mode, of a pattern beyond its table, or with
/// alpha and a multiplier of 0 for ETC2.  Domain: 16 bytes, any.
/// Source: Khronos Data Format Specification 1.4, 25 (UASTC); exact there, without tolerance.
/// Test: ktx2_test compares random blocks of each mode with what another decoder made of them.
RgbaTexels texels_of_uastc(std::span<const unsigned char> block, bool srgb);

}  // namespace mmverify::scene
