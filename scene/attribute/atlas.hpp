// A texture's texels, and which triangle shows each.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// The box of a triangle's texels beyond which it is not looked at: a wall that repeats its texture a hundred times.
inline constexpr std::uint64_t most_texels_of_triangle = std::uint64_t{1} << 24;

/// Calls visit(texel, u, v) for each texel whose centre lies on the triangle, border included, by its barycentrics; a
/// texel more than once where the triangle repeats it.
/// Domain: texels_of_box(corners) <= most_texels_of_triangle.  A triangle without area shows none.
template <class Visit>
void for_each_texel(const ColourImage& image, const Sampler& sampler, const TexelTriangle& corners,
                    Visit visit);

/// Texels of the box of a triangle; the greatest number where they are more than that.
std::uint64_t texels_of_box(const TexelTriangle& corners);

/// The first triangle that shows each texel; no_triangle where none does.
inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();
std::vector<std::uint32_t> first_triangles(const ColourImage& image, std::span<const Sampler> samplers,
                                           std::span<const TexelTriangle> triangles);

}  // namespace mmverify::scene

#include "scene/attribute/atlas-inl.hpp"
