// The error of a map against its texture: bounds on the exact error.
//
// The difference on a micro-triangle within a cell between four texel centres is of degree 2 on a convex polygon: its
// extremes are at corners, or on an edge where its derivative along the edge is 0; and its square integrates in closed
// form.
// Source: spec/attribute/error.hpp.  How: in binary64; a bound on the rounding is added.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "impl/attribute/bake.hpp"

namespace mmverify::impl::attribute {

/// The error of each channel, in numbers from 0 to 1: linear light on the sRGB curve, elsewhere code / 255.
struct MapError {
  std::array<double, 4> largest{};  ///< at least the largest |texture - map|, and at most 2^-20 above it
  std::array<double, 4> square{};   ///< the same bounds for the mean of (texture - map)^2 over the triangle
};

enum class MapForm : std::uint8_t { faces, vertices };

/// The error of a map against the texture sampled bilinearly, whatever the sampling's filter.  Faces are constant,
/// vertices interpolate linearly.  Normals' codes are compared as they are stored.
/// Domain: a map of `level`, faces on the curve, vertices in row order, as AttributeBaker writes them; the triangle as
/// for faces().
/// Errors: std::invalid_argument outside the domain.
/// Law: attribute.error_is_bound
MapError map_error(const RgbaView& texture, const AttributeSampling& sampling, const BaseTriangle& uv,
                   std::uint32_t level, MapForm form, std::span<const Rgba> map);

/// Replaces each odd value on a decimated edge by the mean of its two even neighbours, averaged as `meaning` says and
/// rounded half up: the values that such an edge shows.  Bits as in TrianglePlan.  Domain: vertices, in row order, of a
/// level in 1..max.
/// Errors: std::invalid_argument outside the domain.
/// Test: impl_attribute_bake_test
void decimate_edges(std::uint32_t level, std::uint8_t edges, Meaning meaning, std::span<Rgba> vertices);

}  // namespace mmverify::impl::attribute
