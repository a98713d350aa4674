// The alpha test of a texture, stored as 1 or 2 bits for each texel.
#pragma once

#include <memory>

#include "display/render/opacity.hpp"
#include "display/render/world.hpp"

namespace mmverify::render {

/// A mask for each surface of a world, read at the texel whose square holds the hit.
///   states 4   2 bits: T (O) if every point of the closed square is transparent (opaque) by the surface's own filter,
///              else UT, and the texture decides.  So no hit is decided in another way than by the texture.
///   states 2   1 bit: the code of the texel against the cutoff, or against 1/2 for BLEND, without a filter
/// Bilinear alpha on a quarter of the square has its extremes at corners: the texel's centre, middles of sides, corners.
/// A triangle without a surface, or left out by the plan, has no mask.
/// Domain: states 2 or 4; the world outlives the result.
/// Source: Succinct Opacity Micromaps, 5 and tables 2 and 3.
/// Law: traverse.same_image (of 4 states)
std::unique_ptr<Opacity> bitmask_of(const World& world, unsigned states);

}  // namespace mmverify::render
