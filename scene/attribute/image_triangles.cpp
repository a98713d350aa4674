#include "scene/attribute/image_triangles.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "scene/attribute/texel_errors.hpp"

namespace mmverify::scene {
namespace {

/// Sorts the texels by their triangles, and finds the place where each texel is shown: the last one, if the
/// triangle repeats it.
void find_own(ImageTriangles& triangles, const ColourImage& image, std::span<const Sampler> samplers,
              const std::function<void()>& stop) {
  triangles.begin.assign(triangles.maps.size() + 1, 0);
  for (const std::uint32_t k : triangles.first)
    if (k != no_triangle) ++triangles.begin[k + 1];
  for (std::size_t k = 0; k < triangles.maps.size(); ++k) triangles.begin[k + 1] += triangles.begin[k];
  triangles.own.resize(triangles.begin.back());
  std::vector<std::size_t> next = triangles.begin;
  for (std::uint32_t texel = 0; texel < triangles.first.size(); ++texel)
    if (const std::uint32_t k = triangles.first[texel]; k != no_triangle) triangles.own[next[k]++] = texel;
  triangles.place.resize(triangles.first.size());
  oneapi::tbb::parallel_for(std::size_t{0}, triangles.maps.size(), [&](std::size_t k) {
    if (triangles.begin[k] == triangles.begin[k + 1]) return;
    if (stop) stop();
    for_each_centre(triangles.corners[k], [&](std::int64_t x, std::int64_t y, double, double) {
      const std::size_t texel = wrapped_texel(image, samplers[k], x, y);
      if (triangles.first[texel] == k)
        triangles.place[texel] = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
      return true;
    });
  });
}

}  // namespace

std::uint64_t ImageTriangles::texels_shown() const {
  return static_cast<std::uint64_t>(std::count(shown.begin(), shown.end(), 1));
}

ComparedImage compared_image(const SetTriangles& triangles, std::size_t image, Averaging averaging,
                             const std::function<void()>& stop) {
  const AttributeScene& scene = triangles.scene();
  const ColourImage& texels = scene.images[image];
  ImageTriangles result;
  result.image = image;
  std::vector<Sampler> samplers;
  for (std::size_t k = 0; k < triangles.all().size(); ++k) {
    const MapOfTriangle& map = triangles.all()[k];
    if (scene.textures[map.texture].image != image) continue;
    result.maps.push_back(k);
    result.corners.push_back(in_texels(map.uvs, texels.width, texels.height));
    samplers.push_back(triangles.sampler_of(k));
  }
  result.first = first_triangles(texels, samplers, result.corners, stop);
  result.shown.resize(result.first.size());
  std::transform(result.first.begin(), result.first.end(), result.shown.begin(),
                 [](std::uint32_t triangle) { return std::uint8_t{triangle != no_triangle}; });
  find_own(result, texels, samplers, stop);
  return {std::move(result), compared_texels(texels, triangles.set(), averaging)};
}

}  // namespace mmverify::scene
