#include "scene/attribute/image_triangles.hpp"

#include <algorithm>

namespace mmverify::scene {

std::uint64_t ImageTriangles::texels_shown() const {
  return static_cast<std::uint64_t>(std::count(shown.begin(), shown.end(), 1));
}

ImageTriangles image_triangles(const AttributeScene& scene, std::size_t image,
                               std::span<const MapOfTriangle> all, const std::function<void()>& stop) {
  const ColourImage& texels = scene.images[image];
  ImageTriangles result;
  result.image = image;
  std::vector<Sampler> samplers;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const AttributeTexture& texture = scene.textures[all[k].texture];
    if (texture.image != image) continue;
    result.maps.push_back(k);
    result.corners.push_back(in_texels(all[k].uvs, texels.width, texels.height));
    samplers.push_back(texture.sampler);
  }
  result.first = first_triangles(texels, samplers, result.corners, stop);
  result.shown.resize(result.first.size());
  std::transform(result.first.begin(), result.first.end(), result.shown.begin(),
                 [](std::uint32_t triangle) { return std::uint8_t{triangle != no_triangle}; });
  return result;
}

}  // namespace mmverify::scene
