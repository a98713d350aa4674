// A triangle on a texture: its corners in texels, and its shape.
#pragma once

#include <array>
#include <cstdint>

#include "scene/scene.hpp"

namespace mmverify::scene {

using UvTriangle = std::array<Uv, 3>;

/// Corners in texels; texel (x, y) is [x, x+1) x [y, y+1).
using TexelTriangle = std::array<std::array<double, 2>, 3>;

/// (u width, v height), exactly: 24 bits of a float32 times at most 15 of a side.
/// Domain: UVs finite; width, height in 1..16384.
TexelTriangle in_texels(const UvTriangle& uvs, std::uint32_t width, std::uint32_t height);

/// The span of the corners in UV: an area, a line or one point.  A micromap of a line or a point is as exact
/// as of an area.
enum class UvShape : std::uint8_t { area, line, point };

/// The shape by the exact sign of (b-a) x (c-a).  Domain: UVs finite.
UvShape uv_shape(const UvTriangle& uvs);

/// The finest level of the paper's tables and of our codecs.
inline constexpr unsigned finest_level = 12;

}  // namespace mmverify::scene
