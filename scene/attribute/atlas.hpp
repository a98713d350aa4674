// A texture's texels, and which triangle shows each.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// The box of a triangle's texels beyond which it is not looked at, as MapBaker says: a wall that repeats its texture a
/// hundred times.
inline constexpr double most_texels_of_triangle = 0x1p24, longest_triangle = 0x1p15;
bool within_reach(const TexelTriangle& corners);

/// The texel that (x, y) is, wrapped.  Domain: |x|, |y| < 2^40.
std::size_t wrapped_texel(const ColourImage& image, const Sampler& sampler, std::int64_t x, std::int64_t y);

/// Calls visit(x, y, u, v) for each texel (x, y), not wrapped, whose centre lies on the triangle, border included, by its
/// barycentrics.  Domain: within_reach(corners).  A triangle without area has none.
template <class Visit>
void for_each_centre(const TexelTriangle& corners, Visit visit);

/// A texel, by its number in the image, and where its centre lies in the triangle that shows it.
struct ShownTexel {
  std::uint32_t texel;
  double u, v;
};

/// By triangle, the texels that it is the first to show; each texel of the image once at most.
std::vector<std::vector<ShownTexel>> first_shown(const ColourImage& image, std::span<const Sampler> samplers,
                                                 std::span<const TexelTriangle> triangles);

}  // namespace mmverify::scene

#include "scene/attribute/atlas-inl.hpp"
