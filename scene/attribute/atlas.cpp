#include "scene/attribute/atlas.hpp"

#include <set>
#include <tuple>

#include "scene/bake/wrap.hpp"

namespace mmverify::scene {

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

bool within_reach(const UvTriangle& uvs, const ColourImage& image) {
  return std::all_of(uvs.begin(), uvs.end(),
                     [](const Uv& uv) { return std::abs(uv[0]) < 0x1p20f && std::abs(uv[1]) < 0x1p20f; }) &&
         within_reach(in_texels(uvs, image.width, image.height));
}

std::size_t wrapped_texel(const ColourImage& image, const Sampler& sampler, std::int64_t x, std::int64_t y) {
  using impl::bake::wrapped;
  return static_cast<std::size_t>(wrapped(wrap_of(sampler.wrap_u), x, image.width) +
                                  wrapped(wrap_of(sampler.wrap_v), y, image.height) * image.width);
}

std::vector<std::uint32_t> first_triangles(const ColourImage& image, std::span<const Sampler> samplers,
                                           std::span<const TexelTriangle> triangles,
                                           const std::function<void()>& stop) {
  std::vector<std::uint32_t> first(std::size_t{image.width} * image.height, no_triangle);
  std::size_t left = first.size();
  // A triangle at the place of an earlier one is the first to show no texel; a forest has thousands on few
  // places.
  std::set<std::tuple<TexelTriangle, Wrap, Wrap>> places;
  for (std::uint32_t k = 0; k < triangles.size() && left > 0; ++k) {
    if (stop) stop();
    if (!places.emplace(triangles[k], samplers[k].wrap_u, samplers[k].wrap_v).second) continue;
    for_each_texel(image, samplers[k], triangles[k], [&](std::size_t texel, double, double) {
      if (first[texel] != no_triangle) return;
      first[texel] = k;
      --left;
    });
  }
  return first;
}

}  // namespace mmverify::scene
