// How far a map is from its texture: bounds on the exact error.
//
// Of each micro-triangle and each cell between four texel centres, the difference is of degree 2 on a convex polygon:
// its extremes are at corners and where it stands still along an edge, its square integrates in closed form.
// Source: spec/attribute/error.hpp.  How: in binary64, and what rounding may amount to is added.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "impl/attribute/bake.hpp"

namespace mmverify::impl::attribute {

/// Of each channel, in numbers from 0 to 1: linear light on the sRGB curve, elsewhere code / 255.
struct MapError {
  std::array<double, 4> largest{};  ///< not below the largest |texture - map|, and above it by 2^-20 at most
  std::array<double, 4> square{};   ///< not below the mean of its square over the triangle, the same
};

enum class MapForm : std::uint8_t { faces, vertices };

/// Of a map against the texture sampled bilinearly, whatever the sampling's filter; faces are constant, vertices linear
/// between.  Normals' codes are compared as they are stored.
/// Domain: the map is one of `level`, faces on the curve, vertices in row order, as AttributeBaker writes them; the
/// triangle as for faces.
/// Errors: std::invalid_argument where the domain does not hold.
MapError map_error(const RgbaView& texture, const AttributeSampling& sampling, const BaseTriangle& uv,
                   std::uint32_t level, MapForm form, std::span<const Rgba> map);

/// The map that decimated edges show: odd values on them are the mean of the two even ones beside, half up, in the
/// codes' own numbers.  Bits as of TrianglePlan.  Domain: vertices, in row order, of a level in 1..max.
/// Errors: std::invalid_argument where the domain does not hold.
void decimate_edges(std::uint32_t level, std::uint8_t edges, Meaning meaning, std::span<Rgba> vertices);

}  // namespace mmverify::impl::attribute
