#include "scene/attribute/atlas.hpp"

namespace mmverify::scene {

namespace {

std::uint32_t wrapped(std::int64_t x, std::uint32_t side, Wrap wrap) {
  const std::int64_t n = side;
  if (x >= 0 && x < n) return static_cast<std::uint32_t>(x);
  if (wrap == Wrap::clamp_to_edge) return static_cast<std::uint32_t>(std::clamp<std::int64_t>(x, 0, n - 1));
  const std::int64_t period = wrap == Wrap::repeat ? n : 2 * n;
  const std::int64_t r = (x % period + period) % period;
  return static_cast<std::uint32_t>(r < n ? r : period - 1 - r);
}

}  // namespace

bool within_reach(const TexelTriangle& corners) {
  double box = 1;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [least, most] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    const double side = std::ceil(most) - std::floor(least) + 1;
    if (side > longest_triangle) return false;
    box *= side;
  }
  return box <= most_texels_of_triangle;
}

std::size_t wrapped_texel(const ColourImage& image, const Sampler& sampler, std::int64_t x, std::int64_t y) {
  return wrapped(x, image.width, sampler.wrap_u) +
         std::size_t{wrapped(y, image.height, sampler.wrap_v)} * image.width;
}

std::vector<std::vector<ShownTexel>> first_shown(const ColourImage& image, std::span<const Sampler> samplers,
                                                 std::span<const TexelTriangle> triangles) {
  std::vector<std::vector<ShownTexel>> all(triangles.size());
  std::vector<bool> shown(std::size_t{image.width} * image.height);
  for (std::size_t k = 0; k < triangles.size(); ++k)
    for_each_centre(triangles[k], [&](std::int64_t x, std::int64_t y, double u, double v) {
      const std::size_t texel = wrapped_texel(image, samplers[k], x, y);
      if (shown[texel]) return;
      shown[texel] = true;
      all[k].push_back({static_cast<std::uint32_t>(texel), u, v});
    });
  return all;
}

}  // namespace mmverify::scene
