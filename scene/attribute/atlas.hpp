// A texture's texels, and which triangle shows each.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// The box of a triangle's texels beyond which it is not looked at, as MapBaker says: a wall that repeats its texture a
/// hundred times.
inline constexpr double most_texels_of_triangle = 0x1p24, longest_triangle = 0x1p15;
bool within_reach(const TexelTriangle& corners);
/// The same of a triangle on an image; beyond are UVs of 2^20 and more, too.  Domain: UVs finite.
bool within_reach(const UvTriangle& uvs, const ColourImage& image);

/// The texel that (x, y) is, wrapped.  Domain: |x|, |y| < 2^40.
std::size_t wrapped_texel(const ColourImage& image, const Sampler& sampler, std::int64_t x, std::int64_t y);

/// Calls visit(texel, u, v) for each texel whose centre lies on the triangle, border included, by its barycentrics; a
/// texel more than once where the triangle repeats it.
/// Domain: within_reach(corners).  A triangle without area shows none.
template <class Visit>
void for_each_texel(const ColourImage& image, const Sampler& sampler, const TexelTriangle& corners,
                    Visit visit);

/// The first triangle that shows each texel; no_triangle where none does.
inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();
/// stop: asked before each triangle, which may show millions; may throw.
std::vector<std::uint32_t> first_triangles(const ColourImage& image, std::span<const Sampler> samplers,
                                           std::span<const TexelTriangle> triangles,
                                           const std::function<void()>& stop = {});

}  // namespace mmverify::scene

#include "scene/attribute/atlas-inl.hpp"
