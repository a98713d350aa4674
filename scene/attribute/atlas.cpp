#include "scene/attribute/atlas.hpp"

namespace mmverify::scene {

std::uint64_t texels_of_box(const TexelTriangle& corners) {
  const auto length = [&](std::size_t axis) {
    const auto [least, most] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    return std::ceil(most) - std::floor(least);
  };
  const double texels = length(0) * length(1);
  return texels < 0x1p62 ? static_cast<std::uint64_t>(texels) : std::numeric_limits<std::uint64_t>::max();
}

std::vector<std::uint32_t> first_triangles(const ColourImage& image, std::span<const Sampler> samplers,
                                           std::span<const TexelTriangle> triangles) {
  std::vector<std::uint32_t> first(std::size_t{image.width} * image.height, no_triangle);
  for (std::uint32_t k = 0; k < triangles.size(); ++k)
    for_each_texel(image, samplers[k], triangles[k], [&](std::size_t texel, double, double) {
      if (first[texel] == no_triangle) first[texel] = k;
    });
  return first;
}

}  // namespace mmverify::scene
