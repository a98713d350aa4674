// A texture's texels, and which triangle shows each.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "scene/attribute/baker.hpp"

namespace mmverify::scene {

/// The bounds of a triangle's box in texels; a triangle beyond them is left out, as MapBaker says: a wall
/// that repeats its texture a hundred times.
inline constexpr double most_texels_of_triangle = 0x1p24, longest_triangle = 0x1p15;
bool within_reach(const TexelTriangle& corners);
/// The same bounds for a triangle on an image, whose UVs must also be below 2^20.  Domain: UVs finite.
bool within_reach(const UvTriangle& uvs, const ColourImage& image);

/// The number of the texel (x, y), wrapped.  Domain: |x|, |y| < 2^40.
std::size_t wrapped_texel(const ColourImage& image, const Sampler& sampler, std::int64_t x, std::int64_t y);

/// The barycentrics of texels' centres on a triangle.
class TexelPlane {
 public:
  explicit TexelPlane(const TexelTriangle& t)
      : a_(t[0]),
        bx_(t[1][0] - t[0][0]),
        by_(t[1][1] - t[0][1]),
        cx_(t[2][0] - t[0][0]),
        cy_(t[2][1] - t[0][1]) {}
  double area() const { return bx_ * cy_ - cx_ * by_; }  ///< twice the triangle's area, with a sign
  /// Domain: area() not 0.
  std::array<double, 2> at(std::int64_t x, std::int64_t y) const {
    const double px = static_cast<double>(x) + 0.5 - a_[0], py = static_cast<double>(y) + 0.5 - a_[1];
    return {(px * cy_ - cx_ * py) / area(), (bx_ * py - px * by_) / area()};
  }

 private:
  std::array<double, 2> a_;
  double bx_, by_, cx_, cy_;
};

/// Calls visit(x, y, u, v) for each centre of a texel on the triangle, border included, before the texel is
/// wrapped; ends if it returns false.
/// Domain: within_reach(corners).  A triangle without area has no centres.
template <class Visit>
void for_each_centre(const TexelTriangle& corners, Visit visit);

/// Calls visit(texel, u, v) for each texel whose centre is on the triangle, border included, with the
/// centre's barycentrics.  It visits a texel again if the triangle repeats it.
/// Domain: within_reach(corners).  A triangle without area shows no texel.
template <class Visit>
void for_each_texel(const ColourImage& image, const Sampler& sampler, const TexelTriangle& corners,
                    Visit visit);

/// The number of a triangle that does not exist.
inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();
/// The first triangle that shows each texel; no_triangle if none does.
/// stop: called before each triangle, which may show millions of texels; may throw.
std::vector<std::uint32_t> first_triangles(const ColourImage& image, std::span<const Sampler> samplers,
                                           std::span<const TexelTriangle> triangles,
                                           const std::function<void()>& stop = {});

}  // namespace mmverify::scene

#include "scene/attribute/atlas-inl.hpp"
